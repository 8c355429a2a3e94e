#!/usr/bin/env python3
"""The solver of an adaptation loop: rhoCentralFoam on the mesh of a cycle, from the solution that was brought along.

    flow.py --mach M --alpha DEG --steps N

The mesh is case/constant/polyMesh, one layer of prisms, as the loop writes it where the job says `mesh = "case/"`. What the solver
reads and leaves at vertices are the Mach number, the density, both components of the velocity, and the pressure. The gas is scaled:
far away pressure, temperature and speed of sound are 1. cp.sol has the pressure coefficient at the vertices, cp.csv at the sides of
the wall; lift, drag and shocks are printed.
"""

import argparse
import math
import os
import pathlib
import re
import subprocess
import sys

CASE = pathlib.Path("case")
GAMMA = 1.4
REPORTS = 4  # how often the forces are printed: steady if they are the same


class Layer:
    """The triangles at z = 0 of a layer of prisms, and the sides of its walls."""

    def __init__(self, poly_mesh):
        points = [tuple(map(float, line.strip("() ").split())) for line in entries(poly_mesh / "points")]
        faces = [tuple(map(int, line[line.index("(") + 1 : line.index(")")].split())) for line in entries(poly_mesh / "faces")]
        owner = list(map(int, entries(poly_mesh / "owner")))
        self.points = [(x, y) for x, y, _ in points[: len(points) // 2]]
        lying = [face for face in faces if len(face) == 3]
        self.cells = lying[: len(lying) // 2]
        self.centres = [mean2([self.points[v] for v in cell]) for cell in self.cells]
        self.patches = dict()  # name: is it a wall
        self.walls = []  # of each wall its sides: cell, start and end; the flow is on the left
        text = (poly_mesh / "boundary").read_text()
        for name, body in re.findall(r"(\w+)\s*\{([^}]*)\}", text[text.index("(") :]):
            kind, count, start = (re.search(rf"\b{key}\s+(\w+);", body)[1] for key in ("type", "nFaces", "startFace"))
            if kind == "empty":
                continue
            self.patches[name] = kind == "wall"
            if kind == "wall":
                sides = range(int(start), int(start) + int(count))
                self.walls.append([(owner[f], self.points[faces[f][0]], self.points[faces[f][1]]) for f in sides])

    def cells_at_vertices(self):
        cells_at = [[] for _ in self.points]
        for number, cell in enumerate(self.cells):
            for vertex in cell:
                cells_at[vertex].append(number)
        return cells_at


def entries(path):
    """The lines of OpenFOAM's list."""
    text = path.read_text()
    start = re.search(r"\n(\d+)\s*\n\(\n", text)
    return text[start.end() :].split("\n", int(start[1]))[:-1]


def mean2(points):
    return tuple(sum(values) / len(points) for values in zip(*points))


def read_solution(path):
    """Rows of numbers, one a vertex, of Medit's .sol."""
    lines = iter(pathlib.Path(path).read_text().split("\n"))
    while next(lines).strip() != "SolAtVertices":
        pass
    count = int(next(lines))
    next(lines)  # how many numbers of which kinds
    return [tuple(map(float, next(lines).split())) for _ in range(count)]


def write_solution(path, rows):
    with open(path, "w", encoding="ascii") as out:
        out.write(f"MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n{len(rows)}\n{len(rows[0])}{' 1' * len(rows[0])}\n")
        out.writelines(" ".join(map(repr, row)) + "\n" for row in rows)
        out.write("End\n")


def write_field(layer, name, dimensions, cells, far, far_condition, wall_condition):
    """`cells`: the value of each cell as OpenFOAM has it, none for `far` everywhere."""
    kind = "vector" if far.startswith("(") else "scalar"
    inner = f"nonuniform List<{kind}>\n{len(cells)}\n(\n" + "\n".join(cells) + "\n)" if cells else f"uniform {far}"
    conditions = "".join(
        f"  {patch} {{ {wall_condition if is_wall else far_condition.format(far)} }}\n" for patch, is_wall in layer.patches.items()
    )
    (CASE / "0" / name).write_text(
        f"FoamFile {{ version 2.0; format ascii; class vol{kind.capitalize()}Field; object {name}; }}\n"
        f"dimensions [{dimensions}];\ninternalField {inner};\n"
        f"boundaryField\n{{\n{conditions}  frontAndBack {{ type empty; }}\n}}\n"
    )


def write_start(layer, start, flow):
    """The fields at step 0: the mean of `start` over the vertices of each cell, or the flow far away."""
    cells = [mean2([start[v] for v in cell]) for cell in layer.cells] if start else []
    (CASE / "0").mkdir()
    write_field(layer, "p", "1 -1 -2 0 0 0 0", [repr(p) for _, _, _, _, p in cells], "1",
                "type freestreamPressure; freestreamValue uniform {0}; value uniform {0};", "type zeroGradient;")
    write_field(layer, "T", "0 0 0 1 0 0 0", [repr(GAMMA * p / density) for _, density, _, _, p in cells], "1",
                "type inletOutlet; inletValue uniform {0}; value uniform {0};", "type zeroGradient;")
    write_field(layer, "U", "0 1 -1 0 0 0 0", [f"({u!r} {v!r} 0)" for _, _, u, v, _ in cells],
                f"({flow.mach * flow.along[0]!r} {flow.mach * flow.along[1]!r} 0)",
                "type freestreamVelocity; freestreamValue uniform {0}; value uniform {0};", "type slip;")


def run_foam(steps):
    (CASE / "steps").write_text(f"endTime {steps};\nwriteInterval {steps // REPORTS};\n")
    environment = {"WM_PROJECT_DIR": "/usr/share/openfoam"} | os.environ  # where Debian has it
    with open("foam.log", "w", encoding="utf-8") as log:
        ended = subprocess.run(["rhoCentralFoam", "-case", str(CASE)], env=environment, stdout=log, stderr=log, check=False)
    if ended.returncode != 0:
        sys.exit("rhoCentralFoam failed:\n" + "\n".join(pathlib.Path("foam.log").read_text(encoding="utf-8").split("\n")[-20:]))


def cell_values(step, name):
    return [tuple(map(float, line.strip("() ").split())) for line in entries(CASE / str(step) / name)]


def solution_of_cells(step):
    """Mach number, density, velocity and pressure of each cell."""
    rows = []
    for (p,), (temperature,), (u, v, _) in zip(*(cell_values(step, name) for name in ("p", "T", "U"))):
        rows.append((math.hypot(u, v) / math.sqrt(temperature), GAMMA * p / temperature, u, v, p))
    return rows


def at_vertices(layer, rows):
    """The plane that fits the cells round a vertex best, at the vertex, but within the values of these cells."""
    cells_at = layer.cells_at_vertices()
    result = []
    for vertex, (x, y) in enumerate(layer.points):
        near = cells_at[vertex]
        round_it = near
        if len(near) < 5:  # at the boundary, most often
            round_it = sorted({c for cell in near for v in layer.cells[cell] for c in cells_at[v]})
        weights = weights_of_fit([(layer.centres[c][0] - x, layer.centres[c][1] - y) for c in round_it])
        fitted = [sum(w * rows[c][k] for w, c in zip(weights, round_it)) for k in range(len(rows[0]))]
        bounds = [(min(values), max(values)) for values in zip(*(rows[c] for c in round_it))]
        result.append(tuple(min(max(f, low), high) for f, (low, high) in zip(fitted, bounds)))
    return result


def weights_of_fit(offsets):
    """The share of the value at each offset in the value at (0, 0) of the plane of least squares."""
    n = len(offsets)
    mx, my = mean2(offsets)
    centred = [(x - mx, y - my) for x, y in offsets]
    xx, xy, yy = (sum(a[i] * a[j] for a in centred) for i, j in ((0, 0), (0, 1), (1, 1)))
    determinant = xx * yy - xy * xy
    if determinant <= 1e-9 * xx * yy:
        return [1 / n] * n
    gx, gy = (yy * mx - xy * my) / determinant, (xx * my - xy * mx) / determinant
    return [1 / n - gx * x - gy * y for x, y in centred]


class Flow:
    def __init__(self, mach, alpha_deg):
        self.mach = mach
        self.head = 0.5 * GAMMA * mach**2
        self.along = (math.cos(math.radians(alpha_deg)), math.sin(math.radians(alpha_deg)))

    def wall_pressure(self, wall, rows):
        """Middle, pressure coefficient, and the way along each side of a wall."""
        return [(mean2([a, b]), self.pressure_coefficient(rows[cell]), (b[0] - a[0], b[1] - a[1])) for cell, a, b in wall]

    def pressure_coefficient(self, row):
        return (row[-1] - 1) / self.head

    def forces(self, wall):
        """Coefficients of lift and drag, for a chord of 1."""
        fx = sum(cp * way[1] for _, cp, way in wall)
        fy = -sum(cp * way[0] for _, cp, way in wall)
        return fy * self.along[0] - fx * self.along[1], fx * self.along[0] + fy * self.along[1]


def shock(side):
    """Place, and length from 10 to 90 % of the rise of pressure, of the steepest rise along a side of (x, cp)."""
    steepest = max(range(len(side) - 1), key=lambda i: (side[i + 1][1] - side[i][1]) / max(side[i + 1][0] - side[i][0], 1e-9))
    near = [point for point in side if abs(point[0] - side[steepest][0]) < 0.08]
    low = min(cp for x, cp in near if x <= side[steepest][0])
    high = max(cp for x, cp in near if x > side[steepest][0])

    def place(share):
        wanted = low + share * (high - low)
        for (x0, c0), (x1, c1) in zip(near, near[1:]):
            if c0 <= wanted < c1:
                return x0 + (wanted - c0) / (c1 - c0) * (x1 - x0)
        return math.nan

    return place(0.5), place(0.9) - place(0.1), high - low


def shocks(wall):
    """In words, on both sides of a profile, away from its ends."""
    nose = min(x for (x, _), _, _ in wall)
    chord = max(x for (x, _), _, _ in wall) - nose
    words = ""
    for name, sign in (("upper", 1), ("lower", -1)):
        side = sorted((x, cp) for (x, _), cp, way in wall if way[0] * sign > 0 and 0.05 < (x - nose) / chord < 0.97)
        words += "; {} shock at {:.5f}, {:.5f} wide, jump {:.3f}".format(name, *shock(side))
    return words


def report(layer, flow, steps):
    for number in range(1, REPORTS + 1):
        step = number * (steps // REPORTS)
        rows = solution_of_cells(step)
        walls = [flow.wall_pressure(wall, rows) for wall in layer.walls]
        lift, drag = flow.forces(sum(walls, []))
        print(f"step {step}: CL {lift:.5f}, CD {drag:.5f}" + "".join(map(shocks, walls)))
    with open("cp.csv", "w", encoding="ascii") as out:
        out.write("x,y,cp\n")
        out.writelines(f"{x!r},{y!r},{cp!r}\n" for wall in walls for (x, y), cp, _ in sorted(wall))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--mach", type=float, required=True)
    parser.add_argument("--alpha", type=float, required=True, help="angle of attack in degrees")
    parser.add_argument("--steps", type=int, default=6000)
    options = parser.parse_args()
    flow = Flow(options.mach, options.alpha)
    layer = Layer(CASE / "constant" / "polyMesh")
    start = os.environ["TETFARM_START"]
    write_start(layer, read_solution(start) if start else None, flow)
    steps = options.steps // REPORTS * REPORTS
    run_foam(steps)
    report(layer, flow, steps)
    solution = at_vertices(layer, solution_of_cells(steps))
    write_solution("cp.sol", [(flow.pressure_coefficient(row),) for row in solution])
    write_solution(os.environ["TETFARM_SOLUTION"], solution)


if __name__ == "__main__":
    main()
