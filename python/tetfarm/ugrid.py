"""UGRID (AFLR3/NASA), binary with 64-bit coordinates, of either order of bytes and either size of integers.

Layout: docs/file_formats.md. The counts are held against the length of the file before memory is taken.
"""

from __future__ import annotations

from pathlib import Path
from typing import List, Tuple

import numpy as np

from .errors import MeshFileError
from .meshes import Mesh

_CELLS = (("tets", 4), ("pyramids", 5), ("prisms", 6), ("hexes", 8))
# Where our nodes stand in theirs: the base of a pyramid is their 1, 4, 5, 2 and its apex their 3.
_PYRAMID = [0, 3, 4, 1, 2]
_LARGEST_TEXT = 1 << 24
_MOST_REGIONS = 1_000_000


class _Reader:
    """Takes arrays from a file, one after the other."""

    def __init__(self, path: Path, order: str, integer_size: int) -> None:
        self.path = path
        self._integer = np.dtype(f"{order}i{integer_size}")
        self._real = np.dtype(f"{order}f8")
        self._file = open(path, "rb")
        self.size = path.stat().st_size

    def close(self) -> None:
        self._file.close()

    def fail(self, what: str) -> MeshFileError:
        return MeshFileError(f"{self.path}: {what}")

    def _take(self, kind: np.dtype, count: int, into: np.dtype) -> np.ndarray:
        values = np.fromfile(self._file, dtype=kind, count=count)
        if len(values) != count:
            raise self.fail("the file ends early")
        return values.astype(into, copy=False)

    def counts(self) -> List[int]:
        if self.size < 7 * self._integer.itemsize:
            raise self.fail("the file is too short for its counts")
        counts = [int(count) for count in self._take(self._integer, 7, np.dtype(np.int64))]
        if min(counts) < 0:
            raise self.fail("a count is negative")
        nodes, triangles, quads, *cells = counts
        numbers = 7 + 4 * triangles + 5 * quads + sum(count * n for count, (_, n) in zip(cells, _CELLS))
        if self.size != 24 * nodes + self._integer.itemsize * numbers:
            raise self.fail("the length of the file does not match its counts")
        return counts

    def points(self, count: int) -> np.ndarray:
        return self._take(self._real, 3 * count, np.dtype(np.float64)).reshape(count, 3)

    def integers(self, count: int) -> np.ndarray:
        return self._take(self._integer, count, self._integer.newbyteorder("="))

    def elements(self, what: str, count: int, size: int, nodes: int) -> np.ndarray:
        found = self.integers(count * size).reshape(count, size)
        if count and (found.min() < 1 or found.max() > nodes):
            raise self.fail(f"one of the {what} has a node that does not exist")
        found -= 1
        return found


def _lines_beside(path: Path, ending: str) -> List[List[str]]:
    """NAME.mapbc beside NAME.b8.ugrid, in words, of which the last has the rest of the line; empty where there is none."""
    beside = path.with_name(path.name.rsplit(".", 2)[0] + ending)
    if not beside.is_file():
        return []
    if beside.stat().st_size > _LARGEST_TEXT:
        raise MeshFileError(f"{beside}: more than {_LARGEST_TEXT} bytes")
    text = beside.read_text(encoding="utf-8", errors="replace")
    return [line.split(None, 2 if ending == ".mapbc" else 3) for line in text.splitlines() if line.strip()]


def _patch_names(path: Path) -> List[str]:
    return [words[2].strip() for words in _lines_beside(path, ".mapbc")[1:] if len(words) == 3]


def _regions(path: Path, counts: List[int]) -> "Tuple[np.ndarray, List[str]]":
    """The region of each cell, as the file lists them, and the names of the regions."""
    cells = sum(counts)
    of_cell = np.ones(cells, np.int32)
    names: List[str] = []
    expected = 1
    for words in _lines_beside(path, ".regions"):
        try:
            number, first, last = (int(word) for word in words[:3])
        except ValueError as error:
            raise MeshFileError(f"{path}: a line of its .regions is not NUMBER FIRST LAST NAME") from error
        if not (1 <= number <= _MOST_REGIONS and first == expected and first - 1 <= last <= cells):
            raise MeshFileError(f"{path}: a line of its .regions does not match the mesh: {' '.join(words)}")
        of_cell[first - 1:last] = number
        names.extend([""] * (number - len(names)))
        names[number - 1] = words[3].strip() if len(words) > 3 else ""
        expected = last + 1
    if names and expected != cells + 1:
        raise MeshFileError(f"{path}: the lines of its .regions do not cover all cells")
    return of_cell, names or ["domain"]


def _enclosed(points: np.ndarray, triangles: np.ndarray, quads: np.ndarray) -> float:
    """Six times the volume, positive where normals point out."""
    total = 0.0
    for faces in (triangles, quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]):
        a, b, c = (points[faces[:, k]] for k in range(3))
        total += float(np.einsum("ij,ij->", a, np.cross(b, c)))
    return total


def read_ugrid(path: Path, order: str, integer_size: int) -> Mesh:
    """@see meshes.read_mesh"""
    reader = _Reader(path, order, integer_size)
    try:
        nodes, triangle_count, quad_count, *cell_counts = reader.counts()
        points = reader.points(nodes)
        triangles = reader.elements("boundary triangles", triangle_count, 3, nodes)
        quads = reader.elements("boundary quads", quad_count, 4, nodes)
        patches = np.clip(reader.integers(triangle_count + quad_count), 0, (1 << 31) - 1).astype(np.int32) - 1
        cells = {name: reader.elements(name, count, size, nodes)
                 for count, (name, size) in zip(cell_counts, _CELLS)}
    finally:
        reader.close()
    cells["pyramids"] = cells["pyramids"][:, np.argsort(_PYRAMID)]
    if _enclosed(points, triangles, quads) < 0:  # as the format has it
        triangles, quads = triangles[:, [0, 2, 1]], quads[:, [0, 3, 2, 1]]
    regions, region_names = _regions(path, cell_counts)
    ends = np.cumsum(cell_counts)[:-1]
    return Mesh(points=points, triangles=triangles, triangle_patches=patches[:triangle_count], quads=quads,
                quad_patches=patches[triangle_count:], patch_names=_patch_names(path),
                regions=dict(zip(cells, np.split(regions, ends))), region_names=region_names, **cells)
