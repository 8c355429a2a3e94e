#!/usr/bin/env python3
"""Who may look into whom: the layers of the rooms, checked on every #include.

Fails on an include that the table does not name, on a room that the table names and no file of the
room includes, on a circle of rooms or of headers, on a folder with sources that the table does not
know, and when CMakeLists.txt links other rooms than the table says. Run in the root of the repository, or with that as argument.
"""

import re

from source_files import OUTSIDE, end, root_of_arguments, texts

# room: the rooms that its files include, and no others.
ROOMS = {
    "base": [],
    "mesh/core": ["base"],
    "mesh/graph": ["base"],
    "mesh/geometry": ["base", "mesh/core"],
    "mesh/spacing": ["base", "mesh/core", "mesh/geometry"],
    "mesh/formats/list": ["base"],
    "mesh/job_file": ["base", "mesh/core", "mesh/formats/list"],
    "mesh/artifacts": ["base", "mesh/core"],
    "mesh/shapes": ["base", "mesh/core"],
    "mesh/inspect": ["base", "mesh/core", "mesh/geometry", "mesh/shapes"],
    "mesh/planar": ["base", "mesh/geometry"],
    "mesh/metric": ["base", "mesh/geometry"],
    "mesh/adaptation": ["base", "mesh/core", "mesh/geometry", "mesh/metric", "mesh/planar"],
    "mesh/decompose": ["base", "mesh/core", "mesh/geometry", "mesh/planar", "mesh/spacing"],
    "mesh/assimilation": ["base", "mesh/core", "mesh/graph"],
    "mesh/cosmetics": ["base", "mesh/core", "mesh/geometry"],
    "mesh/recovery": ["base", "mesh/core", "mesh/geometry"],
    "mesh/filling": ["base", "mesh/core", "mesh/geometry", "mesh/spacing"],
    "mesh/volume": ["base", "mesh/core", "mesh/cosmetics", "mesh/filling", "mesh/geometry", "mesh/recovery",
                    "mesh/spacing"],
    "mesh/layers": ["base", "mesh/artifacts", "mesh/core", "mesh/geometry", "mesh/inspect", "mesh/planar"],
    "mesh/half_body": ["base", "mesh/core", "mesh/geometry", "mesh/inspect", "mesh/planar"],
    "mesh/arrangement": ["base", "mesh/core", "mesh/geometry"],
    "mesh/healing": ["base", "mesh/arrangement", "mesh/core", "mesh/geometry", "mesh/inspect"],
    "mesh/remeshing": ["base", "mesh/core", "mesh/geometry", "mesh/inspect", "mesh/spacing"],
    "mesh/library": ["base", "mesh/core", "mesh/decompose", "mesh/inspect", "mesh/spacing", "mesh/volume"],
    "mesh/assemble": ["base", "mesh/artifacts", "mesh/core"],
    "mesh/formats": ["base", "mesh/assemble", "mesh/core", "mesh/geometry"],
    "mesh/formats/hdf5": ["base"],
    "mesh/formats/surfaces": ["base", "mesh/core", "mesh/formats", "mesh/formats/list"],
    "mesh/formats/registry": ["base", "mesh/assemble", "mesh/core", "mesh/formats", "mesh/formats/list",
                              "mesh/formats/ugrid", "mesh/formats/vtkhdf"],
    "mesh/formats/plane": ["base", "mesh/formats", "mesh/formats/cgns", "mesh/formats/medit", "mesh/formats/msh",
                           "mesh/formats/openfoam", "mesh/formats/su2", "mesh/geometry", "mesh/metric", "mesh/planar"],
    "mesh/quality": ["base", "mesh/assemble", "mesh/core", "mesh/formats"],
    "mesh/partition": ["base", "mesh/assemble", "mesh/core", "mesh/formats", "mesh/geometry", "mesh/graph"],
    "mesh/render": ["base", "mesh/assemble", "mesh/core", "mesh/geometry", "mesh/metric", "mesh/planar"],
    "tasks": ["base"],
    "proto": ["base"],
    "http": ["base", "proto"],
    "store": ["base", "tasks"],
    "coordinator/decisions": ["base", "proto", "store", "tasks"],
    "coordinator/views": ["base", "coordinator/decisions", "http", "proto", "store", "tasks"],
    "coordinator": ["base", "coordinator/decisions", "coordinator/views", "mesh/job_file", "proto", "store",
                    "tasks"],
    "worker/decisions": ["base", "proto", "tasks"],
    "worker": ["base", "mesh/adaptation", "mesh/artifacts", "mesh/assemble", "mesh/assimilation", "mesh/core",
               "mesh/cosmetics", "mesh/decompose", "mesh/formats", "mesh/formats/off", "mesh/formats/plane",
               "mesh/formats/surfaces", "mesh/formats/ugrid", "mesh/formats/vtkhdf", "mesh/half_body", "mesh/inspect", "mesh/job_file",
               "mesh/layers", "mesh/library", "mesh/remeshing", "mesh/spacing", "proto", "store", "tasks",
               "worker/decisions"],
    "pool": ["base"],
    "report": ["base", "mesh/assemble", "mesh/core", "mesh/geometry", "mesh/quality", "mesh/render", "proto", "tasks"],
    "json": ["base", "mesh/assemble", "mesh/core", "mesh/inspect", "proto", "tasks"],
    "dashboard": ["base", "http", "json", "mesh/artifacts", "mesh/core", "mesh/inspect", "proto"],
    "cli": ["base", "coordinator", "coordinator/views", "dashboard", "json", "mesh/adaptation", "mesh/core", "mesh/decompose",
            "mesh/formats", "mesh/formats/flite", "mesh/formats/list", "mesh/formats/plane",
            "mesh/formats/registry", "mesh/formats/surfaces", "mesh/healing", "mesh/inspect", "mesh/job_file", "mesh/layers",
            "mesh/metric", "mesh/partition",
            "mesh/quality", "mesh/remeshing", "mesh/render", "mesh/shapes", "mesh/spacing", "pool", "proto", "report", "store",
            "tasks", "worker"],
}

# What a folder of formats may use, whether it does or not. Besides, each may use what its line
# add_format(FOLDER ROOM...) in CMakeLists.txt names, and must. A line is enough for a new folder.
FOR_FORMATS = ["base", "mesh/core", "mesh/artifacts", "mesh/assemble", "mesh/formats", "mesh/formats/list"]

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
ADD_ROOM = re.compile(r"^add_room\(([^)]*)\)", re.MULTILINE)
ADD_FORMAT = re.compile(r"^add_format\(([^)]*)\)", re.MULTILINE)
FOR_FORMATS_IN_CMAKE = re.compile(r"^set\(rooms_for_formats ([^)]*)\)", re.MULTILINE)


def has_circle_through(room, rooms):
    """Whether the table leads from the room back to itself."""
    reached, waiting = set(), list(rooms[room])
    while waiting:
        here = waiting.pop()
        if here not in reached:
            reached.add(here)
            waiting.extend(rooms.get(here, []))
    return room in reached


def rooms_of_formats(cmake_text):
    """The rooms that the lines add_format make, each with what its line names."""
    return {f"mesh/formats/{words[0]}": words[1:] for words in map(str.split, ADD_FORMAT.findall(cmake_text))}


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
    table, formats = rooms, rooms_of_formats(cmake_text)
    rooms = table | {room: FOR_FORMATS + named for room, named in formats.items()}
    unknown = sorted({there for named in rooms.values() for there in named} - set(rooms)) if cmake_text else []
    if unknown:
        return [f"{there} is named as a room and is none" for there in unknown]
    errors = [f"the table of rooms has a circle through {room}" for room in rooms
              if has_circle_through(room, rooms)]
    if errors:
        return errors
    includes = {}
    used = {room: set() for room in rooms}
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
            elif there != room and there not in rooms[room]:
                errors.append(f'{path}: {room} may not include "{target}" of {there}')
            used[room].add(there)
    for room, named in rooms.items():
        if any(room_of(path, rooms) == room for path in files):
            errors.extend(f"{room} includes nothing of {there}, which the table lets it"
                          for there in formats.get(room, named) if there not in used[room])
    for circle in header_circles(includes):
        errors.append("headers in a circle: " + " -> ".join(circle))
    if cmake_text:
        linked = {words[0]: words[1:] for words in map(str.split, ADD_ROOM.findall(cmake_text))}
        for room in sorted(set(table) | set(linked)):
            if linked.get(room) != table.get(room):
                errors.append(f"CMakeLists.txt: add_room({room}) has {linked.get(room)}, "
                              f"the table has {table.get(room)}")
    return errors


def main():
    root = root_of_arguments()
    files = texts(root)
    errors = check(files, ROOMS, (root / "CMakeLists.txt").read_text(encoding="utf-8"))
    linked = FOR_FORMATS_IN_CMAKE.findall((root / "cmake/rooms.cmake").read_text(encoding="utf-8"))
    if [words.split() for words in linked] != [FOR_FORMATS]:
        errors.append(f"cmake/rooms.cmake: rooms_for_formats are {linked}, here they are {FOR_FORMATS}")
    if not any(path.startswith("mesh/") for path in files):
        errors.append(f"{root} has no sources of mesh/")
    end(errors, f"{len(files)} files, {len(errors)} violations of the layers")


if __name__ == "__main__":
    main()
