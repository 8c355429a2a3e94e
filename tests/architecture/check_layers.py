#!/usr/bin/env python3
"""Who may look into whom: the layers of the rooms, checked on every #include.

Fails on an include that the table does not allow, on a circle of headers, on a room or a folder
with sources that the table does not know, and when CMakeLists.txt links other rooms than the table
says. Run in the root of the repository, or with that as argument.
"""

import pathlib
import re
import sys

# room: the rooms that it may include, and through them those that they may.
ROOMS = {
    "base": [],
    "mesh/core": ["base"],
    "mesh/graph": ["base"],
    "mesh/geometry": ["mesh/core"],
    "mesh/spacing": ["mesh/geometry"],
    "mesh/io": ["mesh/core"],
    "mesh/shapes": ["mesh/core"],
    "mesh/inspect": ["mesh/geometry", "mesh/shapes"],
    "mesh/planar": ["mesh/spacing"],
    "mesh/decompose": ["mesh/planar", "mesh/graph"],
    "mesh/cosmetics": ["mesh/geometry"],
    "mesh/volume": ["mesh/spacing", "mesh/cosmetics"],
    "mesh/library": ["mesh/inspect", "mesh/decompose", "mesh/volume"],
    "mesh/assemble": ["mesh/io"],
    "mesh/formats": ["mesh/assemble"],
    "mesh/figures": ["mesh/formats"],
    "mesh/check": ["mesh/formats"],
    "mesh/numbering": ["mesh/formats", "mesh/geometry"],
    "mesh/partition": ["mesh/formats", "mesh/graph"],
    "mesh/render": ["mesh/assemble"],
    "proto": ["base"],
    "store": ["base"],
    "coordinator": ["proto", "store", "mesh/io"],
    "worker": ["proto", "store", "mesh/library", "mesh/assemble"],
    "pool": ["base"],
    "report": ["proto", "mesh/figures", "mesh/render"],
    "cli": ["coordinator", "worker", "pool", "mesh/partition", "mesh/numbering", "mesh/check", "report"],
}

# They see every room, and no room sees them.
OUTSIDE = {"tests", "bench", "examples"}

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
ADD_ROOM = re.compile(r"^add_room\(([^)]*)\)", re.MULTILINE)


def visible_rooms(room, rooms):
    """The room itself and all that it may include, directly or not. None when the table has a circle."""
    done, open_rooms = set(), []

    def visit(here):
        if here in open_rooms:
            return False
        if here in done:
            return True
        open_rooms.append(here)
        fine = all(visit(there) for there in rooms[here])
        open_rooms.pop()
        done.add(here)
        return fine

    return done if visit(room) else None


def room_of(path, rooms):
    return path.rpartition("/")[0] if path.rpartition("/")[0] in rooms else None


def header_circles(includes):
    """Circles among headers, each as the list of its files."""
    circles, state = [], {}

    def visit(here, way):
        state[here] = "open"
        for there in includes.get(here, []):
            if state.get(there) == "open":
                circles.append(way[way.index(there):] + [there])
            elif there not in state and there in includes:
                visit(there, way + [there])
        state[here] = "done"

    for path in sorted(includes):
        if path not in state:
            visit(path, [path])
    return circles


def check(files, rooms, cmake_text=""):
    """The violations, a line each. `files`: path in the repository -> text."""
    errors = []
    visible = {}
    for room in rooms:
        visible[room] = visible_rooms(room, rooms)
        if visible[room] is None:
            errors.append(f"the table of rooms has a circle through {room}")
    if errors:
        return errors
    includes = {}
    for path, text in sorted(files.items()):
        includes[path] = INCLUDE.findall(text)
        if path.split("/")[0] in OUTSIDE:
            continue
        room = room_of(path, rooms)
        if room is None:
            errors.append(f"{path}: the folder is no room of the table in {__file__}")
            continue
        for target in includes[path]:
            there = room_of(target, rooms)
            if there is None:
                errors.append(f'{path}: "{target}" is in no room')
            elif there not in visible[room]:
                errors.append(f'{path}: {room} may not include "{target}" of {there}')
    for circle in header_circles(includes):
        errors.append("headers in a circle: " + " -> ".join(circle))
    if cmake_text:
        linked = {words[0]: words[1:] for words in map(str.split, ADD_ROOM.findall(cmake_text))}
        for room in sorted(set(rooms) | set(linked)):
            if linked.get(room) != rooms.get(room):
                errors.append(f"CMakeLists.txt: add_room({room}) has {linked.get(room)}, "
                              f"the table has {rooms.get(room)}")
    return errors


def sources(root):
    hidden = {"build", "out"}
    for path in sorted(root.rglob("*")):
        parts = path.relative_to(root).parts
        if parts[0] in hidden or parts[0].startswith("."):
            continue
        if path.suffix in (".h", ".cpp") and path.is_file():
            yield path


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    files = {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
             for path in sources(root)}
    errors = check(files, ROOMS, (root / "CMakeLists.txt").read_text(encoding="utf-8"))
    if not any(path.startswith("mesh/") for path in files):
        errors.append(f"{root} has no sources of mesh/")
    for error in errors:
        print(error)
    print(f"{len(files)} files, {len(errors)} violations of the layers")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
