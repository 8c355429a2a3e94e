#!/usr/bin/env python3
"""Elements near cuts beside the uncut mesh, for many surfaces and numbers of sub-domains: docs/measurements/2026-11-elements_near_cuts.md.

usage: seams.py BUILD_FOLDER [--models a,b] [--subdomains 4,16] [-- OPTION...]
With TETFARM_DATA set; needs the programs seams_trial, which gets the options, and tetfarm. Prints tables in Markdown;
what is below 95 % of the uncut mesh is set in bold. A mesh that is not valid ends it.
"""

import argparse
import os
import pathlib
import re
import subprocess
import tempfile

LINE = re.compile(r"^  (uncut|seams before|seams after|all after) +(\d+) tets +min dihedral +([\d.]+) .*"
                  r"height ([\d.e+-]+) \(.*mean ratio ([\d.]+)", re.M)
CUTS = re.compile(r" (\d+) cuts, \d+ not made, \d+ planes tried, smallest angle ([\d.]+)")
LEAVES = re.compile(r"^ (\d+) leaves, meshed in ([\d.]+) s", re.M)
ESTIMATE = re.compile(r" estimate (\d+), worst leaf ([+-][\d.]+) %")
TAKEN = re.compile(r"^  (\d+) tets taken", re.M)
TURNS = re.compile(r"^  (\d+) colours, at most (\d+) neighbours, largest region (\d+) tets, ([\d.]+) s", re.M)

MODELS = {
    "onera M6": ("onera_m6_sharp_te/onera_m6_sharp_te.msh.gz", []),
    "d150 in a box": ("d150_aircraft/d150_aircraft.stl", ["--box", "2"]),
    "prime in a box": ("prime_open_duct/prime_open_duct.stl", ["--box", "2"]),
    "hull in a box": ("dtc_hull/dtc_hull.off.gz", ["--box", "2"]),
    "almond in a box": ("nasa_almond_in_box/nasa_almond_in_box.msh", []),
    "flange": ("flange/flange.msh", []),
    "pipe": ("pipe/pipe.msh", []),
    "sphere in sphere": ("shape:sphere-in-sphere:0.08", []),
    "trihedral": ("shape:corner-reflector:0.1", []),
    "duct": ("shape:duct:0.06", []),
    "pec": ("shape:sphere-in-sphere:0.1", []),
}
COUNTS = {"pec": (3, 16, 64)}


def surface_of(build, where, folder):
    if not where.startswith("shape:"):
        return pathlib.Path(os.environ["TETFARM_DATA"]) / where
    _, kind, spacing = where.split(":")
    path = pathlib.Path(folder) / "shape.off"
    subprocess.run([build / "bin/tetfarm", "shape", kind, "-o", path, "--spacing", spacing], check=True,
                   stdout=subprocess.DEVNULL)
    return path


def measure(build, surface, leaves, options):
    """What the trial says: the figures of its lines by name, and its text."""
    command = [str(build / "bin/seams_trial"), str(surface), str(leaves), *options]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    if "INVALID" in text or "LOST" in text:
        raise SystemExit(f"{' '.join(command)}\n{text}")
    keys = ("tets", "angle", "height", "ratio")
    return {name: dict(zip(keys, map(float, numbers))) for name, *numbers in LINE.findall(text)}, text


def share(now, uncut):
    percent = 100 * now / uncut
    return f"{percent:.0f} %" if percent >= 94.5 else f"**{percent:.0f} %**"


def row(model, wanted, figures, uncut, text):
    near, whole = figures["seams after"], figures["all after"]
    made = LEAVES.search(text)[1]
    estimate, worst = ESTIMATE.search(text).groups()
    return (f"| {model} | {wanted}, {made} | {whole['tets']:,.0f} ({100 * whole['tets'] / uncut['tets'] - 100:+.1f} %) | "
            f"{near['angle']:.1f}° of {uncut['angle']:.1f}°: {share(near['angle'], uncut['angle'])} | "
            f"{near['height']:.3g} of {uncut['height']:.3g}: {share(near['height'], uncut['height'])} | "
            f"{figures['seams before']['ratio']:.4f}, {near['ratio']:.4f} of {uncut['ratio']:.4f} | "
            f"{CUTS.search(text)[2]}° | {100 * float(estimate) / whole['tets'] - 100:+.1f} %, {worst} % |")


def cost(model, wanted, figures, text):
    colours, neighbours, region, seconds = TURNS.search(text).groups()
    return (f"| {model} | {wanted} | {int(TAKEN.search(text)[1]):,} of {figures['seams after']['tets']:,.0f} | {colours} | "
            f"{neighbours} | {int(region):,} | {seconds} | {LEAVES.search(text)[2]} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--models", default=",".join(MODELS))
    parser.add_argument("--subdomains", default="")
    parser.add_argument("options", nargs="*")
    args = parser.parse_args()
    print("| surface | sub-domains wanted, made | elements | smallest dihedral near cuts, of the uncut mesh's | smallest "
          "height near cuts, of the uncut mesh's | mean radius ratio near cuts before, after turns, of the uncut mesh | "
          "smallest angle of a cut to the surface | estimate: all, worst leaf |")
    print("|---|--:|--:|--:|--:|--:|--:|--:|", flush=True)
    costs = []
    for model in args.models.split(","):
        where, options = MODELS[model]
        counts = [int(n) for n in args.subdomains.split(",")] if args.subdomains else COUNTS.get(model, (4, 16, 64, 256))
        with tempfile.TemporaryDirectory() as folder:
            surface = surface_of(args.build, where, folder)
            uncut = None
            for wanted in counts:
                figures, text = measure(args.build, surface, wanted,
                                        options + args.options + ([] if uncut else ["--uncut"]))
                uncut = uncut or figures["uncut"]
                print(row(model, wanted, figures, uncut, text), flush=True)
                costs.append(cost(model, wanted, figures, text))
    print("\n| surface | sub-domains | tets taken out of cores, of those in four layers | colours | most neighbours | "
          "largest region, tets | turns, s | meshing, s |")
    print("|---|--:|--:|--:|--:|--:|--:|--:|")
    print("\n".join(costs))


if __name__ == "__main__":
    main()
