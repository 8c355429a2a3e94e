#!/usr/bin/env python3
"""The unit square meshed for metrics by formula, with tetfarm adapt, bamg, mmg2d and Gmsh: tables in
Markdown.

  bench/adapt.py                               every case, C = 18000 where the metric is smooth
  bench/adapt.py --case linear --case polar2 --count 180000
  bench/adapt.py --programs tetfarm --check-criteria
  bench/adapt.py --case linear --gmsh          also Gmsh, which is slow

Programs: tetfarm; bamg, which is ffbamg of the package freefem++; mmg2d, if the variable MMG2D names
mmg2d_O3; gmsh, which is `gmsh -algo bamg`. One that is not there, crashes or hangs has a row that says so.
Cases: linear, bl (a layer at a wall), polar1, polar2 (layers on a circle), cross (two layers that cross);
tanh, the Lp metric of a wavy shock with C = 1000, 4000, 16000, 64000; two, that of two shocks narrower than
the first mesh. C is the complexity asked for; "integral" is that of sqrt(det M), which is more for shocks, as
no size is above 0.1.

Each program gets 5 passes from a grid of 20 x 20, each on its own result of the pass before, with the
metric at the nodes of that; the last is timed. Such a pass may find nearly all done. "Anew" is one pass from
a uniform grid with as many vertices as the metric asks for. Then one more pass on the result. Gmsh gets the
formula instead and starts from nothing: one pass. The programs run in turn, files in and out are part of the
time; seconds are medians, triangles/s are those of user CPU seconds. "B/vertex" is peak memory over
vertices; "above" leaves out what the same program takes for 32 triangles.

The judge is numpy code in here that knows the metric everywhere: lengths of edges by
(la - lb) / ln(la / lb), unit when in [1/sqrt 2, sqrt 2]; quality 4 sqrt 3 area sqrt(det M) / (sum of squared
lengths) with the metric of the densest corner. For shocks also the L2 error of linear interpolation; "slope"
is that of log error over log vertices, from the row of the series before.

--check-criteria ends with exit code 1 when a row of tetfarm misses what CRITERIA and `misses` want; speed is
among it with --speed only. There is no gradation: metrics of shocks are as raw Hessians give them. Needs
numpy and Linux.
"""

import argparse
import collections
import contextlib
import ctypes
import dataclasses
import datetime
import functools
import hashlib
import json
import math
import os
import pathlib
import re
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import threading
import time

import numpy as np

from real_models import ROOT, first_line, machine

PASSES = 5
FIRST_GRID = 20
SMOOTH_COUNT, SERIES, TWO_COUNT = 18000, (1000, 4000, 16000, 64000), 16000
CORNERS = ((0, 0), (1, 0), (1, 1), (0, 1))
SIDES = {1: (1, 0), 2: (0, 1), 3: (1, 1), 4: (0, 0)}  # ref: the coordinate that is constant, and its value
ON_SIDE = 1e-9
SAME_PLACE = 1e-9

# What tetfarm's rows have to reach: (figure, "min" or "max", bound).
SMOOTH_CRITERIA = [("unit", "min", 99.9), ("length_min", "min", 0.6), ("length_max", "max", 1.5),
                   ("quality_min", "min", 0.7), ("quality_mean", "min", 0.965)]
CRITERIA = {
    "linear": SMOOTH_CRITERIA, "bl": SMOOTH_CRITERIA, "polar2": SMOOTH_CRITERIA, "cross": SMOOTH_CRITERIA,
    "polar1": [("unit", "min", 99), ("quality_min", "min", 0.3), ("length_max", "max", 1.8)],
    "tanh": [("length_max", "max", 3), ("error_times_vertices", "max", 0.7)],
    "two": [],
}
LARGEST_SLOPE = -1
TWO_BESIDE_TANH = 2
LARGEST_CHANGE_PERCENT = 1
LARGEST_BYTES_PER_VERTEX, MANY_VERTICES = 300, 10000  # of fewer, memory says little
SPEED_BESIDE_BAMG = 2
LARGE_COUNT, TRIANGLES_PER_SECOND = 180000, 150000  # this speed is for at least that complexity


# --- metrics: arrays of (xx, xy, yy) ------------------------------------------------------------------------

def tensor(first, second, cosine, sine):
    """With these eigenvalues, the first along (cosine, sine)."""
    return np.stack([cosine**2 * first + sine**2 * second, cosine * sine * (first - second),
                     sine**2 * first + cosine**2 * second], -1)


def tensor_of_sizes(first, second, cosine, sine):
    return tensor(1 / first**2, 1 / second**2, cosine, sine)


def eigen(m):
    a, b, c = m[..., 0], m[..., 1], m[..., 2]
    angle = 0.5 * np.arctan2(2 * b, a - c)
    cosine, sine = np.cos(angle), np.sin(angle)
    return (a * cosine**2 + 2 * b * cosine * sine + c * sine**2,
            a * sine**2 - 2 * b * cosine * sine + c * cosine**2, cosine, sine)


def det(m):
    return m[..., 0] * m[..., 2] - m[..., 1]**2


def clipped(m, size_min, size_max):
    """Its eigenvalues without their signs, within those of the two sizes."""
    first, second, cosine, sine = eigen(m)
    first, second = (np.clip(np.abs(value), 1 / size_max**2, 1 / size_min**2) for value in (first, second))
    return tensor(first, second, cosine, sine)


def sandwiched(outer, inner):
    """outer * inner * outer."""
    p, x = (np.stack([m[..., 0], m[..., 1], m[..., 1], m[..., 2]], -1).reshape(m.shape[:-1] + (2, 2))
            for m in (outer, inner))
    product = p @ x @ p
    return np.stack([product[..., 0, 0], product[..., 0, 1], product[..., 1, 1]], -1)


def intersection(a, b):
    """By simultaneous reduction: in the space where a is the identity, b has eigenvalues of at least 1."""
    first, second, cosine, sine = eigen(a)
    whitened = sandwiched(tensor(first**-0.5, second**-0.5, cosine, sine), b)
    larger, smaller, c, s = eigen(whitened)
    both = tensor(np.maximum(larger, 1), np.maximum(smaller, 1), c, s)
    return sandwiched(tensor(first**0.5, second**0.5, cosine, sine), both)


def layer_size(distance):
    return 1e-3 + 2 * (0.1 - 1e-3) * np.abs(distance)


def even(x, y):
    return tensor_of_sizes(1 + 0 * x, 1 + 0 * x, 1, 0)


def linear(x, y):
    return tensor_of_sizes(0.1 + 0 * x, layer_size(y - 0.5), 1, 0)


def wall_layer(x, y):
    """Spacing 1e-4 at the wall, growth 1.2."""
    return tensor_of_sizes(0.05 + 0 * x, np.minimum(1e-4 + 0.2 * y, 0.05), 1, 0)


def polar(x, y, is_fine_along):
    r = np.hypot(x, y)
    angle = np.arctan2(y, x)
    near = 1 - np.minimum(10 * np.abs(r - 0.5), 1)
    along = 0.1 - 0.075 * near if is_fine_along else 0.1 + 0 * x
    return tensor_of_sizes(layer_size(r - 0.5), along, np.cos(angle), np.sin(angle))


def polar1(x, y):
    return polar(x, y, False)


def polar2(x, y):
    return polar(x, y, True)


def cross(x, y):
    """Two straight layers at 50 degrees."""
    layers = []
    for angle in np.deg2rad((20, 70)):
        cosine, sine = np.cos(angle), np.sin(angle)
        distance = cosine * (x - 0.5) + sine * (y - 0.5)
        layers.append(tensor_of_sizes(layer_size(0.7 * distance), 0.1 + 0 * x, cosine, sine))
    return intersection(*layers)


def shock(x, y):
    return np.tanh(50 * (x - 0.5 - 0.1 * np.sin(2 * np.pi * y)))


def shock_hessian(x, y):
    turn = 2 * np.pi
    g = 50 * (x - 0.5 - 0.1 * np.sin(turn * y))
    gx, gy, gyy = 50 + 0 * x, -5 * turn * np.cos(turn * y), 5 * turn**2 * np.sin(turn * y)
    slope = 1 - np.tanh(g)**2
    bend = -2 * np.tanh(g) * slope
    return np.stack([bend * gx**2, bend * gx * gy, bend * gy**2 + slope * gyy], -1)


# Of each shock: height, and a, b, c of tanh(a x + b y + c).
TWO_SHOCKS = ((1, 200, -60, -80), (0.5, -80, 200, -50))


def two_shocks(x, y):
    return sum(height * np.tanh(a * x + b * y + c) for height, a, b, c in TWO_SHOCKS)


def two_shocks_hessian(x, y):
    total = 0
    for height, a, b, c in TWO_SHOCKS:
        value = np.tanh(a * x + b * y + c)
        bend = -2 * height * value * (1 - value**2)
        total = total + np.stack([bend * a * a, bend * a * b, bend * b * b], -1)
    return total


def for_l2(hessian):
    """The metric whose meshes have the smallest L2 error of interpolation, up to a factor."""
    def metric(x, y):
        m = clipped(hessian(x, y), 1e-6, 1e3)
        return m * (np.maximum(det(m), 1e-30)**(-1 / 6))[..., None]
    return metric


def integral(function):
    """Over the unit square: cells are quartered until four and nine Gauss points agree to 1e-4."""
    start = (np.arange(16) + 0.5) / 16
    x, y = (a.ravel() for a in np.meshgrid(start, start))
    half, total, mean = 1 / 32, 0, None
    for depth in range(11):
        sums = []
        for nodes, weights in (np.polynomial.legendre.leggauss(n) for n in (2, 3)):
            sums.append(sum(v * w / 4 * function(x + half * a, y + half * b)
                            for a, v in zip(nodes, weights) for b, w in zip(nodes, weights)))
        coarse, fine = sums
        mean = np.mean(fine) if mean is None else mean
        is_open = np.abs(fine - coarse) > 1e-4 * np.maximum(fine, mean)
        if depth == 10:
            is_open[:] = False
        total += 4 * half**2 * fine[~is_open].sum()
        half /= 2
        x, y = (np.concatenate([a[is_open] + i * half for i in signs])
                for a, signs in ((x, (-1, 1, -1, 1)), (y, (-1, -1, 1, 1))))
    return total


@dataclasses.dataclass(frozen=True)
class Case:
    raw: object            # the metric at (x, y), of any complexity
    solution: object = None

    @functools.lru_cache(maxsize=None)
    def complexity(self):
        return integral(lambda x, y: np.sqrt(det(self.raw(x, y))))

    def metric(self, x, y, count):
        m = self.raw(x, y) * (count / self.complexity())
        return m if self.solution is None else clipped(m, 1e-6, 0.1)


CASES = {
    "linear": Case(linear), "bl": Case(wall_layer), "polar1": Case(polar1), "polar2": Case(polar2),
    "cross": Case(cross), "tanh": Case(for_l2(shock_hessian), shock),
    "two": Case(for_l2(two_shocks_hessian), two_shocks), "even": Case(even),
}
MEASURED = [name for name in CASES if name != "even"]


# --- meshes and files ---------------------------------------------------------------------------------------

@dataclasses.dataclass
class Mesh:
    points: np.ndarray
    triangles: np.ndarray
    sides: np.ndarray      # (a, b, ref) of edges on the boundary; None: not told


def grid(n):
    """Of n x n squares, each halved."""
    places = np.linspace(0, 1, n + 1)
    x, y = np.meshgrid(places, places)
    low = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    triangles = np.stack([low, low + 1, low + n + 2, low, low + n + 2, low + n + 1], -1).reshape(-1, 3)
    mesh = Mesh(np.stack([x.ravel(), y.ravel()], -1), triangles, None)
    mesh.sides = sides_of(mesh)
    return mesh


def edges_of(triangles):
    """Each once, with the number of triangles at it."""
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    edges.sort(axis=1)
    return np.unique(edges, axis=0, return_counts=True)


def sides_of(mesh):
    """Edges of one triangle only, with the side that both ends lie on (0: none)."""
    edges, uses = edges_of(mesh.triangles)
    edges = edges[uses == 1]
    refs = np.zeros(len(edges), int)
    for ref, (axis, value) in SIDES.items():
        refs[(np.abs(mesh.points[edges][:, :, axis] - value) < ON_SIDE).all(axis=1)] = ref
    return np.column_stack([edges, refs])


def write_medit(file, mesh, version=2, with_corners=False):
    on_side = np.isclose(mesh.points * (1 - mesh.points), 0, atol=ON_SIDE).any(axis=1)
    sides = sides_of(mesh) if mesh.sides is None else mesh.sides
    with open(file, "w", encoding="ascii") as out:
        out.write(f"MeshVersionFormatted {version}\nDimension 2\nVertices\n{len(mesh.points)}\n")
        np.savetxt(out, np.column_stack([mesh.points, on_side]), fmt="%.17g %.17g %d")
        out.write(f"Edges\n{len(sides)}\n")
        np.savetxt(out, sides + (1, 1, 0), fmt="%d")
        out.write(f"Triangles\n{len(mesh.triangles)}\n")
        np.savetxt(out, np.column_stack([mesh.triangles + 1, np.ones(len(mesh.triangles), int)]), fmt="%d")
        if with_corners:
            nearest = [1 + np.argmin(np.hypot(*(mesh.points - corner).T)) for corner in CORNERS]
            names = "\n".join(map(str, nearest))
            out.write(f"Corners\n4\n{names}\nRequiredVertices\n4\n{names}\n")
        out.write("End\n")


def write_metric(file, head, metric, tail=""):
    with open(file, "w", encoding="ascii") as out:
        out.write(head)
        np.savetxt(out, metric, fmt="%.15g")
        out.write(tail)


def read_medit(file):
    words = pathlib.Path(file).read_text(encoding="ascii").split()

    def block(name, width, kind):
        at = words.index(name) + 1
        count = int(words[at])
        return np.array(words[at + 1:at + 1 + count * width], dtype=kind).reshape(count, width)

    points = block("Vertices", 3, float)[:, :2]
    triangles = block("Triangles", 4, int)[:, :3] - 1
    sides = block("Edges", 3, int) - (1, 1, 0) if "Edges" in words else None
    return checked(Mesh(points, triangles, sides))


def read_msh2(file):
    lines = pathlib.Path(file).read_text(encoding="ascii").split("\n")

    def block(name):
        at = lines.index(name) + 1
        return [line.split() for line in lines[at + 1:at + 1 + int(lines[at])]]

    nodes = np.array(block("$Nodes"), dtype=float)
    numbers = {int(number): place for place, number in enumerate(nodes[:, 0])}
    of_triangles = [words[-3:] for words in block("$Elements") if words[1] == "2"]
    triangles = [[numbers[int(word)] for word in words] for words in of_triangles]
    return checked(Mesh(nodes[:, 1:3], np.array(triangles).reshape(-1, 3), None))


def checked(mesh):
    if not len(mesh.triangles) or not np.isfinite(mesh.points).all():
        raise ValueError("no triangles, or a place that is no number")
    if mesh.triangles.min() < 0 or mesh.triangles.max() >= len(mesh.points):
        raise ValueError("a triangle of a vertex that is not there")
    if mesh.sides is not None and len(mesh.sides):
        if mesh.sides[:, :2].min() < 0 or mesh.sides[:, :2].max() >= len(mesh.points):
            raise ValueError("an edge of a vertex that is not there")
    return mesh


# --- the judge ----------------------------------------------------------------------------------------------

def length(metric, way):
    return np.sqrt(metric[:, 0] * way[:, 0]**2 + 2 * metric[:, 1] * way[:, 0] * way[:, 1]
                   + metric[:, 2] * way[:, 1]**2)


def edge_lengths(mesh, metric, edges):
    way = mesh.points[edges[:, 1]] - mesh.points[edges[:, 0]]
    a, b = length(metric[edges[:, 0]], way), length(metric[edges[:, 1]], way)
    is_even = np.abs(a - b) <= 1e-4 * (a + b)
    with np.errstate(all="ignore"):
        return np.where(is_even, (a + b) / 2, (a - b) / np.log(a / b))


def areas(corners):
    u, v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2


def qualities(mesh, metric):
    corners = mesh.points[mesh.triangles]
    densest = np.argmax(det(metric)[mesh.triangles], axis=1)
    m = metric[mesh.triangles[np.arange(len(corners)), densest]]
    squares = sum(length(m, corners[:, (k + 1) % 3] - corners[:, k])**2 for k in range(3))
    return 4 * math.sqrt(3) * areas(corners) * np.sqrt(det(m)) / np.maximum(squares, 1e-300)


def largest_angle(corners):
    largest = 0
    for k in range(3):
        u, v = corners[:, (k + 1) % 3] - corners[:, k], corners[:, (k + 2) % 3] - corners[:, k]
        sine = np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
        largest = max(largest, np.arctan2(sine, (u * v).sum(axis=1)).max())
    return math.degrees(largest)


def l2_error(mesh, function, parts=6):
    """Of linear interpolation, by the middles of 36 triangles within each."""
    corners = mesh.points[mesh.triangles]
    values = function(mesh.points[:, 0], mesh.points[:, 1])[mesh.triangles]
    total = 0
    for i in range(parts):
        for j in range(parts - i):
            for third in (1, 2) if i + j < parts - 1 else (1,):
                a, b = (i + third / 3) / parts, (j + third / 3) / parts
                weights = np.array((a, b, 1 - a - b))
                place = np.einsum("k,tkd->td", weights, corners)
                total = total + (function(place[:, 0], place[:, 1]) - values @ weights)**2
    return math.sqrt((total / parts**2 * np.abs(areas(corners))).sum())


def what_is_wrong(mesh):
    """With it as a mesh of the square, apart from its triangles' shapes."""
    found = []
    _, uses = edges_of(mesh.triangles)
    if (uses > 2).any():
        found.append(f"{(uses > 2).sum()} edges of more than two triangles")
    sides = sides_of(mesh)
    if (sides[:, 2] == 0).any():
        found.append(f"{(sides[:, 2] == 0).sum()} boundary edges off the sides")
    unused = len(mesh.points) - len(np.unique(mesh.triangles))
    if unused:
        found.append(f"{unused} vertices of no triangle")
    lost = [corner for corner in CORNERS if np.hypot(*(mesh.points - corner).T).min() > ON_SIDE]
    if lost:
        found.append(f"no vertex at {' '.join(map(str, lost))}")
    if mesh.sides is not None:
        told, true = (set(map(tuple, np.column_stack([np.sort(edges[:, :2], axis=1), edges[:, 2]])))
                      for edges in (mesh.sides, sides))
        if told != true:
            found.append(f"{len(told ^ true)} edges with another side than the mesh has")
    return found


def metric_at(mesh, name, count):
    """At its vertices."""
    return CASES[name].metric(mesh.points[:, 0], mesh.points[:, 1], count)


def judge(mesh, name, count):
    metric = metric_at(mesh, name, count)
    edges, _ = edges_of(mesh.triangles)
    lengths, quality = edge_lengths(mesh, metric, edges), qualities(mesh, metric)
    corners = mesh.points[mesh.triangles]
    area = areas(corners)
    verdict = {
        "vertices": len(mesh.points), "triangles": len(mesh.triangles),
        "unit": 100 * np.mean((lengths >= 0.5**0.5) & (lengths <= 2**0.5)),
        "length_min": lengths.min(), "length_max": lengths.max(),
        "quality_min": quality.min(), "quality_1percent": np.percentile(quality, 1),
        "quality_mean": quality.mean(), "angle_max": largest_angle(corners),
        "inverted": int((area <= 0).sum()), "area": area.sum(),
    }
    if CASES[name].solution is not None:
        verdict["error"] = l2_error(mesh, CASES[name].solution)
        verdict["error_times_vertices"] = verdict["error"] * len(mesh.points)
    return verdict


def changed_percent(before, after):
    """Of the edges of both meshes, as pairs of places: those of one only."""
    pairs = []
    for mesh in (before, after):
        places = np.round(mesh.points / SAME_PLACE).astype(np.int64)
        ends = places[edges_of(mesh.triangles)[0]]
        way = ends[:, 1] - ends[:, 0]
        swap = (way[:, 0] < 0) | ((way[:, 0] == 0) & (way[:, 1] < 0))
        ends[swap] = ends[swap][:, ::-1]
        pairs.append(set(map(tuple, ends.reshape(-1, 4).tolist())))
    return 100 * len(pairs[0] ^ pairs[1]) / (len(pairs[0]) + len(pairs[1]))


# --- running programs ---------------------------------------------------------------------------------------

class Failed(Exception):
    pass


Run = collections.namedtuple("Run", "seconds cpu peak_bytes stdout digest")


def adopt_orphans():
    """Programs whose starter has ended become children of this process."""
    set_child_subreaper = 36
    if ctypes.CDLL(None, use_errno=True).prctl(set_child_subreaper, 1, 0, 0, 0) != 0:
        sys.exit("prctl: cannot become the parent of programs whose starter has ended")


# Tells who the program will be and ends; the program waits until it is told to begin.
STARTER = """exec 3<&0
(read begin <&3; exec 3<&-; exec "$@" > stdout 2> stderr) &
echo $!"""


def run(command, folder, output, limit):
    """Peak memory begins at that of the process that forks, and this one is large: a shell forks, and ends at
    once. The program is then ours to wait for."""
    for file in (output, folder / "stdout", folder / "stderr"):
        file.unlink(missing_ok=True)
    shell = subprocess.Popen(["/bin/sh", "-c", STARTER, "sh", *command], cwd=folder, start_new_session=True,
                             stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    is_late = threading.Event()

    def end():
        is_late.set()
        with contextlib.suppress(ProcessLookupError):
            os.killpg(shell.pid, signal.SIGKILL)

    timer = threading.Timer(limit, end)
    try:
        program = int(shell.stdout.readline())
        shell.wait()
        start = time.monotonic()
        timer.start()
        shell.stdin.write(b"\n")
        shell.stdin.close()
        _, status, used = os.wait4(program, 0)
        seconds = time.monotonic() - start
    finally:
        timer.cancel()
        kill_group(shell.pid)
        shell.stdout.close()
    if is_late.is_set():
        raise Failed(f"no end in {limit:g} s")
    if os.WIFSIGNALED(status):
        raise Failed(f"crash ({signal.Signals(os.WTERMSIG(status)).name})")
    stdout = (folder / "stdout").read_text(encoding="utf-8", errors="replace")
    if os.WEXITSTATUS(status) != 0:
        said = (folder / "stderr").read_text(encoding="utf-8", errors="replace") or stdout
        last = said.strip().split("\n")[-1].replace("|", "/")[:100]
        raise Failed(f"exit code {os.WEXITSTATUS(status)}: {last}")
    if not output.exists():
        raise Failed("no result, exit code 0")
    digest = hashlib.sha256(re.sub(rb'Date: [^"\n]*', b"", output.read_bytes())).hexdigest()
    return Run(seconds, used.ru_utime, 1024 * used.ru_maxrss, stdout, digest)


def kill_group(group):
    """And whatever of it has become ours."""
    with contextlib.suppress(ProcessLookupError, ChildProcessError):
        os.killpg(group, signal.SIGKILL)
        while os.waitpid(-group, 0)[0] > 0:
            pass


class Tetfarm:
    name, reader, goes_on = "tetfarm", staticmethod(read_medit), True

    def __init__(self, executable, extra=""):
        self.executable, self.extra = executable, extra

    def prepare(self, folder, mesh, name, count):
        """Writes what it reads. Its options and the file that it makes."""
        metric = metric_at(mesh, name, count)
        write_medit(folder / "in.mesh", mesh)
        head = f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{len(metric)}\n1 3\n"
        write_metric(folder / "in.sol", head, metric, "End\n")
        return f"adapt in.mesh --metric in.sol -o out.mesh --json {self.extra}", "out.mesh"


class Mmg2d(Tetfarm):
    name = "mmg2d"

    def prepare(self, folder, mesh, name, count):
        super().prepare(folder, mesh, name, count)
        write_medit(folder / "in.mesh", mesh, with_corners=True)
        return "in.mesh -sol in.sol -out out.mesh -hgrad -1 -hgradreq -1 -v 1", "out.mesh"


class Bamg(Tetfarm):
    name = "bamg"

    def prepare(self, folder, mesh, name, count):
        """It crashes on the section of geometry in its own result: we write the mesh without."""
        write_medit(folder / "in.mesh", mesh, version=0, with_corners=True)
        metric = metric_at(mesh, name, count)
        write_metric(folder / "in.mtr", f"{len(metric)} 3\n", metric)
        return "-b in.mesh -M in.mtr -o out.mesh -nbv 2000000 -hmin 1e-7 -hmax 1 -v 1", "out.mesh"


class Gmsh(Tetfarm):
    """It gets the formula: of tensors on triangles (PostView) version 4.8 makes next to no mesh."""
    name, reader, goes_on = "gmsh", staticmethod(read_msh2), False
    GEOMETRY = """Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1:4}; Plane Surface(1) = {1};
Mesh.MeshSizeExtendFromBoundary = 0; Mesh.MeshSizeFromPoints = 0;
Mesh.MeshSizeMin = 1e-7; Mesh.MeshSizeMax = 1;
"""

    def prepare(self, folder, mesh, name, count):
        if name not in GMSH_FORMULAS:
            raise Failed("no formula of this metric for Gmsh")
        factor = count / CASES[name].complexity()
        text = self.GEOMETRY
        for number, (first, second, cosine, sine) in enumerate(GMSH_FORMULAS[name], 1):
            a, b = f"({factor:.15g}/({first})^2)", f"({factor:.15g}/({second})^2)"
            c, s = f"({cosine})", f"({sine})"
            values = {"m11": f"{c}^2*{a}+{s}^2*{b}", "m12": f"{c}*{s}*({a}-{b})",
                      "m22": f"{s}^2*{a}+{c}^2*{b}", "m13": "0", "m23": "0", "m33": "1"}
            text += f"Field[{number}] = MathEvalAniso;\n"
            text += "".join(f'Field[{number}].{key} = "{value}";\n' for key, value in values.items())
        text += "Field[9] = IntersectAniso; Field[9].FieldsList = {1, 2};\n" if number == 2 else ""
        text += f"Background Field = {9 if number == 2 else 1};\n"
        (folder / "in.geo").write_text(text, encoding="ascii")
        return "in.geo -2 -algo bamg -nt 1 -format msh2 -o out.msh -v 2", "out.msh"


def gmsh_layer(distance):
    return f"0.001+0.198*Fabs({distance})"


def gmsh_formulas():
    """Of each case sizes and the direction of the first, for Gmsh; of cross two."""
    r, smaller = "Sqrt(x*x+y*y+1e-30)", "(({0})+({1})-Fabs(({0})-({1})))/2"
    across, along = gmsh_layer(f"{r}-0.5"), f"0.025+0.075*{smaller.format(f'10*Fabs({r}-0.5)', '1')}"
    formulas = {
        "even": [("1", "1", "1", "0")], "linear": [("0.1", gmsh_layer("y-0.5"), "1", "0")],
        "bl": [("0.05", smaller.format("0.0001+0.2*y", "0.05"), "1", "0")],
        "polar1": [(across, "0.1", f"x/{r}", f"y/{r}")], "polar2": [(across, along, f"x/{r}", f"y/{r}")],
    }
    formulas["cross"] = []
    for angle in np.deg2rad((20, 70)):
        c, s = f"{math.cos(angle):.15g}", f"{math.sin(angle):.15g}"
        formulas["cross"].append((gmsh_layer(f"0.7*({c}*(x-0.5)+{s}*(y-0.5))"), "0.1", c, s))
    return formulas


GMSH_FORMULAS = gmsh_formulas()


class Step:
    """One pass of one program on one mesh, to be run as often as wanted."""

    def __init__(self, program, folder, mesh, name, count, limit):
        folder.mkdir(parents=True, exist_ok=True)
        self.program, self.folder, self.limit, self.runs = program, folder, limit, []
        options, output = program.prepare(folder, mesh, name, count)
        self.command = [program.executable, *options.split()]
        self.output = folder / output

    def time(self):
        self.runs.append(run(self.command, self.folder, self.output, self.limit))

    def mesh(self):
        try:
            return self.program.reader(self.output)
        except (ValueError, IndexError, KeyError) as error:
            raise Failed(f"unreadable result: {str(error)[:80]}") from error

    def median(self, figure):
        return statistics.median(getattr(one, figure) for one in self.runs)


# --- one row: a program on a case ---------------------------------------------------------------------------

class Row:
    def __init__(self, name, count, program, limit, folder):
        self.name, self.count, self.program, self.limit, self.folder = name, count, program, limit, folder
        self.wanted = integral(lambda x, y: np.sqrt(det(CASES[name].metric(x, y, count))))
        self.remarks, self.failure = [], None
        self.last = self.anew = self.verdict = self.of_anew = self.again = self.own = self.slope = None

    def step(self, name, mesh):
        return Step(self.program, self.folder / name, mesh, self.name, self.count, self.limit)

    def all_passes(self):
        """Sets the last step, the verdict on its mesh, and what comes of another one."""
        if not shutil.which(self.program.executable):
            self.failure = f"not there: {self.program.executable}"
            return
        mesh, number = grid(FIRST_GRID), 0
        try:
            for number in range(1, (PASSES if self.program.goes_on else 1) + 1):
                self.last = self.step(f"pass{number}", mesh)
                self.last.time()
                mesh = self.last.mesh()
        except Failed as failed:
            self.failure = f"pass {number}: {failed}"
            return
        self.verdict = judge(mesh, self.name, self.count)
        self.remarks += what_is_wrong(mesh)
        if self.program.name == "tetfarm":
            self.read_own_words()
        if not self.program.goes_on:
            return
        try:
            step = self.step("again", mesh)
            step.time()
            after = step.mesh()
            self.again = {"changed": changed_percent(mesh, after), **judge(after, self.name, self.count)}
        except Failed as failed:
            self.remarks.append(f"pass on its result: {failed}")

    def read_own_words(self):
        try:
            self.own = json.loads(self.last.runs[-1].stdout.strip().split("\n")[-1])
            if not isinstance(self.own, dict):
                raise ValueError("no object")
        except ValueError:
            self.own = None
            self.remarks.append("no line of JSON")
            return
        for key in ("vertices", "triangles"):
            if self.own.get(key) != self.verdict[key]:
                self.remarks.append(f"says {self.own.get(key)} {key}")

    def prepare_anew(self):
        """From a uniform grid of about as many vertices as a mesh for the metric has."""
        if self.failure is None and self.program.goes_on:
            self.anew = self.step("anew", grid(max(2, round(math.sqrt(1.1 * self.wanted)) - 1)))

    def repeat(self, is_first):
        """The last pass once more, unless it is the first time, and everything anew."""
        if self.failure is not None:
            return
        try:
            if not is_first:
                self.last.time()
        except Failed as failed:
            self.remarks.append(f"last pass again: {failed}")
        if self.anew is None:
            return
        try:
            self.anew.time()
            if is_first:
                self.of_anew = judge(self.anew.mesh(), self.name, self.count)
        except Failed as failed:
            self.remarks.append(f"anew: {failed}")
            self.anew = self.of_anew = None

    def note_differences(self):
        for what, step in (("last pass", self.last), ("anew", self.anew)):
            if self.verdict is not None and step is not None and len({one.digest for one in step.runs}) > 1:
                self.remarks.append(f"{what}: repeats give other bytes")


@functools.lru_cache(maxsize=None)
def memory_of_next_to_nothing(program, limit):
    """Peak bytes for a grid of 4 x 4 that is already as wanted."""
    with tempfile.TemporaryDirectory(prefix="adapt.") as folder:
        mesh = grid(4)
        step = Step(program, pathlib.Path(folder), mesh, "even", 16, limit)
        try:
            step.time()
        except Failed:
            return 0
        return step.runs[0].peak_bytes


def measure(name, count, programs, arguments, folder):
    """The rows of one case, the programs in turn."""
    rows = [Row(name, count, program, arguments.timeout, folder / f"{name}-{count:g}-{program.name}")
            for program in programs]
    for row in rows:
        say(f"{name}, C = {count:g}, {row.program.name}")
        row.all_passes()
        row.prepare_anew()
    for number in range(arguments.repeats):
        for row in rows:
            row.repeat(number == 0)
    for row in rows:
        row.note_differences()
        if not arguments.keep:
            shutil.rmtree(row.folder, ignore_errors=True)
    return rows


def add_slopes(rows):
    """Between neighbours of a series."""
    before = {}
    for row in rows:
        if row.name != "tanh":
            continue
        coarse = before.get(row.program.name)
        if coarse and row.verdict and coarse.verdict:
            growth = math.log(row.verdict["vertices"] / coarse.verdict["vertices"])
            row.slope = math.log(row.verdict["error"] / coarse.verdict["error"]) / growth if growth else 0
        before[row.program.name] = row


# --- tables -------------------------------------------------------------------------------------------------

def say(text):
    print(f"{time.strftime('%H:%M:%S')} {text}", file=sys.stderr, flush=True)


def print_table(title, heads, rows, cells):
    """`cells` of a row is None where the table has nothing of it."""
    found = [(row, cells(row)) for row in rows]
    if not any(texts for _, texts in found):
        return
    print(f"\n{title}\n\n| case | C | program | {' | '.join(heads)} |\n|---|--:|---|{'--:|' * len(heads)}")
    for row, texts in found:
        if texts:
            print(f"| {row.name} | {row.count:g} | {row.program.name} | {' | '.join(texts)} |")


def quality_cells(row):
    wanted, v = f"{row.wanted:.0f}", row.verdict
    if v is None:
        return [wanted] + [""] * 11 + [row.failure or "not run"]
    return [wanted, str(v["vertices"]), str(v["triangles"]), f"{v['unit']:.2f}", f"{v['length_min']:.2f}",
            f"{v['length_max']:.4g}", f"{v['quality_min']:.3g}", f"{v['quality_1percent']:.2f}",
            f"{v['quality_mean']:.3f}", f"{v['angle_max']:.2f}", str(v["inverted"]), f"{v['area'] - 1:.0e}",
            "; ".join(row.remarks)]


def rate(step, triangles):
    return triangles / max(step.median("cpu"), 1e-3)


def bytes_per_vertex(row, step, verdict):
    """All, and above what next to nothing takes."""
    peak = step.median("peak_bytes")
    return (peak / verdict["vertices"],
            max(0, peak - memory_of_next_to_nothing(row.program, row.limit)) / verdict["vertices"])


def speed_cells(row):
    if row.verdict is None:
        return None
    texts = []
    for step, verdict in ((row.last, row.verdict), (row.anew, row.of_anew)):
        if step is None or verdict is None:
            texts += [""] * 7
            continue
        whole, above = bytes_per_vertex(row, step, verdict)
        texts += [str(verdict["triangles"]), f"{step.median('seconds'):.2f}", f"{step.median('cpu'):.2f}",
                  f"{rate(step, verdict['triangles']):.0f}", f"{step.median('peak_bytes') / 1e6:.1f}",
                  f"{whole:.0f}", f"{above:.0f}"]
    if row.of_anew:
        texts += [f"{row.of_anew['unit']:.1f}", f"{row.of_anew['length_max']:.3g}",
                  f"{row.of_anew['quality_min']:.2g}"]
    return texts + [""] * (17 - len(texts))


def worsened(row):
    """Figures of the mesh that one more pass makes worse."""
    names = []
    if row.again["quality_min"] < row.verdict["quality_min"] - 1e-9:
        names.append("quality")
    if row.again["length_max"] > row.verdict["length_max"] + 1e-9:
        names.append("longest edge")
    return names


def again_cells(row):
    if row.again is None:
        return None
    texts = [f"{row.again['changed']:.2f}"]
    for key in ("unit", "length_max", "quality_min"):
        texts.append(f"{row.verdict[key]:.4g} -> {row.again[key]:.4g}")
    return texts + [", ".join(worsened(row)) or "nothing"]


def error_cells(row):
    if row.verdict is None or "error" not in row.verdict:
        return None
    slope = "" if row.slope is None else f"{row.slope:.2f}"
    return [str(row.verdict["vertices"]), f"{row.verdict['error']:.3g}",
            f"{row.verdict['error_times_vertices']:.3g}", slope, f"{row.verdict['length_max']:.3g}"]


OWN_WORDS = ("vertices", "triangles", "unit_edges_percent", "edge_length_min", "edge_length_max",
             "quality_min", "quality_1percent", "quality_mean", "max_angle_deg", "complexity", "seconds",
             "digest")


def own_cells(row):
    if row.own is None:
        return None
    values = [row.own.get(key, "missing") for key in OWN_WORDS]
    return [f"{value:.6g}" if isinstance(value, float) else str(value).replace("|", "/") for value in values]


def print_tables(rows):
    print_table(f"Meshes after {PASSES} passes",
                ["integral", "vertices", "triangles", "unit edges, %", "length min", "max", "quality min",
                 "1 %", "mean", "largest angle, deg", "inverted", "area - 1", "remarks"], rows, quality_cells)
    speed = ["triangles", "s", "user s", "triangles/s", "peak MB", "B/vertex", "above"]
    print_table("Speed and memory: the last pass on its own result, then anew from a uniform grid",
                speed + [f"anew: {speed[0]}"] + speed[1:] + ["unit edges, %", "length max", "quality min"],
                rows, speed_cells)
    print_table("One more pass on the result",
                ["edges changed, %", "unit edges, %", "length max", "quality min", "worse"],
                rows, again_cells)
    print_table("Error of interpolation", ["vertices", "L2 error", "error x vertices", "slope", "length max"],
                rows, error_cells)
    print_table("What tetfarm says of its last pass", [key.replace("_", " ") for key in OWN_WORDS], rows,
                own_cells)


# --- criteria -----------------------------------------------------------------------------------------------

def misses(row, rows, with_speed):
    """What a row of tetfarm should reach and does not."""
    if row.verdict is None:
        return [row.failure or "not run"]
    v, found = row.verdict, list(row.remarks)
    if v["inverted"] or abs(v["area"] - 1) > 1e-9:
        found.append(f"{v['inverted']} inverted triangles, area {v['area']:.12g}")
    for key, way, bound in CRITERIA[row.name]:
        if not (v[key] >= bound if way == "min" else v[key] <= bound):
            found.append(f"{key} {v[key]:.4g}, wanted {'>=' if way == 'min' else '<='} {bound:g}")
    if row.slope is not None and row.slope > LARGEST_SLOPE:
        found.append(f"slope {row.slope:.2f}, wanted <= {LARGEST_SLOPE}")
    if row.name == "two":
        found += misses_of_two(row, rows)
    if row.again and row.again["changed"] > LARGEST_CHANGE_PERCENT:
        found.append(f"one more pass changes {row.again['changed']:.2f} % of the edges, wanted <= "
                     f"{LARGEST_CHANGE_PERCENT}")
    if row.again and worsened(row):
        found.append(f"one more pass makes worse: {', '.join(worsened(row))}")
    above = bytes_per_vertex(row, row.last, v)[1]
    if above > LARGEST_BYTES_PER_VERTEX and v["vertices"] >= MANY_VERTICES:
        found.append(f"{above:.0f} bytes per vertex, wanted <= {LARGEST_BYTES_PER_VERTEX}")
    return found + (misses_of_speed(row, rows) if with_speed else [])


def misses_of_two(row, rows):
    """Beside the one shock of nearest complexity."""
    others = [other for other in rows
              if other.name == "tanh" and other.program is row.program and other.verdict]
    if not others:
        return []
    nearest = min(others, key=lambda other: abs(math.log(other.count / row.count)))
    ratio = row.verdict["error_times_vertices"] / nearest.verdict["error_times_vertices"]
    if ratio <= TWO_BESIDE_TANH:
        return []
    return [f"error x vertices {ratio:.1f} times that of one shock, wanted <= {TWO_BESIDE_TANH}"]


def misses_of_speed(row, rows):
    bamg = next((other for other in rows if (other.name, other.count) == (row.name, row.count)
                 and other.program.name == "bamg" and other.verdict), None)
    found = []
    for what, step, verdict in (("last", "last", "verdict"), ("anew", "anew", "of_anew")):
        if getattr(row, verdict) is None:
            continue
        ours = rate(getattr(row, step), getattr(row, verdict)["triangles"])
        if bamg and getattr(bamg, verdict):
            theirs = rate(getattr(bamg, step), getattr(bamg, verdict)["triangles"])
            if ours < SPEED_BESIDE_BAMG * theirs:
                found.append(f"{what}: {ours / theirs:.2f} times as fast as bamg, wanted >= "
                             f"{SPEED_BESIDE_BAMG}")
        if row.count >= LARGE_COUNT and ours < TRIANGLES_PER_SECOND:
            found.append(f"{what}: {ours:.0f} triangles/s, wanted >= {TRIANGLES_PER_SECOND}")
    return found


def check(rows, with_speed):
    """Prints what is missed; the exit code."""
    ours = [row for row in rows if row.program.name == "tetfarm"]
    missed = [(row, text) for row in ours for text in misses(row, rows, with_speed)]
    rows_with_misses = len({id(row) for row, _ in missed})
    print(f"\nCriteria: {rows_with_misses} of {len(ours)} rows of tetfarm miss some")
    for row, text in missed:
        print(f"- {row.name}, C = {row.count:g}: {text}")
    return 1 if missed or not ours else 0


# --- command line -------------------------------------------------------------------------------------------

def counts_of(name, count):
    if name == "tanh":
        return [one for one in SERIES if count is None or one <= count] or [count]
    return [count or (TWO_COUNT if name == "two" else SMOOTH_COUNT)]


def programs_of(arguments):
    mmg2d = os.environ.get("MMG2D")
    ours = Tetfarm(str(pathlib.Path(arguments.tetfarm).absolute()), arguments.extra)
    known = {"tetfarm": ours, "bamg": Bamg("ffbamg"), "mmg2d": Mmg2d(mmg2d or "mmg2d_O3"),
             "gmsh": Gmsh("gmsh")}
    names = (arguments.programs or "tetfarm,bamg" + ",mmg2d" * bool(mmg2d)).split(",")
    if arguments.gmsh and "gmsh" not in names:
        names.append("gmsh")
    unknown = [name for name in names if name not in known]
    if unknown:
        sys.exit(f"unknown program: {', '.join(unknown)}; there are {', '.join(known)}")
    return [known[name] for name in names]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--case", action="append", choices=MEASURED, help="default: all")
    parser.add_argument("--count", type=float,
                        help=f"C (default {SMOOTH_COUNT}; two: {TWO_COUNT}); tanh: its series up to this")
    parser.add_argument("--programs", help="names, with commas between them "
                        "(default: tetfarm,bamg, and mmg2d if MMG2D is set)")
    parser.add_argument("--gmsh", action="store_true", help="Gmsh as well")
    parser.add_argument("--tetfarm", default=str(ROOT / "build/release/bin/tetfarm"))
    parser.add_argument("--extra", default="", help="more options of tetfarm adapt, as one word")
    parser.add_argument("--repeats", type=int, default=3, help="of what is timed")
    parser.add_argument("--timeout", type=float, default=120, help="seconds for a pass")
    parser.add_argument("--keep", type=pathlib.Path, metavar="FOLDER",
                        help="for all files (default: they go)")
    parser.add_argument("--check-criteria", action="store_true", help="exit code 1 when tetfarm misses one")
    parser.add_argument("--speed", action="store_true", help="speed is a criterion, too")
    arguments = parser.parse_args()
    if min(arguments.repeats, arguments.timeout, 1 if arguments.count is None else arguments.count) <= 0:
        parser.error("--repeats, --timeout and --count have to be more than 0")
    return arguments


def main():
    arguments = parse_arguments()
    programs = programs_of(arguments)
    adopt_orphans()
    commit = first_line(["git", "rev-parse", "--short", "HEAD"])
    print(f"{machine()}, commit {commit}, {datetime.date.today().isoformat()}", flush=True)
    rows, is_whole = [], False
    with tempfile.TemporaryDirectory(prefix="adapt.") as temporary:
        folder = arguments.keep.absolute() if arguments.keep else pathlib.Path(temporary)
        try:
            for name in arguments.case or MEASURED:
                for count in counts_of(name, arguments.count):
                    rows += measure(name, count, programs, arguments, folder)
            is_whole = True
        except KeyboardInterrupt:
            print("\nInterrupted: cases are missing.")
    add_slopes(rows)
    print_tables(rows)
    code = check(rows, arguments.speed) if arguments.check_criteria else 0
    return code if is_whole else 130


if __name__ == "__main__":
    sys.exit(main())
