"""Tetfarm from Python: tetrahedral meshes of what closed surfaces enclose, and of the space round them.

This module runs the program `tetfarm`, which it finds by $TETFARM or on the PATH, and reads the meshes that it writes.

>>> import tetfarm
>>> result = tetfarm.run("wing.stl", "out", size=0.1, format="lb8.ugrid")
>>> mesh = result.read_mesh()
>>> mesh.points.shape, mesh.tets.shape
"""

from .errors import (GateError, GeometryError, MeshFileError, MissingLibraryError, NotFoundError, ProgramDiedError,
                     ProgramNotFoundError, ProtocolError, ResourcesError, StoppedError, TetfarmError, TimeLimitError,
                     UsageError)
from .jobs import Progress, Result, cancel, jobs, run, status, submit, wait
from .meshes import Mesh, read_mesh
from .program import find_program

__version__ = "0.1.0"

__all__ = ["GateError", "GeometryError", "Mesh", "MeshFileError", "MissingLibraryError", "NotFoundError",
           "ProgramDiedError", "ProgramNotFoundError", "Progress", "ProtocolError", "ResourcesError", "Result",
           "StoppedError", "TetfarmError", "TimeLimitError", "UsageError", "cancel", "find_program", "jobs", "read_mesh",
           "run", "status", "submit", "wait"]
