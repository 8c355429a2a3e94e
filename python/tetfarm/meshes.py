"""Finished meshes as arrays of numpy, from VTKHDF and from UGRID.

Nodes are numbered from 0, patches from 0, regions from 1, as in docs/file_formats.md. Triangles and quads of the boundary
have their normals out of the domain; one between two regions is there once for each of them. Prisms have the triangle
3, 4, 5 above 0, 1, 2, and pyramids the apex 4 above 0, 1, 2, 3, as in Gmsh and CGNS.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Dict, List, Union

from .errors import MeshFileError, MissingLibraryError

if TYPE_CHECKING:
    import numpy

_UGRID = {".lb8.ugrid": ("<", 4), ".b8.ugrid": (">", 4), ".lb8l.ugrid": ("<", 8), ".b8l.ugrid": (">", 8)}
_VTKHDF = (".vtkhdf", ".hdf")


@dataclass
class Mesh:
    """A mesh. Lists of cells have a row of node numbers for each; those that the mesh does not have are empty."""

    points: "numpy.ndarray"
    tets: "numpy.ndarray"
    pyramids: "numpy.ndarray"
    prisms: "numpy.ndarray"
    hexes: "numpy.ndarray"
    triangles: "numpy.ndarray"
    """Of the boundary."""
    triangle_patches: "numpy.ndarray"
    """Of each triangle; -1: it has none."""
    quads: "numpy.ndarray"
    quad_patches: "numpy.ndarray"
    patch_names: List[str] = field(default_factory=list)
    regions: Dict[str, "numpy.ndarray"] = field(default_factory=dict)
    """"tets" -> the region of each, and so on."""
    region_names: List[str] = field(default_factory=list)
    """Of the regions 1, 2, ..."""

    def patch_name(self, patch: int) -> str:
        """Its name, or "patch N", counted from 1, where it has none."""
        return self.patch_names[patch] if 0 <= patch < len(self.patch_names) else f"patch {patch + 1}"

    def triangles_of(self, patch: Union[int, str]) -> "numpy.ndarray":
        """The boundary triangles of a patch, by its number or name."""
        number = self.patch_names.index(patch) if isinstance(patch, str) else patch
        return self.triangles[self.triangle_patches == number]


def require_numpy():
    """The library, or the exception that says how to get it."""
    try:
        import numpy
    except ImportError as error:
        raise MissingLibraryError("meshes are read with numpy, which is not there",
                                  help="apt-get install python3-numpy, or pip install numpy") from error
    return numpy


def can_read(path: "Union[str, os.PathLike[str]]") -> bool:
    """Whether the ending of a file is that of a mesh that read_mesh knows."""
    name = os.fspath(path).lower()
    return name.endswith((*_UGRID, *_VTKHDF))


def read_mesh(path: "Union[str, os.PathLike[str]]") -> Mesh:
    """A mesh in `.vtkhdf`, or in `.lb8.ugrid`, `.b8.ugrid`, `.lb8l.ugrid` or `.b8l.ugrid`; the ending tells which.

    Partitions of VTKHDF are joined. It needs h5py; UGRID needs numpy alone. The whole mesh is in memory, about 60 bytes for
    each tetrahedron.
    """
    file = Path(path)
    name = file.name.lower()
    if not file.is_file():
        raise MeshFileError(f"{file}: no such file", help="check the path")
    require_numpy()
    for ending, (order, size) in _UGRID.items():
        if name.endswith(ending):
            from .ugrid import read_ugrid

            return read_ugrid(file, order, size)
    if name.endswith(_VTKHDF):
        from .vtkhdf import read_vtkhdf

        return read_vtkhdf(file)
    raise MeshFileError(f"{file}: meshes are read from {', '.join([*_VTKHDF, *_UGRID])}",
                        help="tetfarm export writes it in another format")
