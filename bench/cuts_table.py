#!/usr/bin/env python3
"""What cuts do to a mesh, for many surfaces and numbers of sub-domains: docs/measurements/2026-11-elements_near_cuts.md.

  TETFARM_DATA=... bench/cuts_table.py BUILD_FOLDER [--models pipe,flange] [--subdomains 4,16]

Each mesh is made by `tetfarm run` and checked by `tetfarm quality`. Elements near cuts (three layers) are set
beside all elements of the mesh of one sub-domain (of one a region) of the same job. What a run does not tell,
angles and estimates and processor seconds, comes from seams_trial, which does what the tasks do.
"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
MODELS = {
    "onera M6": ("onera_m6_sharp_te/onera_m6_sharp_te.msh.gz", "none"),
    "d150 in a box": ("d150_aircraft/d150_aircraft.msh.gz", "box:2"),
    "prime in a box": ("prime_open_duct/prime_open_duct.msh.gz", "box:2"),
    "hull in a box": ("dtc_hull/dtc_hull.off.gz", "box:2"),
    "almond in a box": ("nasa_almond_in_box/nasa_almond_in_box.msh", "none"),
    "flange": ("flange/flange.msh", "none"),
    "pipe": ("pipe/pipe.msh", "none"),
    "piece, 4 regions": ("gmsh_piece_4vol/gmsh_piece_4vol.msh", "none"),
    "sphere in sphere": ("shape:sphere-in-sphere:0.08", "none"),
    "trihedral": ("shape:corner-reflector:0.1", "none"),
    "duct": ("shape:duct:0.06", "none"),
}
CUTS = re.compile(r" (\d+) cuts, (\d+) not made, (\d+) planes tried, smallest angle ([\d.]+), ([\d.]+) s")
ESTIMATE = re.compile(r" estimate (\d+), worst leaf ([+-][\d.]+) %")
MESHED = re.compile(r" (\d+) leaves, meshed in ([\d.]+) s")
TURNS = re.compile(r"largest region \d+ tets, ([\d.]+) s")


def surface_of(build, where, folder):
    if not where.startswith("shape:"):
        return pathlib.Path(os.environ["TETFARM_DATA"]) / where
    _, kind, spacing = where.split(":")
    path = pathlib.Path(folder) / f"{kind}.off"
    subprocess.run([build / "bin/tetfarm", "shape", kind, "-o", path, "--spacing", spacing], check=True,
                   stdout=subprocess.DEVNULL)
    return path


def run(build, surface, outer, subdomains, workers):
    """The result's JSON; stops when a mesh fails or is not valid."""
    with tempfile.TemporaryDirectory(prefix="tetfarm_cuts.") as out:
        command = [build / "bin/tetfarm", "run", surface, "--subdomains", str(subdomains), "--outer", outer,
                   "-o", out, "-j", str(workers), "--json", "--progress", "none"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise SystemExit(f"{surface} {subdomains}: exit {done.returncode}\n{done.stderr}")
        subprocess.run([build / "bin/tetfarm", "quality", out], check=True, stdout=subprocess.DEVNULL)
        return json.loads(done.stdout.strip().splitlines()[-1])


def trial(build, surface, outer, subdomains):
    command = [build / "bin/seams_trial", surface, str(subdomains)]
    if outer != "none":
        command += ["--box", outer.split(":")[1]]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    if "INVALID" in text or "LOST" in text:
        raise SystemExit(text)
    cuts, estimate = CUTS.search(text), ESTIMATE.search(text)
    cutting = float(cuts[5])
    seconds = cutting + float(MESHED.search(text)[2]) + float(TURNS.search(text)[1])
    return cuts[4], float(estimate[1]), estimate[2], 100 * cutting / seconds


def row(name, subdomains, mesh, whole, others):
    near = mesh["near_cuts"]
    if near is None:
        return f"| {name} | {subdomains} | {mesh['subdomains']} | no cuts | | | | | | |"
    uncut = len(mesh["uncut_subdomains"])
    angle, height = near["min_dihedral_deg"], near["smallest_height"]
    text = (f"| {name} | {subdomains} | {mesh['subdomains']} | {uncut} | "
            f"{mesh['elements']} ({100 * mesh['elements'] / whole['elements'] - 100:+.1f} %) | "
            f"{angle:.1f} of {whole['min_dihedral_deg']:.1f}: {100 * angle / whole['min_dihedral_deg']:.0f} % | "
            f"{height:.3g} of {whole['smallest_height']:.3g}: {100 * height / whole['smallest_height']:.0f} % | ")
    if others is None:
        return text + "| | |"
    degrees, estimate, worst, share = others
    return (text + f"{degrees}° | {100 * estimate / mesh['elements'] - 100:+.1f} %, {worst} % | {share:.0f} % |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--models", default=",".join(MODELS))
    parser.add_argument("--subdomains", default="4,16,64,256")
    options = parser.parse_args()
    build = options.build.resolve()
    names = [next(n for n in MODELS if n.startswith(wanted)) for wanted in options.models.split(",")
             if wanted.strip()] if options.models != ",".join(MODELS) else list(MODELS)
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True,
                            text=True, check=False).stdout.strip()
    print(f"commit {commit}, {os.uname().machine}, {os.cpu_count()} cores\n")
    print("| surface | wanted | made | not cut | elements (to uncut) | smallest dihedral near cuts, ° | "
          "smallest height near cuts | cuts to the surface | estimate: all, worst leaf | cutting |")
    print("|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|", flush=True)
    for name in names:
        where, outer = MODELS[name]
        with tempfile.TemporaryDirectory() as folder:
            surface = surface_of(build, where, folder)
            whole = run(build, surface, outer, 1, 1)
            for subdomains in map(int, options.subdomains.split(",")):
                mesh = run(build, surface, outer, subdomains, 1)
                has_regions = bool(mesh["regions"])
                others = None if has_regions else trial(build, surface, outer, subdomains)
                print(row(name, subdomains, mesh, whole, others), flush=True)


if __name__ == "__main__":
    sys.exit(main())
