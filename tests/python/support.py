"""What the tests of the module share: surfaces, volumes by numpy, processes, programs that only seem to be tetfarm.

The environment names what is tested: TETFARM, the program, and PYTHONPATH, the module.
"""

import contextlib
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLE = ROOT / "examples/cube_sphere/cube_sphere.toml"
SURFACE = ROOT / "examples/cube_sphere/cube_sphere.msh"

# Faces by our order of nodes, outwards.
FACES = {"tets": ((1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)),
         "pyramids": ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
         "prisms": ((0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
         "hexes": ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))}


def main():
    """Runs the tests of a file; 77 without numpy, but for continuous integration, where nothing may be skipped."""
    try:
        import numpy  # noqa: F401
    except ImportError:
        print("numpy is not there (python3-numpy)")
        sys.exit(1 if os.environ.get("CI") else 77)
    unittest.main(verbosity=2)


class InFolder(unittest.TestCase):
    """Each test works in a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)

    def assert_nothing_runs(self):
        """Nothing that was started here; what was killed goes when the kernel comes to it."""
        if not await_that(lambda: not processes_in(self.folder)):
            self.fail(f"still running: {processes_in(self.folder)}")


def shape(kind, name, spacing):
    """A surface that the program makes."""
    subprocess.run([os.environ["TETFARM"], "shape", kind, "-o", name, "--spacing", str(spacing)], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def open_cube(path):
    """A cube of which a triangle is missing."""
    corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    triangles = [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))][1:]
    lines = ["OFF", f"{len(corners)} {len(triangles)} 0", *(" ".join(map(str, corner)) for corner in corners),
             *("3 " + " ".join(map(str, triangle)) for triangle in triangles)]
    pathlib.Path(path).write_text("\n".join(lines) + "\n", encoding="utf-8")


def two_boxes(path):
    """Two boxes that share a side, of volumes 1 and 2: vertices of a grid of 2 x 1 x 1."""
    number = {(x, y, z): i for i, (z, y, x) in
              enumerate((z, y, x) for z in (0, 1) for y in (0, 1) for x in (0, 1, 3))}
    triangles = []

    def quad(a, b, c, d):
        triangles.extend([(number[a], number[b], number[c]), (number[a], number[c], number[d])])

    for x0, x1 in ((0, 1), (1, 3)):
        quad((x0, 0, 0), (x0, 1, 0), (x1, 1, 0), (x1, 0, 0))
        quad((x0, 0, 1), (x1, 0, 1), (x1, 1, 1), (x0, 1, 1))
        quad((x0, 0, 0), (x1, 0, 0), (x1, 0, 1), (x0, 0, 1))
        quad((x0, 1, 0), (x0, 1, 1), (x1, 1, 1), (x1, 1, 0))
    for x in (0, 1, 3):
        corners = ((x, 0, 0), (x, 0, 1), (x, 1, 1), (x, 1, 0))
        quad(*(corners if x < 3 else corners[::-1]))
    vertices = sorted(number, key=number.get)
    lines = ["OFF", f"{len(vertices)} {len(triangles)} 0", *(" ".join(map(str, v)) for v in vertices),
             *("3 " + " ".join(map(str, triangle)) for triangle in triangles)]
    pathlib.Path(path).write_text("\n".join(lines) + "\n", encoding="utf-8")


def volumes_of(mesh, kind):
    """Of each cell of a kind: the sum of the cones over its faces; a quad is the mean of its two pairs of triangles."""
    import numpy

    cells = getattr(mesh, kind)
    volumes = numpy.zeros(len(cells))
    if not len(cells):
        return volumes
    origin = mesh.points[cells[:, 0]]
    for face in FACES[kind]:
        fans = [(0, 1, 2)] if len(face) == 3 else [(0, 1, 2), (0, 2, 3), (0, 1, 3), (1, 2, 3)]
        for fan in fans:
            a, b, c = (mesh.points[cells[:, face[k]]] - origin for k in fan)
            volumes += numpy.einsum("ij,ij->i", a, numpy.cross(b, c)) / (6 if len(face) == 3 else 12)
    return volumes


def volume_of(mesh):
    return sum(float(volumes_of(mesh, kind).sum()) for kind in FACES)


def enclosed_by(mesh):
    """The volume under the boundary: positive where its normals point out."""
    import numpy

    total = 0.0
    for faces in (mesh.triangles, mesh.quads[:, [0, 1, 2]], mesh.quads[:, [0, 2, 3]]):
        a, b, c = (mesh.points[faces[:, k]] for k in range(3))
        total += float(numpy.einsum("ij,ij->", a, numpy.cross(b, c))) / 6
    return total


def unmatched_faces(mesh):
    """How many faces of cells are neither shared by two cells nor in the boundary."""
    import numpy

    keys = []
    for kind, faces in FACES.items():
        cells = getattr(mesh, kind)
        for face in faces:
            sides = numpy.sort(cells[:, list(face)].astype(numpy.int64), axis=1)
            keys.append(numpy.pad(sides, ((0, 0), (0, 4 - len(face))), constant_values=-1))
    for faces in (mesh.triangles, mesh.quads):
        sides = numpy.sort(faces.astype(numpy.int64), axis=1)
        keys.append(numpy.pad(sides, ((0, 0), (0, 4 - faces.shape[1])), constant_values=-1))
    _, counts = numpy.unique(numpy.concatenate(keys), axis=0, return_counts=True)
    return int((counts != 2).sum())


@contextlib.contextmanager
def program_that(script, folder):
    """A program of the shell in place of tetfarm."""
    path = pathlib.Path(folder) / "seems_to_be_tetfarm"
    path.write_text("#!/bin/sh\n" + script, encoding="utf-8")
    path.chmod(0o755)
    before = os.environ["TETFARM"]
    os.environ["TETFARM"] = str(path)
    try:
        yield path
    finally:
        os.environ["TETFARM"] = before


def processes_in(folder):
    """{process: its command line} of those that work in a folder or below."""
    found = {}
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit() or int(entry.name) == os.getpid():
            continue
        try:
            words = (entry / "cmdline").read_bytes().replace(b"\0", b" ").decode("utf-8", "replace")
            if pathlib.Path(os.readlink(entry / "cwd")).is_relative_to(folder):
                found[int(entry.name)] = words
        except OSError:
            continue
    return found


def await_that(condition, seconds=20.0):
    """Whether it comes to be within so many seconds."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        if condition():
            return True
        time.sleep(0.02)
    return bool(condition())


class Farm:
    """A coordinator on this machine and a worker, in a folder."""

    def __init__(self, folder, workers=1):
        program = os.environ["TETFARM"]
        environment = {**os.environ, "XDG_CONFIG_HOME": str(folder / "configuration")}
        self._processes = []
        coordinator = self._start([program, "coordinator", "--store", "store", "--listen", "tcp://127.0.0.1:*"], folder,
                                  environment, stdout=subprocess.PIPE)
        line = coordinator.stdout.readline()
        if not line.startswith("listening on "):
            self.close()
            raise AssertionError(f"the coordinator says {line!r}")
        self.address = line[len("listening on "):].strip()
        for _ in range(workers):
            self._start([program, "worker", "--connect", self.address, "--store", "store"], folder, environment,
                        stdout=subprocess.DEVNULL)

    def _start(self, words, folder, environment, stdout):
        process = subprocess.Popen(words, cwd=folder, env=environment, text=True, stdout=stdout,
                                   stderr=subprocess.DEVNULL)
        self._processes.append(process)
        return process

    def close(self):
        for process in reversed(self._processes):
            process.send_signal(signal.SIGKILL)
            process.wait()
            if process.stdout:
                process.stdout.close()
