"""VTKHDF with an UnstructuredGrid: its partitions joined by GlobalNodeId. The only file here that knows h5py.

HDF5 itself may crash on a file that is damaged: read what you trust.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List

import numpy as np

from .errors import MeshFileError, MissingLibraryError
from .meshes import Mesh

# VTK's code of a type, its nodes, and where our nodes stand in theirs.
_TYPES = {"triangles": (5, [0, 1, 2]), "quads": (9, [0, 1, 2, 3]), "tets": (10, [0, 1, 2, 3]),
          "pyramids": (14, [0, 1, 2, 3, 4]), "prisms": (13, [0, 2, 1, 3, 5, 4]), "hexes": (12, list(range(8)))}
_FACES = ("triangles", "quads")
# What deflate can come to, and a little for files that are nearly empty.
_MOST_PACKED = 1100
_SMALL = 1 << 20


def _require_h5py():
    try:
        import h5py
    except ImportError as error:
        raise MissingLibraryError(
            "VTKHDF is read with h5py, which is not there",
            help="apt-get install python3-h5py, or pip install h5py; or have the mesh written with format='lb8.ugrid', "
                 "which is read with numpy alone") from error
    return h5py


class _File:
    """The arrays of an open file, and their lengths held against what they say of each other."""

    def __init__(self, path: Path, file: Any, h5py: Any) -> None:
        self.path, self._file, self._h5py = path, file, h5py
        self._size = path.stat().st_size
        kind = file["VTKHDF"].attrs.get("Type", b"") if self._is_group("VTKHDF") else b""
        if (kind.decode("ascii", "replace") if isinstance(kind, bytes) else str(kind)) != "UnstructuredGrid":
            raise self.fail("is not a VTKHDF file of type UnstructuredGrid")

    def fail(self, what: str) -> MeshFileError:
        return MeshFileError(f"{self.path}: {what}")

    def _is_group(self, name: str) -> bool:
        return isinstance(self._file.get(name), self._h5py.Group)

    def array(self, name: str, rows: int, columns: int = 1) -> Any:
        """A dataset of numbers of so many rows."""
        found = self.maybe(name, rows, columns)
        if found is None:
            raise self.fail(f"has no {name}")
        return found

    def maybe(self, name: str, rows: int, columns: int = 1) -> Any:
        found = self._file.get(name)
        if not isinstance(found, self._h5py.Dataset):
            return None
        shape = (rows,) if columns == 1 else (rows, columns)
        if found.dtype.kind not in "iuf" or found.shape != shape:
            raise self.fail(f"{name} does not have the shape of such an array")
        if rows * columns * found.dtype.itemsize > _MOST_PACKED * self._size + _SMALL:
            raise self.fail(f"{name} cannot be in a file of {self._size} bytes")
        return found

    def counts(self, name: str) -> np.ndarray:
        """A number for each partition."""
        found = self._file.get(name)
        if not isinstance(found, self._h5py.Dataset) or len(found.shape) != 1 or found.shape[0] > 1 << 24:
            raise self.fail(f"has no {name}")
        values = self.array(name, found.shape[0])[:].astype(np.int64)
        if len(values) and (values.min() < 0 or values.max() > 1 << 40):
            raise self.fail(f"{name} has a wrong number")
        return values

    def texts(self, name: str) -> List[str]:
        found = self._file.get(name)
        if not isinstance(found, self._h5py.Dataset) or found.dtype.kind != "S" or len(found.shape) != 1:
            return []
        if found.shape[0] * found.dtype.itemsize > _MOST_PACKED * self._size + _SMALL:
            raise self.fail(f"{name} cannot be in a file of {self._size} bytes")
        return [text.decode("utf-8", "replace") for text in found[:]]


class _Joined:
    """What the partitions that were read have come to."""

    def __init__(self) -> None:
        self.elements: Dict[str, List[np.ndarray]] = {name: [] for name in _TYPES}
        self.told: Dict[str, List[np.ndarray]] = {name: [] for name in _TYPES}
        """The patches of faces, the regions of cells."""

    def add(self, name: str, elements: np.ndarray, told: np.ndarray) -> None:
        self.elements[name].append(elements)
        self.told[name].append(told)

    def all_elements(self, name: str, dtype: Any) -> np.ndarray:
        parts = self.elements[name]
        return np.concatenate(parts).astype(dtype, copy=False) if parts else np.empty((0, len(_TYPES[name][1])), dtype)

    def all_told(self, name: str) -> np.ndarray:
        return np.concatenate(self.told[name]) if self.told[name] else np.empty(0, np.int32)


class _Partitions:
    """Reads one partition after the other."""

    def __init__(self, file: _File) -> None:
        self.file = file
        self.points = file.counts("VTKHDF/NumberOfPoints")
        self.cells = file.counts("VTKHDF/NumberOfCells")
        self.ids = file.counts("VTKHDF/NumberOfConnectivityIds")
        if not len(self.points) == len(self.cells) == len(self.ids):
            raise file.fail("the numbers of points and of cells have different numbers of partitions")
        points, cells, ids = (int(counts.sum()) for counts in (self.points, self.cells, self.ids))
        self._points = file.array("VTKHDF/Points", points, 3)
        self._connectivity = file.array("VTKHDF/Connectivity", ids)
        self._offsets = file.array("VTKHDF/Offsets", cells + len(self.cells))
        self._types = file.array("VTKHDF/Types", cells)
        self._patches = file.maybe("VTKHDF/CellData/patch", cells)
        self._regions = file.maybe("VTKHDF/CellData/region", cells)
        numbers = file.maybe("VTKHDF/PointData/GlobalNodeId", points)
        if numbers is None and len(self.points) > 1:
            raise file.fail("has several partitions, but no GlobalNodeId to join them by")
        self._numbers = np.arange(points) if numbers is None else numbers[:].astype(np.int64, copy=False)
        if points and (self._numbers.min() < 0 or self._numbers.max() >= points):
            raise file.fail("a GlobalNodeId is out of range")
        self.nodes = int(self._numbers.max()) + 1 if points else 0

    def read_points(self) -> np.ndarray:
        """In one array, by their numbers."""
        points = np.full((self.nodes, 3), np.nan)
        is_there = np.zeros(self.nodes, bool)
        first = 0
        for count in self.points:
            numbers = self._numbers[first:first + count]
            points[numbers] = self._points[first:first + count]
            is_there[numbers] = True
            first += count
        if not is_there.all():
            raise self.file.fail("a GlobalNodeId below the largest is nobody's")
        return points

    def read_cells(self) -> _Joined:
        joined = _Joined()
        point, cell, number_of_id = 0, 0, 0
        for number, (points, cells, ids) in enumerate(zip(self.points, self.cells, self.ids)):
            numbers = self._numbers[point:point + points]
            connectivity = self._connectivity[number_of_id:number_of_id + ids]
            if ids and (connectivity.min() < 0 or connectivity.max() >= points):
                raise self.file.fail("a cell has a node that does not exist")
            # Each partition has one offset more than it has cells.
            offsets = self._offsets[cell + number:cell + number + cells + 1].astype(np.int64, copy=False)
            if offsets.min() < 0 or offsets.max() > ids or (np.diff(offsets) < 0).any():
                raise self.file.fail("the offset of a cell is wrong")
            self._add(slice(cell, cell + cells), offsets, connectivity, numbers, joined)
            point, cell, number_of_id = point + points, cell + cells, number_of_id + ids
        return joined

    def _add(self, here: slice, offsets: np.ndarray, connectivity: np.ndarray, numbers: np.ndarray,
             joined: _Joined) -> None:
        types = self._types[here]
        counted = 0
        for name, (code, order) in _TYPES.items():
            which = np.flatnonzero(types == code)
            counted += len(which)
            if not len(which):
                continue
            if (offsets[which + 1] - offsets[which] != len(order)).any():
                raise self.file.fail("the offset of a cell is wrong")
            elements = numbers[connectivity[offsets[which][:, None] + np.array(order)]]
            source, missing = (self._patches, -1) if name in _FACES else (self._regions, 1)
            told = np.full(len(which), missing, np.int32) if source is None else \
                source[here][which].astype(np.int32, copy=False)
            joined.add(name, elements, told)
        if counted != len(types):
            raise self.file.fail("has cells other than triangles, quads, tetrahedra, pyramids, prisms and hexahedra")


def read_vtkhdf(path: Path) -> Mesh:
    """@see meshes.read_mesh"""
    h5py = _require_h5py()
    try:
        with h5py.File(path, "r") as opened:
            file = _File(path, opened, h5py)
            partitions = _Partitions(file)
            points = partitions.read_points()
            joined = partitions.read_cells()
            patch_names, region_names = file.texts("Tetfarm/patch_names"), file.texts("Tetfarm/region_names")
    except (OSError, RuntimeError, KeyError) as error:
        raise MeshFileError(f"{path}: {error}") from error
    dtype = np.int32 if len(points) < 1 << 31 else np.int64
    elements = {name: joined.all_elements(name, dtype) for name in _TYPES}
    return Mesh(points=points, triangle_patches=joined.all_told("triangles"), quad_patches=joined.all_told("quads"),
                patch_names=patch_names, region_names=region_names or ["domain"],
                regions={name: joined.all_told(name) for name in _TYPES if name not in _FACES}, **elements)
