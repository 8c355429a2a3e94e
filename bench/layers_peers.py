#!/usr/bin/env python3
"""Gmsh's layers on shapes by formula, judged by what bench/layers.py judges ours by: a table in Markdown.

    bench/layers_peers.py [--tetfarm build/release/bin/tetfarm] [--case cube]... [--limit 300]

Gmsh runs in a process group of its own, with a limit of time and 8 GiB of address space; one that fails has its failure in
its row. Of each prism its scaled Jacobian over that of its wall triangle (bad: none above zero at some corner), and the normal
height of the first on each wall triangle. The tets are not judged but for the step to them. CPU seconds are the user's. Needs
Gmsh's module, numpy, h5py and prlimit.
"""

import argparse
import pathlib
import sys
import tempfile
import types

import numpy as np

import adapt
import layers

MEMORY = 8 << 30
# name: (surface, first height, growth, layers, side on which they stand)
CASES = {"cube": (layers.CUBE, 1e-3, 1.2, 15, -1), "spheres": (layers.SPHERES, 5e-4, 1.2, 20, 1)}


def first_heights(part, wall, first):
    """Normal heights of the prisms at the wall, over what was asked for."""
    p, q = part.places, part.prisms[np.unique(wall)]
    normal = np.cross(p[q[:, 1]] - p[q[:, 0]], p[q[:, 2]] - p[q[:, 0]])
    up = p[q[:, 3:]].mean(axis=1) - p[q[:, :3]].mean(axis=1)
    return np.abs(np.einsum("ij,ij->i", up, normal)) / np.linalg.norm(normal, axis=1) / first


def row_of(name, arguments, folder):
    surface, first, growth, count, side = CASES[name]
    file, out = layers.shape(arguments.tetfarm, surface, folder), folder / f"{name}.npz"
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


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tetfarm", default="build/release/bin/tetfarm")
    parser.add_argument("--case", action="append", choices=CASES, help="default: all")
    parser.add_argument("--limit", type=float, default=300, help="seconds by the clock")
    arguments = parser.parse_args()
    adapt.adopt_orphans()
    print("| Gmsh | prisms | tets | all layers, % of stacks | first height within 2 %, % | 10 %, % | bad prisms | "
          "Jacobian over the wall's, min | median | tet : last prism, median | CPU s | peak MB |")
    print("|---|" + "--:|" * 11)
    with tempfile.TemporaryDirectory() as temporary:
        for name in arguments.case or CASES:
            print(row_of(name, arguments, pathlib.Path(temporary)), flush=True)


if __name__ == "__main__":
    main()
