#!/usr/bin/env python3
"""Each .cpp includes the header of its name first, so that compiling it shows that the header stands alone.

Run in the root of the repository, or with that as argument.
"""

import re

from source_files import end, root_of_arguments, texts

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
    files = texts(root_of_arguments())
    end(check(files), f"{len(files)} files: every header is the first include of the .cpp of its name")


if __name__ == "__main__":
    main()
