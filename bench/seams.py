#!/usr/bin/env python3
"""Elements near cuts before and after cosmetics across them, beside the uncut mesh: docs/seams.md.

usage: seams.py BUILD_FOLDER [MODEL...]     with TETFARM_DATA set; needs the programs seams_trial and tetfarm
Without models all of them. Prints tables in Markdown, and the thesis's Table 1 for the model "pec".
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

LINE = re.compile(r"^  (uncut|seams before|seams after|all before|all after) +(\d+) tets +min dihedral +"
                  r"([\d.]+) +0\.1% +([\d.]+) +1% +([\d.]+) +below 10/20/30: +(\d+) +(\d+) +(\d+) +"
                  r"height ([\d.e+-]+) \(([\d.]+) h\) +mean ratio ([\d.]+)")
TURNS = re.compile(r"^  (\d+) colours, at most (\d+) neighbours, largest region (\d+) tets, ([\d.]+) s")
LEAVES = re.compile(r"^ (\d+) leaves, meshed in ([\d.]+) s")

MODELS = {
    "onera": ("onera_m6_sharp_te/onera_m6_sharp_te.msh.gz", [], (4, 16, 64)),
    "prime in its box": ("prime_open_duct/prime_open_duct.stl", ["--box", "2"], (4, 16, 64)),
    "d150 in a box": ("d150_aircraft/d150_aircraft.stl", ["--box", "2"], (4, 16, 64)),
    "hull in a box": ("dtc_hull/dtc_hull.off.gz", ["--box", "2"], (4, 16, 64)),
    "sphere in a sphere": ("shape:sphere-in-sphere:0.08", [], (4, 16, 64)),
    "pec": ("shape:sphere-in-sphere:0.1", [], (3, 16, 64)),
}


def surface_of(build, where, folder):
    if not where.startswith("shape:"):
        return pathlib.Path(os.environ["TETFARM_DATA"]) / where
    _, kind, spacing = where.split(":")
    path = pathlib.Path(folder) / "shape.off"
    subprocess.run([build / "bin/tetfarm", "shape", kind, "-o", path, "--spacing", spacing], check=True)
    return path


def measure(build, surface, leaves, options):
    """The figures of each line of the trial, by name; turns and leaves too."""
    command = [str(build / "bin/seams_trial"), str(surface), str(leaves), *options]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    if "INVALID" in text or "LOST" in text:
        raise SystemExit(f"{' '.join(command)}\n{text}")
    figures = {}
    for line in text.splitlines():
        if found := LINE.match(line):
            name, *numbers = found.groups()
            keys = ["tets", "min", "q01", "q1", "b10", "b20", "b30", "height", "relative", "ratio"]
            figures[name] = dict(zip(keys, map(float, numbers)))
        elif found := TURNS.match(line):
            figures["turns"] = dict(zip(["colours", "neighbours", "region", "seconds"], map(float, found.groups())))
        elif found := LEAVES.match(line):
            figures["leaves"] = dict(zip(["leaves", "seconds"], map(float, found.groups())))
    return figures


def row(model, leaves, what, f):
    return (f"| {model} | {leaves} | {what} | {f['tets']:.0f} | {f['min']:.2f} | {f['q01']:.1f} | {f['b10']:.0f} | "
            f"{f['b20']:.0f} | {f['b30']:.0f} | {f['height']:.5g} | {f['relative']:.4f} | {f['ratio']:.4f} |")


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    wanted = sys.argv[2:] or list(MODELS)
    print("| surface | leaves | elements | tets | min dihedral, ° | 0.1 % quantile, ° | below 10° | below 20° | "
          "below 30° | smallest height | in spacings | mean radius ratio |")
    print("|---|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|", flush=True)
    costs = []
    for model in wanted:
        where, options, counts = MODELS[model]
        with tempfile.TemporaryDirectory() as folder:
            surface = surface_of(build, where, folder)
            for i, leaves in enumerate(counts):
                found = measure(build, surface, leaves, options + (["--uncut"] if i == 0 else []))
                if "uncut" in found:
                    print(row(model, 1, "all, uncut", found["uncut"]))
                for what in ("seams before", "seams after", "all before", "all after"):
                    print(row(model, leaves, what, found[what]), flush=True)
                costs.append((model, leaves, found["leaves"], found["turns"]))
    print("\n| surface | leaves wanted, made | colours | most neighbours | largest region, tets | turns, s | meshing, s |")
    print("|---|--:|--:|--:|--:|--:|--:|")
    for model, leaves, made, turns in costs:
        print(f"| {model} | {leaves}, {made['leaves']:.0f} | {turns['colours']:.0f} | {turns['neighbours']:.0f} | "
              f"{turns['region']:.0f} | {turns['seconds']:.2f} | {made['seconds']:.2f} |")


if __name__ == "__main__":
    main()
