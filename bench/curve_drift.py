#!/usr/bin/env python3
"""How far nodes of the boundary come away from its true curve over many cycles of `tetfarm adapt`.

NACA 0012 with a sharp trailing edge in a round far field: loops by the formulas, `tetfarm plane`, then cycles on an
analytic field whose shock wanders, without --curve, with the profile and the circle, and with splines of the first
loops. Each cycle tells the farthest node from the formula (by Newton here, not by code of the program), the area of
the mesh, and the area between its true curves as the nodes give it: the mesh, and the segments between its boundary
edges and the curves.

usage: curve_drift.py TETFARM [--cycles N] [--vertices N] [--folder DIR]
"""

import argparse
import math
import pathlib
import subprocess

RADIUS = 20.0
COEFFICIENTS = ((0.2969, 1), (-0.1260, 2), (-0.3516, 4), (0.2843, 6), (-0.1036, 8))  # powers of s = sqrt(x)
GAUSS = ((-0.906179845938664, 0.236926885056189), (-0.538469310105683, 0.478628670499366), (0.0, 0.568888888888889),
         (0.538469310105683, 0.478628670499366), (0.906179845938664, 0.236926885056189))


def profile(s):
    """x and y at s, and their derivatives."""
    u = abs(s)
    y = 0.6 * sum(c * u**k for c, k in COEFFICIENTS)
    slope = 0.6 * sum(c * k * u**(k - 1) for c, k in COEFFICIENTS)
    return s * s, math.copysign(y, s), 2 * s, slope


def root_near(x, y):
    """s of the place of the profile nearest to the point."""
    def squared(s):
        return (profile(s)[0] - x)**2 + (profile(s)[1] - y)**2
    s = min((k / 500 - 1 for k in range(1001)), key=squared)
    for _ in range(60):
        px, py, dx, dy = profile(s)
        step = ((px - x) * dx + (py - y) * dy) / (dx * dx + dy * dy)
        s = max(-1.0, min(1.0, s - step))
        if abs(step) < 1e-16:
            break
    return s


def segment_of_profile(a, b):
    """The signed area between the profile from s = a to b and its chord."""
    area = 0.0
    parts = 8
    for part in range(parts):
        low, high = a + (b - a) * part / parts, a + (b - a) * (part + 1) / parts
        for place, weight in GAUSS:
            x, y, dx, dy = profile((low + high) / 2 + place * (high - low) / 2)
            area += weight * (high - low) / 2 * (x * dy - y * dx) / 2
    (ax, ay), (bx, by) = profile(a)[:2], profile(b)[:2]
    return area - (ax * by - bx * ay) / 2


def read_mesh(path):
    words = path.read_text().split()
    sections = {}
    for name, width in (("Vertices", 3), ("Edges", 3), ("Triangles", 4)):
        at = words.index(name)
        count = int(words[at + 1])
        rows = words[at + 2:at + 2 + count * width]
        sections[name] = [rows[i:i + width] for i in range(0, len(rows), width)]
    points = [(float(x), float(y)) for x, y, _ in sections["Vertices"]]
    edges = [(int(a) - 1, int(b) - 1, int(p)) for a, b, p in sections["Edges"]]
    return points, edges, [tuple(int(v) - 1 for v in row[:3]) for row in sections["Triangles"]]


def cross(p, q):
    return p[0] * q[1] - p[1] * q[0]


def measured(path):
    points, edges, triangles = read_mesh(path)
    mesh_area = math.fsum((cross(points[a], points[b]) + cross(points[b], points[c]) + cross(points[c], points[a])) / 2
                          for a, b, c in triangles)
    off_profile = off_circle = 0.0
    corrections = []
    roots = {}
    for a, b, patch in edges:
        for v in (a, b):
            x, y = points[v]
            if patch == 2:
                off_circle = max(off_circle, abs(math.hypot(x, y) - RADIUS))
                continue
            if v not in roots:
                roots[v] = root_near(x, y)
                px, py = profile(roots[v])[:2]
                off_profile = max(off_profile, math.hypot(px - x, py - y))
        if patch == 2:
            turn = math.atan2(abs(cross(points[a], points[b])), points[a][0] * points[b][0] + points[a][1] * points[b][1])
            corrections.append(RADIUS * RADIUS * (turn - math.sin(turn)) / 2)
        else:
            # At the trailing edge s is 1 or -1: that of the side on which the edge lies.
            s, t = (1.0 if abs(r) == 1 and points[w][1] > 0 else -1.0 if abs(r) == 1 else r
                    for r, w in ((roots[a], b), (roots[b], a)))
            corrections.append(-abs(segment_of_profile(s, t)))
    return off_profile, off_circle, mesh_area, math.fsum([mesh_area] + corrections), len(points)


def write_loops(folder):
    n = 100
    roots = [math.copysign(math.sqrt(0.5 * (1 - math.cos(math.pi * i / n))), i) for i in range(-n, n)]
    airfoil = [profile(s)[:2] for s in roots]
    airfoil[0] = (1.0, 0.0)
    circle = [(RADIUS * math.cos(2 * math.pi * k / 60), RADIUS * math.sin(2 * math.pi * k / 60)) for k in range(60)]
    for name, loop in (("airfoil.xy", airfoil), ("farfield.xy", circle)):
        (folder / name).write_text("".join(f"{x!r} {y!r}\n" for x, y in loop))


def write_field(mesh, path, cycle):
    points = read_mesh(mesh)[0]
    shift = 0.5 + 0.25 * math.sin(1.7 * cycle)
    values = [math.tanh(30 * (x - shift - 0.2 * y * y)) * math.exp(-(x - 0.5)**2 - y * y) + 0.1 * math.exp(-x * x - 9 * y * y)
              for x, y in points]
    path.write_text("MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n%d\n1 1\n" % len(values) +
                    "".join(f"{value!r}\n" for value in values) + "End\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tetfarm")
    parser.add_argument("--cycles", type=int, default=20)
    parser.add_argument("--vertices", type=int, default=3000)
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("curve_drift"))
    options = parser.parse_args()
    folder = options.folder
    folder.mkdir(parents=True, exist_ok=True)
    write_loops(folder)
    loops = [str(folder / "airfoil.xy"), str(folder / "farfield.xy")]
    subprocess.run([options.tetfarm, "plane", *loops, "-o", folder / "first.mesh"], check=True, stdout=subprocess.DEVNULL)
    wanted = {"without": [], "formula": ["--curve", "1=naca0012", "--curve", "2=circle"],
              "spline": ["--curve", f"1=spline:{loops[0]}", "--curve", f"2=spline:{loops[1]}"]}
    exact = math.pi * RADIUS**2 + segment_of_profile(0, 1) - segment_of_profile(0, -1)
    print(f"area between the true curves {exact!r}")
    print("| curves | cycle | vertices | off the profile | off the circle | area of the mesh | area by the curves, less the true one |")
    print("|---|--:|--:|--:|--:|--:|--:|")
    for name, extra in wanted.items():
        mesh = folder / f"{name}.mesh"
        mesh.write_bytes((folder / "first.mesh").read_bytes())
        for cycle in range(options.cycles + 1):
            if cycle > 0:
                write_field(mesh, folder / "flow.sol", cycle)
                subprocess.run([options.tetfarm, "adapt", mesh, "--solution", folder / "flow.sol", "--vertices",
                                str(options.vertices), *extra, "-o", mesh], check=True, stdout=subprocess.DEVNULL)
            off_profile, off_circle, area, whole, vertices = measured(mesh)
            print(f"| {name} | {cycle} | {vertices} | {off_profile:.1e} | {off_circle:.1e} | {area:.9f} | {whole - exact:.1e} |", flush=True)


if __name__ == "__main__":
    main()
