#!/usr/bin/env python3
"""What boundary layers come to on shapes by formula and on the models of TETFARM_DATA: a table.

    bench/layers.py [--tetfarm build/release/bin/tetfarm] [--case m6]... [--jobs 2] [--keep FOLDER] [--peers [--limit 300]]

Each case is a whole `tetfarm run`. Of its result line: how many wall triangles have all layers, and how many a first
height within 2 and 10 % of what was asked for. Of its mesh, read from the VTKHDF file and judged here: the scaled
Jacobian of each prism over that of a straight prism on its wall triangle (smallest, 1 %, median), and the height of the
tet on each last prism over that of the prism (median, 99 %). The smallest dihedral angle is that of the tets, with the
layers and of a second run without; MB are those of the largest task; B are those of the chunks, files between tasks, for
each triangle of the wall. With --peers other meshers follow in the same run, each with a limit of time
(bench/layers_peers.py). Needs numpy and h5py.
"""

import argparse
import datetime
import json
import os
import pathlib
import platform
import resource
import subprocess
import sys
import tempfile
import time

import h5py
import numpy as np

SPHERES, CUBE = "spheres", "cube"

# name: (surface, what is asked for, more options)
CASES = {
    "spheres": (SPHERES, "inner:first=5e-4,growth=1.2,count=20", []),
    "spheres-isotropic": (SPHERES, "inner:first=5e-4,growth=1.2", []),
    "cube": (CUBE, "*:first=1e-3,growth=1.2,count=15", []),
    "m6": ("onera_m6_sharp_te/onera_m6_sharp_te.msh.gz", "wing_*,te,tip:first=1e-4,growth=1.2,count=15", []),
    "d150": ("d150_aircraft/d150_aircraft.msh.gz", "aircraft:first=1e-3,growth=1.2,count=15", ["--outer", "box:3"]),
    "hull": ("dtc_hull/dtc_hull.off.gz", "surface:first=1e-4,growth=1.2,count=15", ["--outer", "box:3"]),
    "hull-isotropic": ("dtc_hull/dtc_hull.off.gz", "surface:first=1e-3,growth=1.25", ["--outer", "box:3"]),
    "prime": ("prime_open_duct/prime_open_duct.msh.gz", "pec:first=1e-4,growth=1.2,count=15", ["--outer", "box:3"]),
    "cessna": ("cessna210/cessna210.msh.gz", "surf0:first=1e-4,growth=1.2,count=15", ["--outer", "box:3"]),
    "almond": ("nasa_almond_tenth/NasaAlmondTenthWavelengthv2.stl", "*:first=1e-4,growth=1.2,count=10", ["--outer", "box:3"]),
}

TET, WEDGE = 10, 13


def shape(tetfarm, kind, folder):
    """A surface by formula."""
    file = folder / f"{kind}.stl"
    if kind == CUBE:
        file.write_text(cube(20), encoding="ascii")
    else:
        subprocess.run([tetfarm, "shape", "sphere-in-sphere", "--spacing", "0.06", "-o", file], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return file


def cube(n):
    """Of edge 1, with n edges along it, as the text of an STL file."""
    triangles = []
    for axis in range(3):
        for side in (0, n):
            for i in range(n):
                for j in range(n):
                    square = [np.roll((side, i + a, j + b), axis) / n for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                    if side == 0:
                        square.reverse()
                    triangles += [square[:3], [square[0], square[2], square[3]]]
    lines = ["solid cube"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex {} {} {}".format(*corner) for corner in triangle]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid cube", ""])


def run(command):
    """Its last line as JSON, CPU seconds with children, seconds by the clock."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    seconds = time.monotonic() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{done.stderr}{done.stdout}")
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return json.loads(done.stdout.splitlines()[-1]), cpu, seconds


class Part:
    """Cells of one sub-domain or chunk, by places and global numbers of nodes."""

    def __init__(self, group, points, cells, ids):
        types = group["Types"][cells[0]:cells[1]]
        offsets = group["Offsets"][cells[2]:cells[2] + cells[1] - cells[0] + 1]
        connectivity = group["Connectivity"][ids[0]:ids[1]]
        self.places = group["Points"][points[0]:points[1]]
        self.names = group["PointData/GlobalNodeId"][points[0]:points[1]]
        self.tets = self.of_type(types, offsets, connectivity, TET, 4)
        self.prisms = self.of_type(types, offsets, connectivity, WEDGE, 6)

    @staticmethod
    def of_type(types, offsets, connectivity, which, nodes):
        first = offsets[:-1][types == which]
        return connectivity[first[:, None] + np.arange(nodes)]


def parts_of(file):
    with h5py.File(file, "r") as opened:
        group = opened["VTKHDF"]
        point = cell = offset = number = 0
        for points, cells, numbers in zip(group["NumberOfPoints"][:], group["NumberOfCells"][:],
                                          group["NumberOfConnectivityIds"][:]):
            yield Part(group, (point, point + points), (cell, cell + cells, offset), (number, number + numbers))
            point, cell, offset, number = point + points, cell + cells, offset + cells + 1, number + numbers


def corners(places, triangle):
    """Smallest sine of an angle of each triangle."""
    sines = []
    for k in range(3):
        a = places[triangle[:, (k + 1) % 3]] - places[triangle[:, k]]
        b = places[triangle[:, (k + 2) % 3]] - places[triangle[:, k]]
        sines.append(np.linalg.norm(np.cross(a, b), axis=1) / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1))
    return np.min(sines, axis=0)


def wall_of(prisms):
    """Of each prism the one at the foot of its column: columns come one after the other, from the wall up."""
    follows = np.zeros(len(prisms), bool)
    follows[1:] = (prisms[1:, :3] == prisms[:-1, 3:]).all(axis=1)
    starts = np.flatnonzero(~follows)
    return starts[np.cumsum(~follows) - 1]


def relative_jacobians(part):
    prisms, p = part.prisms, part.places
    smallest = np.full(len(prisms), np.inf)
    for base, up in (((0, 1, 2), 3), ((3, 4, 5), -3)):
        for k in range(3):
            at = p[prisms[:, base[k]]]
            a = p[prisms[:, base[(k + 1) % 3]]] - at
            b = p[prisms[:, base[(k + 2) % 3]]] - at
            c = p[prisms[:, base[k] + up]] - at
            volume = np.einsum("ij,ij->i", np.cross(a, b), c) * (1 if up > 0 else -1)
            smallest = np.minimum(smallest, volume / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1)
                                  / np.linalg.norm(c, axis=1))
    if np.median(smallest) < 0:
        # VTK's wedges are turned the other way; the sign of the smallest is then that of the largest.
        return relative_jacobians_of_turned(part)
    return smallest / corners(p, prisms[:, :3])[wall_of(prisms)]


def relative_jacobians_of_turned(part):
    part.prisms = part.prisms[:, [0, 2, 1, 3, 5, 4]]
    return relative_jacobians(part)


def keys_of(names):
    return np.sort(names, axis=1)


def top_jumps(parts):
    """Height of the tet on a prism over that of the prism."""
    keys, heights = [], []
    for part in parts:
        if not len(part.prisms):
            continue
        p, prisms = part.places, part.prisms
        top = prisms[:, 3:]
        area = np.linalg.norm(np.cross(p[top[:, 1]] - p[top[:, 0]], p[top[:, 2]] - p[top[:, 0]]), axis=1) / 2
        middle = p[top].mean(axis=1) - p[prisms[:, :3]].mean(axis=1)
        normal = np.cross(p[top[:, 1]] - p[top[:, 0]], p[top[:, 2]] - p[top[:, 0]]) / (2 * area)[:, None]
        keys.append(keys_of(part.names[top]))
        heights.append(np.abs(np.einsum("ij,ij->i", middle, normal)))
    keys, heights = np.concatenate(keys), np.concatenate(heights)
    order = np.lexsort(keys.T)
    keys, heights = keys[order], heights[order]
    row = np.dtype((np.void, keys.dtype.itemsize * 3))
    known = np.ascontiguousarray(keys[:, ::-1].astype(">i8")).view(row).ravel()
    by_row = np.argsort(known)
    known, heights = known[by_row], heights[by_row]
    jumps = []
    for part in parts:
        p, tets = part.places, part.tets
        for k in range(4):
            face = np.delete(tets, k, axis=1)
            wanted = np.ascontiguousarray(keys_of(part.names[face])[:, ::-1].astype(">i8")).view(row).ravel()
            found = np.minimum(np.searchsorted(known, wanted), len(known) - 1)
            hit = known[found] == wanted
            a, b, c = (p[face[hit, i]] for i in range(3))
            normal = np.cross(b - a, c - a)
            height = np.abs(np.einsum("ij,ij->i", normal, p[tets[hit, k]] - a)) / np.linalg.norm(normal, axis=1)
            jumps.append(height / heights[found[hit]])
    return np.concatenate(jumps)


def bytes_of_chunks(out):
    """Of the files between tasks those that begin as chunks of layers do (store/formats.md)."""
    size = 0
    for file in (out / ".tetfarm").rglob("*"):
        if not file.is_file():
            continue
        with file.open("rb") as opened:
            size += file.stat().st_size if opened.read(8) == b"TFLAYR\r\n" else 0
    return size


def row_of(name, arguments, folder, data):
    surface, layers, options = CASES[name]
    if surface in (SPHERES, CUBE):
        file = shape(arguments.tetfarm, surface, folder)
    else:
        file = pathlib.Path(data) / surface
    out = folder / name
    job = [arguments.tetfarm, "run", file, "-j", str(arguments.jobs), "--json", *options]
    bare, _, _ = run([*job, "-o", folder / f"{name}-bare"])
    result, cpu, seconds = run([*job, "--layers", layers, "--keep", "all", "-o", out])
    mesh = next(out.glob("*.vtkhdf"))
    parts = list(parts_of(mesh))
    jacobians = np.concatenate([relative_jacobians(part) for part in parts if len(part.prisms)])
    jumps = top_jumps(parts)
    of = result["layers"]
    print(f"| {name} | {of['wall_triangles']} | {100 * of['full'] / of['wall_triangles']:.2f} | "
          f"{of['first_height_within_2_percent']:.2f} | {of['first_height_within_10_percent']:.2f} | "
          f"{result['prisms']} | {result['pyramids']} | {result['tets']} | {jacobians.min():.3f} | "
          f"{np.percentile(jacobians, 1):.3f} | {np.median(jacobians):.4f} | {np.median(jumps):.2f} | "
          f"{np.percentile(jumps, 99):.2f} | {result['min_dihedral_deg']:.2f} | {bare['min_dihedral_deg']:.2f} | "
          f"{max(task['bytes'] for task in result['tasks'].values()) / 1e6:.0f} | "
          f"{bytes_of_chunks(out) / of['wall_triangles']:.0f} | {cpu:.1f} | {seconds:.1f} | "
          f"{', '.join(f'{k} {v}' for k, v in of['by_reason'].items())} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tetfarm", default="build/release/bin/tetfarm")
    parser.add_argument("--case", action="append", choices=CASES, help="default: all")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the meshes (default: they go)")
    parser.add_argument("--peers", action="store_true", help="Gmsh and snappyHexMesh on the same cases, as far as they can")
    parser.add_argument("--limit", type=float, default=300, help="seconds by the clock for each case of a peer")
    arguments = parser.parse_args()
    data = os.environ.get("TETFARM_DATA")
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], stdout=subprocess.PIPE, text=True, check=False)
    print(f"{platform.node()}, {os.cpu_count()} cores, commit {commit.stdout.strip()}, "
          f"{datetime.date.today().isoformat()}\n")
    print("| case | wall triangles | all layers, % | first height within 2 %, % | 10 %, % | prisms | pyramids | tets | "
          "Jacobian over the wall's, min | 1 % | median | tet : last prism, median | 99 % | smallest dihedral, deg | "
          "without layers | MB | B per wall triangle | CPU s | s | why fewer |")
    print("|---|" + "--:|" * 18 + "---|")
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for name in arguments.case or CASES:
            if CASES[name][0] not in (SPHERES, CUBE) and not data:
                print(f"{name}: TETFARM_DATA is not set", file=sys.stderr)
                continue
            row_of(name, arguments, folder, data)
        if arguments.peers:
            import layers_peers  # which imports this
            layers_peers.print_rows(arguments, folder)


if __name__ == "__main__":
    main()
