#!/usr/bin/env python3
"""Every room checks its preconditions and invariants at run time, in release builds too.

Counts TF_CHECK (base/check.h) in the sources of each room, a folder of formats among them. Fails when all
rooms together, or one of them, have fewer per 1,000 lines than the bounds below: a room that grows without
checks is seen here. With --table prints the count of each room.
"""

import pathlib
import sys

from check_layers import ROOMS, rooms_of_formats
from source_files import SOURCES, count_in_code, end

OF_ALL = 6.0  # checks per 1,000 lines of all rooms together
OF_A_ROOM = 2.0  # of each room, and never fewer than one
MACRO = "base/check.h"


def count(text):
    """How many checks the text of a file makes; comments and texts make none."""
    return count_in_code(r"\bTF_CHECK\s*\(", text)


def rooms_of(root):
    """room -> (lines, checks) of the files that lie in its folder."""
    found = {}
    formats = rooms_of_formats((root / "CMakeLists.txt").read_text(encoding="utf-8"))
    for room in [*ROOMS, *formats]:
        files = [path for path in sorted((root / room).glob("*")) if path.suffix in SOURCES]
        texts = [path.read_text() for path in files if path.relative_to(root).as_posix() != MACRO]
        found[room] = (sum(len(text.splitlines()) for text in texts), sum(count(text) for text in texts))
    return found


def check(rooms):
    """What is wrong with rooms as rooms_of() gives them, a line each."""
    wrong = []
    for room, (lines, checks) in rooms.items():
        if checks < max(1.0, OF_A_ROOM * lines / 1000):
            wrong.append(f"{room}: {checks} run-time checks in {lines} lines; at least one, and {OF_A_ROOM:g} "
                         "per 1,000 lines")
    lines = sum(one for one, _ in rooms.values())
    checks = sum(one for _, one in rooms.values())
    if checks < OF_ALL * lines / 1000:
        wrong.append(f"all rooms: {checks} run-time checks in {lines} lines; at least {OF_ALL:g} per 1,000 lines")
    return wrong


def main():
    rooms = rooms_of(pathlib.Path("."))
    if "--table" in sys.argv[1:]:
        for room, (lines, checks) in rooms.items():
            print(f"{room:30} {lines:6} lines {checks:4} checks {1000 * checks / max(lines, 1):6.1f} per 1,000")
    end(check(rooms))


if __name__ == "__main__":
    main()
