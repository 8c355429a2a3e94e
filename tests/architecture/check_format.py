#!/usr/bin/env python3
"""Formats all sources by clang-format; with --check only tells which are not formatted."""

import os
import pathlib
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

from source_files import sources


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    check_only = "--check" in sys.argv[1:]
    options = ["--dry-run", "-Werror"] if check_only else ["-i"]
    files = [str(path.relative_to(root)) for path in sources(root)]
    batches = [files[i:i + 16] for i in range(0, len(files), 16)]

    def run(batch):
        return subprocess.run(["clang-format", *options, *batch], cwd=root, text=True,
                              stderr=subprocess.PIPE, check=False)

    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        results = list(pool.map(run, batches))
    messages = "".join(result.stderr for result in results)
    wrong = sorted({line.split(":")[0] for line in messages.splitlines()
                    if "-Wclang-format-violations" in line})
    for name in wrong:
        print(f"{name}: not formatted (./dev format)")
    failed = any(result.returncode != 0 for result in results)
    if failed and not wrong:
        print(messages)
    print(f"{len(files)} files, {len(wrong)} not formatted")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
