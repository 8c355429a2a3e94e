#!/usr/bin/env python3
"""Rooms check their preconditions and invariants at run time, in release builds too.

Counts TF_CHECK (base/check.h) in the sources of each room. Fails when all rooms together, or one of them,
have fewer per 1,000 lines than the bounds below: a room that grows without checks is seen here. The rooms
that are in FEW are below the bound: they may not lose a check, and leave the list when they reach it.
With --table prints the count of each room.
"""

import pathlib
import re
import sys

from check_layers import ROOMS, rooms_of_formats

OF_ALL = 1.0  # checks per 1,000 lines of all rooms together
OF_A_ROOM = 2.0  # of each room, and never fewer than one
# room: how many checks it has, which are fewer than that.
FEW = {
    "mesh/graph": 0, "mesh/geometry": 3, "mesh/spacing": 3, "mesh/job_file": 0, "mesh/inspect": 0,
    "mesh/decompose": 4, "mesh/assimilation": 0, "mesh/cosmetics": 6, "mesh/recovery": 4, "mesh/filling": 3,
    "mesh/volume": 0, "mesh/assemble": 0, "mesh/formats/hdf5": 0, "mesh/formats/list": 0,
    "mesh/formats/FOLDER": 3, "mesh/formats/surfaces": 0,
    "mesh/formats/registry": 0, "mesh/quality": 0, "mesh/partition": 0, "mesh/render": 0, "proto": 0, "store": 1,
    "coordinator/views": 1, "coordinator": 0, "worker": 0, "pool": 0, "report": 0, "json": 0, "cli": 1,
}
FORMATS = "mesh/formats/FOLDER"  # all folders of formats together, so that a new one needs no line here
MACRO = "base/check.h"
NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)


def count(text):
    """How many checks the text of a file makes; comments and texts make none."""
    return len(re.findall(r"\bTF_CHECK\s*\(", NOT_CODE.sub("", text)))


def rooms_of(root):
    """room -> (lines, checks) of the files that lie in its folder."""
    found = {}
    formats = rooms_of_formats((root / "CMakeLists.txt").read_text(encoding="utf-8"))
    for room, folders in ({room: [room] for room in ROOMS} | {FORMATS: list(formats)}).items():
        files = [path for folder in folders for path in sorted((root / folder).glob("*"))
                 if path.suffix in (".h", ".cpp")]
        texts = [path.read_text() for path in files if path.relative_to(root).as_posix() != MACRO]
        found[room] = (sum(len(text.splitlines()) for text in texts), sum(count(text) for text in texts))
    return found


def check(rooms, few):
    """What is wrong with rooms as rooms_of() gives them, a line each."""
    wrong = []
    for room, (lines, checks) in rooms.items():
        found = f"{room}: {checks} run-time checks in {lines} lines"
        is_enough = checks >= max(1.0, OF_A_ROOM * lines / 1000)
        if room in few and is_enough:
            wrong.append(f"{found} are enough; take it out of FEW")
        elif room in few and checks < few[room]:
            wrong.append(f"{found}; it had {few[room]}")
        elif room not in few and not is_enough:
            wrong.append(f"{found}; at least one, and {OF_A_ROOM:g} per 1,000 lines")
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
    wrong = check(rooms, FEW)
    for line in wrong:
        print(line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
