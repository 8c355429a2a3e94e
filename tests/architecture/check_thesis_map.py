#!/usr/bin/env python3
"""Every path that docs/thesis_map.md, README.md and ARCHITECTURE.md name is there.

A path is what stands in a link, or in backquotes with a slash and begins with a folder of the
repository or ends as a source does. What is built (`build/`, `out/`) is left out.
`a/b.h` also stands for b.cpp; `a/b.*` for any ending; a folder ends with a slash. Argument: the root
of the repository.
"""

import re

from source_files import end, root_of_arguments

QUOTED = re.compile(r"`([A-Za-z0-9_./*-]+)`|\]\(([A-Za-z0-9_./-]+)\)")


SOURCES = (".h", ".cpp", ".py", ".sh", ".proto", ".cmake")


def is_path(text, folders):
    first = text.split("/")[0]
    return "/" in text and (first in folders or text.endswith(SOURCES))


def main():
    root = root_of_arguments()
    folders = {path.name for path in root.iterdir() if path.is_dir()} - {"build", "out"}
    missing, count = [], 0
    for name in ("docs/thesis_map.md", "README.md", "ARCHITECTURE.md"):
        if not (root / name).is_file():
            missing.append(f"{name} is missing")
            continue
        for quoted, linked in QUOTED.findall((root / name).read_text(encoding="utf-8")):
            if linked:
                found = ((root / name).parent / linked).exists()
            elif is_path(quoted, folders):
                found = any(root.glob(quoted.rstrip("/")))
            else:
                continue
            count += 1
            if not found:
                missing.append(f"{name}: there is no {quoted or linked}")
    if count == 0:
        missing.append(f"{root}: no paths are named")
    end(missing, f"{count} paths, {len(missing)} of them missing")


if __name__ == "__main__":
    main()
