#!/usr/bin/env python3
"""Gmsh's and snappyHexMesh's layers, judged by what bench/layers.py judges ours by: tables in Markdown.

    bench/layers.py --peers, or bench/layers_peers.py [--tetfarm build/release/bin/tetfarm] [--case cube]... [--limit 300]

Each runs in a process group of its own, with a limit of time and 8 GiB of address space; one that fails has its failure in
its row. Of each prism of Gmsh's its scaled Jacobian over that of its wall triangle (bad: none above zero at some corner), and
the normal height of the first on each wall triangle. The tets are not judged but for the step to them. snappyHexMesh makes
polyhedra on a surface mesh of its own, and is told by its own report. CPU seconds are the user's. Needs Gmsh's module, numpy,
h5py, prlimit and Debian's openfoam.
"""

import argparse
import fnmatch
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import types

import numpy as np

import adapt
import layers
import layers_by_snappy

MEMORY = 8 << 30
# name: (surface, first height, growth, layers, side on which they stand)
CASES = {"cube": (layers.CUBE, 1e-3, 1.2, 15, -1), "spheres": (layers.SPHERES, 5e-4, 1.2, 20, 1),
         "d150": ("d150_aircraft/d150_aircraft.msh.gz", 1e-3, 1.2, 15, 1)}
# name: (surface, patterns of the patches with layers, whether they end at the lowest y, heights)
BODIES = {"m6": ("onera_m6_sharp_te/onera_m6_sharp_te.msh.gz", ("wing_*", "te", "tip"), True, (1e-4, 1.2, 15)),
          "d150": ("d150_aircraft/d150_aircraft.msh.gz", ("aircraft",), False, (1e-3, 1.2, 15))}
# Of the box that Gmsh gets round a body, in the unit of the surface.
BOX_MARGIN = 30
BOX_EDGE = 5


def converted(arguments, surface, folder, options=()):
    file = folder / (pathlib.Path(surface).name.split(".")[0] + ("-in-box" if options else "") + ".stl")
    subprocess.run([arguments.tetfarm, "convert", pathlib.Path(os.environ["TETFARM_DATA"]) / surface, file, *options], check=True,
                   stdout=subprocess.DEVNULL)
    return file


def patches_of(stl, patterns):
    """A file of the solids whose names match."""
    solids = re.findall(r"^solid (.*?)$(.*?)^endsolid.*?$", stl.read_text(encoding="ascii"), re.MULTILINE | re.DOTALL)
    file = stl.with_name("wall.stl")
    file.write_text("".join(f"solid wall{text}endsolid wall\n" for name, text in solids
                            if any(fnmatch.fnmatch(name, pattern) for pattern in patterns)), encoding="ascii")
    return file


def first_heights(part, wall, first):
    """Normal heights of the prisms at the wall, over what was asked for."""
    p, q = part.places, part.prisms[np.unique(wall)]
    normal = np.cross(p[q[:, 1]] - p[q[:, 0]], p[q[:, 2]] - p[q[:, 0]])
    up = p[q[:, 3:]].mean(axis=1) - p[q[:, :3]].mean(axis=1)
    return np.abs(np.einsum("ij,ij->i", up, normal)) / np.linalg.norm(normal, axis=1) / first


def row_of(name, arguments, folder):
    surface, first, growth, count, side = CASES[name]
    out = folder / f"{name}.npz"
    if surface in (layers.CUBE, layers.SPHERES):
        file = layers.shape(arguments.tetfarm, surface, folder)
    else:
        file = converted(arguments, surface, folder, ["--box", str(BOX_MARGIN), "--box-size", str(BOX_EDGE)])
    script = pathlib.Path(__file__).with_name("layers_by_gmsh.py")
    command = ["prlimit", f"--as={MEMORY}", sys.executable, script, file, first, growth, count, side, out]
    try:
        run = adapt.run([str(word) for word in command], folder, out, arguments.limit)
    except adapt.Failed as failure:
        return f"| {name} | no mesh: {failure} " + "| " * 10 + "|"
    mesh = np.load(out)
    part = types.SimpleNamespace(places=mesh["places"], names=np.arange(len(mesh["places"])), tets=mesh["tets"],
                                 prisms=mesh["prisms"])
    jacobians = layers.relative_jacobians(part)
    wall = layers.wall_of(part.prisms)
    ratio = first_heights(part, wall, first)
    full = 100 * (np.unique(wall, return_counts=True)[1] == count).mean()
    near = [100 * (abs(ratio - 1) <= share).mean() for share in (0.02, 0.1)]
    jumps = layers.top_jumps([part])
    return (f"| {name} | {len(part.prisms)} | {len(part.tets)} | {full:.2f} | {near[0]:.2f} | {near[1]:.2f} | "
            f"{(jacobians <= 0).sum()} | {jacobians.min():.3f} | {np.median(jacobians):.4f} | {np.median(jumps):.2f} | "
            f"{run.cpu:.1f} | {run.peak_bytes / 1e6:.0f} |")


def row_of_snappy(name, arguments, folder):
    surface, patterns, plane, heights = BODIES[name]
    wall = patches_of(converted(arguments, surface, folder), patterns)
    own = folder / f"snappy-{name}"
    own.mkdir()
    try:
        faces, mean, share, cells, run = layers_by_snappy.layers_of(wall, plane, heights, own, arguments.limit, MEMORY)
    except adapt.Failed as failure:
        return f"| {name} | no mesh: {failure} " + "| " * 5 + "|"
    return f"| {name} | {faces} | {mean:.2f} of {heights[2]} | {share:.1f} | {cells} | {run.cpu:.1f} | {run.peak_bytes / 1e6:.0f} |"


def print_rows(arguments, folder):
    """Of the cases that are asked for those that a peer has."""
    folder = folder.resolve()
    arguments.tetfarm = pathlib.Path(arguments.tetfarm).resolve()
    adapt.adopt_orphans()
    names = arguments.case or [*CASES, *BODIES]
    print("\n| Gmsh | prisms | tets | all layers, % of stacks | first height within 2 %, % | 10 %, % | bad prisms | "
          "Jacobian over the wall's, min | median | tet : last prism, median | CPU s | peak MB |")
    print("|---|" + "--:|" * 11)
    for name in CASES:
        if name in names:
            print(row_of(name, arguments, folder), flush=True)
    print("\n| snappyHexMesh | faces at the body | layers, mean | thickness over what was asked for, % | cells | CPU s | peak MB |")
    print("|---|" + "--:|" * 6)
    for name in BODIES:
        if name in names:
            print(row_of_snappy(name, arguments, folder), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tetfarm", default="build/release/bin/tetfarm")
    parser.add_argument("--case", action="append", choices=sorted({*CASES, *BODIES}), help="default: all")
    parser.add_argument("--limit", type=float, default=300, help="seconds by the clock")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        print_rows(arguments, pathlib.Path(temporary))


if __name__ == "__main__":
    main()
