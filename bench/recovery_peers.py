#!/usr/bin/env python3
"""Meshes the generated surfaces with our boundary recovery and with tetgen, and prints a table in Markdown.

  bench/recovery_peers.py                                   every generator, size 1, seeds 0 to 99
  bench/recovery_peers.py --generators knot,rings --seeds 100:1000 --timeout 20
  bench/recovery_peers.py --generators cad --size 2 --fill --worst 20
                                   CAD-like ones with points inside, and those that take longest beside tetgen
  bench/recovery_peers.py --real [--models cdt_bracket] [--subdomains 8] [--extra "--outer box:3"]
                                   whole runs over the surfaces of TETFARM_DATA

Needs build/release/bin/recovery_trial (ninja recovery_trial) and tetgen (apt install tetgen). Surfaces that are
invalid after rounding are left out: check_surface says so exactly. tetgen gets -pYNEFQ: keep the boundary as it
is, write no files, be quiet; with --fill also q1.4. It has meshed a surface when it ends in time with exit code 0.
All seconds are CPU seconds; tetgen's are those of the program, reading included.
"""

import argparse
import collections
import os
import pathlib
import platform
import re
import resource
import subprocess
import sys
import tempfile
import time

import real_recovery

ROOT = pathlib.Path(__file__).resolve().parents[1]
GENERATORS = ["schoenhardt_prism", "twisted_prism", "chazelle", "star", "needles", "spindle", "near_shells",
              "voxels", "handles", "grid", "cubes", "rings", "knot", "drum", "washer"]
CAD_GENERATORS = ["capped_cylinder", "fan_node", "thread", "perforated_plate", "lettering", "gear", "rounded_block",
                  "filleted_bar", "split_extrusion", "fine_levels", "merged_voxels", "box_boolean"]
Surface = collections.namedtuple("Surface", "seed outcome triangles splits left seconds file")


def ours(options, generator, folder):
    """What recovery_trial says of each surface."""
    first, end = options.seeds
    command = [options.program, generator, str(options.size), str(first), str(end), folder,
               "fill" if options.fill else "recover"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    surfaces = []
    for line in done.stdout.splitlines():
        words = line.split()
        triangles = int(re.search(r"triangles=(\d+)", line).group(1))
        splits, left = map(int, re.search(r"steiner=(\d+),(\d+)", line).groups())
        seconds = float(re.search(r" s=([\d.]+)", line).group(1))
        file = pathlib.Path(folder) / f"{generator}_{options.size}_{words[2]}.off"
        surfaces.append(Surface(int(words[2]), words[3], triangles, splits, left, seconds, file))
    if len(surfaces) != end - first:
        raise RuntimeError(f"{generator}: recovery_trial ended early, exit code {done.returncode}")
    return surfaces


def cpu_seconds_of_children():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def tetgen(options, file):
    """Whether it has meshed the surface, and its CPU seconds."""
    before = cpu_seconds_of_children()
    switches = "-pYq1.4NEFQ" if options.fill else "-pYNEFQ"
    try:
        done = subprocess.run([options.tetgen, switches, str(file)], capture_output=True, check=False,
                              timeout=options.timeout)
        has_meshed = done.returncode == 0
    except subprocess.TimeoutExpired:
        has_meshed = False
    return has_meshed, cpu_seconds_of_children() - before


def compare(options, generator):
    """The row of the table, the surfaces that only one of the two meshes, and all with both times."""
    with tempfile.TemporaryDirectory(prefix="recovery_peers.") as folder:
        surfaces = ours(options, generator, folder)
        valid = [s for s in surfaces if s.outcome != "invalid"]
        theirs = {s.seed: tetgen(options, s.file) for s in valid}
    meshed = {s.seed for s in valid if s.outcome == "meshed" and s.seconds <= options.timeout}
    their_meshed = {seed for seed, (is_meshed, _) in theirs.items() if is_meshed}
    only_ours, only_theirs = sorted(meshed - their_meshed), sorted(their_meshed - meshed)
    row = (f"| {generator} | {len(valid)} | {len(meshed)} | {len(their_meshed)} | {len(only_ours)} | "
           f"{len(only_theirs)} | {sum(s.splits for s in valid)} | {sum(s.left for s in valid)} | "
           f"{sum(s.seconds for s in valid):.1f} | {sum(seconds for _, seconds in theirs.values()):.1f} |")
    return row, only_ours, only_theirs, [(generator, s, *theirs[s.seed]) for s in valid]


def print_worst(rows, count):
    """Those for which ours takes longest as against tetgen; what took both next to nothing is left out."""
    def ratio(row):
        return row[1].seconds / max(row[3], 0.01)
    print("\n| generator | seed | triangles | ours | s, ours | tetgen | s, tetgen | ratio |\n"
          "|---|--:|--:|---|--:|---|--:|--:|")
    for row in sorted(rows, key=ratio, reverse=True)[:count]:
        generator, surface, is_meshed, seconds = row
        print(f"| {generator} | {surface.seed} | {surface.triangles} | {surface.outcome} | {surface.seconds:.2f} | "
              f"{'meshed' if is_meshed else 'not meshed'} | {seconds:.2f} | {ratio(row):.1f} |")


def seed_range(text):
    first, end = text.split(":")
    return int(first), int(end)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--generators", default=",".join(GENERATORS), help="names, with commas between them; cad: all CAD-like ones")
    parser.add_argument("--size", type=int, default=1, help="1 small, 3 some thousand triangles")
    parser.add_argument("--seeds", type=seed_range, default=(0, 100), metavar="FIRST:END")
    parser.add_argument("--fill", action="store_true", help="points inside and quality, not recovery alone")
    parser.add_argument("--worst", type=int, default=0, metavar="N", help="list the N that take longest beside tetgen")
    parser.add_argument("--timeout", type=float, default=60, help="seconds for a surface")
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/recovery_trial"))
    parser.add_argument("--tetgen", default="tetgen")
    parser.add_argument("--real", action="store_true", help="the real surfaces, by whole runs with quality")
    parser.add_argument("--data", default=os.environ.get("TETFARM_DATA", str(ROOT / "../shared/data")))
    parser.add_argument("--models", type=lambda text: text.split(","), help="with --real: only these")
    parser.add_argument("--rounds", type=int, default=3, help="with --real: the median of so many is shown")
    parser.add_argument("--subdomains", type=int, default=1, help="with --real")
    parser.add_argument("--extra", default="", help="with --real: further options of tetfarm run")
    parser.add_argument("--tetfarm", default=str(ROOT / "build/release/bin/tetfarm"), help="with --real")
    return parser.parse_args()


def main():
    options = parse_arguments()
    if options.real:
        return real_recovery.compare_real(options)
    done = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True,
                          check=False)
    print(f"{time.strftime('%Y-%m-%d')}, commit {done.stdout.strip()}, {platform.machine()}, "
          f"{os.cpu_count()} cores, size {options.size}, seeds {options.seeds[0]} to {options.seeds[1] - 1}, "
          f"{options.timeout:g} s a surface\n")
    print("| generator | valid | ours | tetgen | ours only | tetgen only | points on the boundary for a while | "
          "left inside | s, ours | s, tetgen |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|")
    worse = 0
    notes, everything = [], []
    generators = CAD_GENERATORS if options.generators == "cad" else options.generators.split(",")
    for generator in generators:
        row, only_ours, only_theirs, both = compare(options, generator)
        everything += both
        print(row, flush=True)
        worse += len(only_theirs)
        if only_ours or only_theirs:
            notes.append(f"{generator}: only ours {only_ours}, only tetgen {only_theirs}")
    if options.worst:
        print_worst(everything, options.worst)
    if notes:
        print("\n" + "\n".join(notes))
    return 1 if worse else 0


if __name__ == "__main__":
    sys.exit(main())
