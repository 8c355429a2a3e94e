#!/usr/bin/env python3
"""A wing meshed with boundary layers, its viscous flow solved with OpenFOAM, and y+ of the flow beside what was asked for.

    bench/viscous_solve.py [--tetfarm build/release/bin/tetfarm] [--y-plus 30] [--reynolds 1e6] [--iterations 500]
                           [--subdomains 16] [--processes 2] [--keep FOLDER]

The wing is a NACA 0012 section of chord 1 m along a span of 2 m, with flat tips, in a sphere of ten times its size. The case
is that of examples/viscous_flow: simpleFoam with kOmegaSST and wall functions, in as many processes as the mesh is exported
in parts. --y-plus is asked for where the solver has its first value, at half the height of the first layer; the sides are
three strips along the chord, each with the first height of a flat plate at its own distance from the leading edge. Prints a
table in Markdown, of area and of faces; exit code 1 if y+ is within 30 % on less than 95 % of the area. Needs OpenFOAM (Debian: openfoam, openmpi-bin) and numpy.
"""

import argparse
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[1]
CASE = ROOT / "examples" / "viscous_flow"
# Where Debian puts what OpenFOAM looks up; without it no program of it starts.
ENVIRONMENT = {"WM_PROJECT_DIR": "/usr/share/openfoam", **os.environ}
CHORD, SPAN = 1.0, 2.0
TRAILING_EDGE = 0.01  # a sharp one makes prisms that lean along its wake
WANTED_SHARE = 95  # of the area, %
# Patches of the sides up to a share of the chord, and the distance from the leading edge whose friction gives the first height.
STRIPS = (("nose", 0.05, 0.025), ("front", 0.2, 0.125), ("wing", 1.0, 1.0))
PATCHES = (*(name for name, _, _ in STRIPS), "tip")


def half_thickness(x):
    """NACA 0012 with a closed trailing edge, and then opened to TRAILING_EDGE in proportion to x."""
    closed = 0.6 * (0.2969 * math.sqrt(x) + x * (-0.1260 + x * (-0.3516 + x * (0.2843 - 0.1036 * x))))
    return closed + TRAILING_EDGE / 2 * x


def stations(n):
    """Of n edges along the chord, as long on the surface at the leading edge as they are at the trailing edge, half of
    the longest."""
    t = [i / n for i in range(n + 1)]
    return [0.25 * (1 - math.cos(math.pi * s)) + 0.5 * (1 - math.cos(math.pi * s / 2)) for s in t]


def strip(lower, upper):
    """The triangles between two rows of points, each from the shorter of two diagonals."""
    triangles, i, j = [], 0, 0
    while i + 1 < len(lower) or j + 1 < len(upper):
        along_lower = math.dist(lower[i + 1], upper[j]) if i + 1 < len(lower) else math.inf
        along_upper = math.dist(lower[i], upper[j + 1]) if j + 1 < len(upper) else math.inf
        if along_lower <= along_upper:
            triangles.append((lower[i], lower[i + 1], upper[j]))
            i += 1
        else:
            triangles.append((lower[i], upper[j + 1], upper[j]))
            j += 1
    return triangles


def tip_row(x, y, spacing):
    """From the lower to the upper side; one point where the section is closed."""
    z = half_thickness(x)
    if x == 0:
        return [(x, y, 0.0)]
    n = max(1, round(2 * z / spacing))
    return [(x, y, -z)] + [(x, y, z * (2 * i / n - 1)) for i in range(1, n)] + [(x, y, z)]


def wing(n):
    """Triangles of each patch; n edges along the chord on either side."""
    x = stations(n)
    spacing = CHORD / n
    ring = [(s, -half_thickness(s)) for s in reversed(x)] + [(s, half_thickness(s)) for s in x[1:]]
    ring.append(ring[0])
    rows = [-SPAN / 2 + SPAN * i / round(SPAN / spacing) for i in range(round(SPAN / spacing) + 1)]
    sides = []
    for y0, y1 in zip(rows, rows[1:]):
        sides += strip([(a, y0, b) for a, b in ring], [(a, y1, b) for a, b in ring])
    tips = []
    for y in (rows[0], rows[-1]):
        columns = [tip_row(s, y, spacing) for s in x]
        for left, right in zip(columns, columns[1:]):
            tips += strip(left, right)
    patches = {name: [] for name in PATCHES}
    for triangle in sides:
        middle = sum(corner[0] for corner in triangle) / 3
        patches[next((name for name, end, _ in STRIPS if middle < end * CHORD), STRIPS[-1][0])].append(triangle)
    patches["tip"] = tips
    return patches


def write_stl(patches, file):
    lines = []
    for name, triangles in patches.items():
        lines.append(f"solid {name}")
        for triangle in triangles:
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += ["vertex {!r} {!r} {!r}".format(*corner) for corner in triangle]
            lines += ["endloop", "endfacet"]
        lines.append(f"endsolid {name}")
    file.write_text("\n".join([*lines, ""]), encoding="ascii")


def run(words, folder, log):
    """What it prints, and seconds; its output also goes to a file."""
    start = time.monotonic()
    done = subprocess.run([str(word) for word in words], cwd=folder, text=True, env=ENVIRONMENT,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    (folder / log).write_text(done.stdout, encoding="utf-8")
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, words))}: exit code {done.returncode}, log {folder / log}\n{done.stdout[-2000:]}")
    return done.stdout, time.monotonic() - start


def mesh(options, folder):
    """The result line of the run; exports it in parts for the solver."""
    write_stl(wing(options.chord_edges), folder / "wing.stl")
    layers = []
    for patch, length in (*((name, length) for name, _, length in STRIPS), ("tip", CHORD)):
        layers += ["--layers", f"{patch}:y_plus={2 * options.y_plus:g},reynolds={options.reynolds * length / CHORD:g},"
                   f"length={length:g},growth={options.growth:g},count={options.layers}"]
    said, seconds = run([options.tetfarm, "run", "wing.stl", "--outer", "sphere:10", *layers,
                         "--subdomains", options.subdomains, "-o", "out", "--json", "--progress", "none"],
                        folder, "log.tetfarm")
    run([options.tetfarm, "export", "out", "--partitions", options.processes, "--format", "openfoam-decomposed",
         "-o", "case"], folder, "log.export")
    return json.loads(said.splitlines()[-1]), seconds


def set_entry(file, name, value):
    """In a dictionary of one entry a line, leaving its comment."""
    text, found = re.subn(rf"(?m)^({name}\s+)[^;]+;", rf"\g<1>{value};", file.read_text(encoding="utf-8"))
    if found != 1:
        sys.exit(f"{file}: {found} entries {name}")
    file.write_text(text, encoding="utf-8")


def make_case(options, case):
    shutil.copytree(CASE, case, dirs_exist_ok=True)
    angle = math.radians(options.incidence)
    along, across = (f"({math.cos(angle):.9g} 0 {math.sin(angle):.9g})", f"({-math.sin(angle):.9g} 0 {math.cos(angle):.9g})")
    for name, value in (("velocity", along), ("drag", along), ("lift", across), ("viscosity", f"{1 / options.reynolds:g}"),
                        ("area", f"{CHORD * SPAN:g}")):
        set_entry(case / "flow", name, value)
    set_entry(case / "system" / "decomposeParDict", "numberOfSubdomains", options.processes)
    for name in ("endTime", "writeInterval"):
        set_entry(case / "system" / "controlDict", name, options.iterations)
    for i in range(options.processes):
        shutil.copytree(case / "0.orig", case / f"processor{i}" / "0")


def solve(options, case):
    """Seconds of the solver."""
    mpi = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", options.processes]
    run([*mpi, "changeDictionary", "-parallel"], case, "log.changeDictionary")
    run([*mpi, "checkMesh", "-parallel", "-allTopology"], case, "log.checkMesh")
    _, seconds = run([*mpi, "simpleFoam", "-parallel"], case, "log.simpleFoam")
    run([*mpi, "simpleFoam", "-parallel", "-postProcess", "-func", "yPlus", "-latestTime"], case, "log.yPlus")
    return seconds


def list_of(file):
    """The lines between the brackets of an OpenFOAM list."""
    lines = file.read_text(encoding="utf-8").splitlines()
    begin = next(i for i, line in enumerate(lines) if line == "(")
    count = int(lines[begin - 1])
    return lines[begin + 1:begin + 1 + count]


def patch_ranges(file):
    """First face and number of faces of each patch of the body."""
    text = file.read_text(encoding="utf-8")
    ranges = {}
    for name in PATCHES:
        body = re.search(rf"(?s)\b{name}\s*\{{(.*?)\}}", text).group(1)
        ranges[name] = tuple(int(re.search(rf"{key}\s+(\d+)", body).group(1)) for key in ("startFace", "nFaces"))
    return ranges


def patch_values(text, name, count):
    """The values of a scalar field on a patch."""
    if count == 0:
        return np.zeros(0)
    body = re.search(rf"(?s)\n\s*{name}\s*\{{(.*?)\}}", text).group(1)
    uniform = re.search(r"value\s+uniform\s+(\S+);", body)
    if uniform:
        return np.full(count, float(uniform.group(1)))
    return np.array(re.search(r"(?s)nonuniform\s+List<scalar>\s*\d+\s*\((.*?)\)", body).group(1).split(), float)


def wall_faces(processor, time_name):
    """y+, area and centre of each wall face of a processor."""
    polys = processor / "constant" / "polyMesh"
    points = np.array([line.strip("()").split() for line in list_of(polys / "points")], float)
    faces = list_of(polys / "faces")
    field = (processor / time_name / "yPlus").read_text(encoding="utf-8")
    field = field[field.index("boundaryField"):]
    found = []
    for name, (first, count) in patch_ranges(polys / "boundary").items():
        values = patch_values(field, name, count)
        corners = [[int(v) for v in re.findall(r"\d+", line)[1:4]] for line in faces[first:first + count]]
        at = points[np.array(corners, int).reshape(-1, 3)]
        area = np.linalg.norm(np.cross(at[:, 1] - at[:, 0], at[:, 2] - at[:, 0]), axis=1) / 2
        is_tip = np.full(count, name == "tip")
        found.append(np.column_stack([values, area, at.mean(axis=1), is_tip]))
    return np.concatenate(found)


def weighted_percentiles(values, weights, percentages):
    order = np.argsort(values)
    share = np.cumsum(weights[order]) / weights.sum()
    return [values[order][np.searchsorted(share, p / 100)] for p in percentages]


def shares_within(ratio, area):
    near = (ratio > 0.7) & (ratio < 1.3)
    return 100 * area[near].sum() / area.sum(), 100 * near.mean()


def table(faces, wanted):
    """Rows: of the whole wall and of zones along the chord."""
    ratio, area, x, y, is_tip = faces[:, 0] / wanted, faces[:, 1], faces[:, 2], faces[:, 3], faces[:, 5] > 0
    side = ~is_tip
    zones = {"whole wall": np.full(len(x), True), "sides of the wing": side,
             "sides, x < 0.05": side & (x < 0.05), "sides, 0.05 < x < 0.5": side & (x >= 0.05) & (x < 0.5),
             "sides, 0.5 < x < 0.95": side & (x >= 0.5) & (x < 0.95), "sides, x > 0.95": side & (x >= 0.95),
             "sides, within 0.1 of a tip": side & (abs(y) > SPAN / 2 - 0.1), "tips": is_tip}
    percentages = (1, 5, 25, 50, 75, 95, 99)
    print("| y+ over what was asked for | % of the area | within 30 %: % of its area | % of its faces | "
          + " | ".join(f"{p} %" for p in percentages) + " |")
    print("|---|" + "--:|" * (3 + len(percentages)))
    for name, here in zones.items():
        of_area, of_faces = shares_within(ratio[here], area[here])
        cells = [f"{100 * area[here].sum() / area.sum():.1f}", f"{of_area:.1f}", f"{of_faces:.1f}"]
        cells += [f"{v:.2f}" for v in weighted_percentiles(ratio[here], area[here], percentages)]
        print(f"| {name} | {' | '.join(cells)} |")


def coefficients(case):
    """Columns of forceCoeffs at every iteration, by name."""
    file = sorted((case / "postProcessing" / "coefficients").glob("*/coefficient*.dat"))[-1]
    lines = file.read_text(encoding="utf-8").splitlines()
    names = [line for line in lines if line.startswith("#")][-1].lstrip("# ").split()
    values = np.array([line.split() for line in lines if not line.startswith("#")], float)
    return {name: values[:, i] for i, name in enumerate(names)}


def last_residuals(text):
    found = {}
    for name, value in re.findall(r"Solving for (\w+), Initial residual = ([\d.e+-]+)", text):
        found[name] = float(value)
    return ", ".join(f"{name} {value:.1e}" for name, value in found.items())


def report(options, case, result, meshing, solving):
    times = [path.name for path in (case / "processor0").iterdir() if re.fullmatch(r"[1-9]\d*", path.name)]
    last = max(times, key=int)
    faces = np.concatenate([wall_faces(case / f"processor{i}", last) for i in range(options.processes)])
    print(f"mesh: {result['tets']} tets, {result.get('prisms', 0)} prisms, {result.get('pyramids', 0)} pyramids; "
          f"{len(faces)} wall faces; meshed in {meshing:.0f} s, solved in {solving:.0f} s, {last} iterations")
    check = (case / "log.checkMesh").read_text(encoding="utf-8")
    for line in re.findall(r"(?m)^.*(?:non-orthogonality Max|severely|skewness|aspect ratio|Mesh OK|Failed).*$", check):
        print("checkMesh:", line.strip())
    print("residuals:", last_residuals((case / "log.simpleFoam").read_text(encoding="utf-8")))
    forces = coefficients(case)
    for name in ("Cd", "Cl"):
        tail = forces[name][-50:]
        print(f"{name}: {forces[name][-1]:.5f}, over the last 50 iterations {tail.min():.5f} to {tail.max():.5f}")
    print(f"y+ asked for: {options.y_plus:g}; area-weighted mean {np.average(faces[:, 0], weights=faces[:, 1]):.3f}\n")
    table(faces, options.y_plus)
    return shares_within(faces[:, 0] / options.y_plus, faces[:, 1])[0]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tetfarm", type=pathlib.Path, default=ROOT / "build/release/bin/tetfarm")
    parser.add_argument("--y-plus", type=float, default=30)
    parser.add_argument("--reynolds", type=float, default=1e6)
    parser.add_argument("--incidence", type=float, default=0, help="degrees")
    parser.add_argument("--growth", type=float, default=1.2)
    parser.add_argument("--layers", type=int, default=10, help="how many")
    parser.add_argument("--chord-edges", type=int, default=28, help="edges along the chord, on either side")
    parser.add_argument("--iterations", type=int, default=500)
    parser.add_argument("--subdomains", type=int, default=16)
    parser.add_argument("--processes", type=int, default=2)
    parser.add_argument("--keep", type=pathlib.Path, help="a folder that is not there yet, for all files")
    options = parser.parse_args()
    options.tetfarm = options.tetfarm.resolve()
    missing = [name for name in ("mpirun", "checkMesh", "changeDictionary", "simpleFoam")
               if shutil.which(name) is None]
    if missing or not options.tetfarm.is_file():
        sys.exit(f"missing: {', '.join(missing) or options.tetfarm}")
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.keep or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=options.keep is None)
        result, meshing = mesh(options, folder)
        case = folder / "case"
        make_case(options, case)
        share = report(options, case, result, meshing, solve(options, case))
    if share < WANTED_SHARE:
        sys.exit(f"y+ is within 30 % of what was asked for on {share:.1f} % of the wall's area, less than {WANTED_SHARE} %")


if __name__ == "__main__":
    main()
