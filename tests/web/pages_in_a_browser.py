#!/usr/bin/env python3
"""The dashboard's pages in a browser, with a made-up farm: every page and act, 100,000 tasks, hostile names, keys alone.

pages_in_a_browser.py WEB: the folder in which npm has built web/. Ends with 77 where there is no browser, but fails in
continuous integration.
"""

import os
import subprocess
import sys

CHROMIUM = os.environ.get("TETFARM_CHROMIUM", "/usr/bin/chromium")


def main(web):
    if not os.access(CHROMIUM, os.X_OK):
        print(f"no browser at {CHROMIUM}")
        return 1 if os.environ.get("CI") else 77
    return subprocess.run(["node", "tests/browser.mjs"], cwd=web, timeout=550).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
