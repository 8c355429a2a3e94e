#!/usr/bin/env python3
"""Each .cpp includes the header of its name first, so that compiling it shows that the header stands alone.

Run in the root of the repository, or with that as argument.
"""

import pathlib
import re
import sys

FOLDERS = ["base", "bench", "cli", "coordinator", "json", "mesh", "pool", "proto", "report", "store", "tests", "worker"]
INCLUDE = re.compile(r'^#include [<"]([^>"]+)', re.MULTILINE)


def check(files):
    """Complaints about files, {path: text}; empty when every header with a .cpp is what that includes first."""
    complaints = []
    for path in sorted(files):
        header = path.removesuffix(".cpp") + ".h"
        if path.endswith(".cpp") and header in files:
            first = INCLUDE.search(files[path])
            if not first or first[1] != header:
                complaints.append(f"{path}: the first include is to be {header}")
    return complaints


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    paths = [path for folder in FOLDERS for ending in ("*.h", "*.cpp") for path in (root / folder).rglob(ending)]
    files = {str(path.relative_to(root)): path.read_text() for path in paths}
    if not files:
        sys.exit(f"{root}: no sources")
    complaints = check(files)
    print("\n".join(complaints) or f"{len(files)} files: every header is the first include of the .cpp of its name")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
