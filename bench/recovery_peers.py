#!/usr/bin/env python3
"""Meshes the generated surfaces with our boundary recovery and with tetgen, and prints a table in Markdown.

  bench/recovery_peers.py                                   every generator, size 1, seeds 0 to 99
  bench/recovery_peers.py --generators knot,rings --seeds 100:1000 --timeout 20

Needs build/release/bin/recovery_trial (ninja recovery_trial) and tetgen (apt install tetgen). Surfaces that are
invalid after rounding are left out: check_surface says so exactly. tetgen gets -pYNEFQ: keep the boundary as it
is, write no files, be quiet; it has meshed a surface when it ends in time with exit code 0.
"""

import argparse
import collections
import os
import pathlib
import platform
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
GENERATORS = ["schoenhardt_prism", "twisted_prism", "chazelle", "star", "needles", "spindle", "near_shells",
              "voxels", "handles", "grid", "cubes", "rings", "knot"]
Surface = collections.namedtuple("Surface", "seed outcome splits left seconds file")


def ours(program, generator, size, first, end, folder):
    """What recovery_trial says of each surface."""
    command = [program, generator, str(size), str(first), str(end), folder]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    surfaces = []
    for line in done.stdout.splitlines():
        words = line.split()
        splits, left = map(int, re.search(r"steiner=(\d+),(\d+)", line).groups())
        seconds = float(re.search(r" s=([\d.]+)", line).group(1))
        file = pathlib.Path(folder) / f"{generator}_{size}_{words[2]}.off"
        surfaces.append(Surface(int(words[2]), words[3], splits, left, seconds, file))
    if len(surfaces) != end - first:
        raise RuntimeError(f"{generator}: recovery_trial ended early, exit code {done.returncode}")
    return surfaces


def tetgen_meshes(program, file, timeout_s):
    try:
        done = subprocess.run([program, "-pYNEFQ", str(file)], capture_output=True, check=False,
                              timeout=timeout_s)
        return done.returncode == 0
    except subprocess.TimeoutExpired:
        return False


def compare(options, generator):
    """The row of the table, and the surfaces that only one of the two meshes."""
    first, end = options.seeds
    with tempfile.TemporaryDirectory(prefix="recovery_peers.") as folder:
        surfaces = ours(options.program, generator, options.size, first, end, folder)
        valid = [s for s in surfaces if s.outcome != "invalid"]
        start = time.monotonic()
        theirs = {s.seed: tetgen_meshes(options.tetgen, s.file, options.timeout) for s in valid}
        their_seconds = time.monotonic() - start
    meshed = {s.seed for s in valid if s.outcome == "meshed" and s.seconds <= options.timeout}
    their_meshed = {seed for seed, is_meshed in theirs.items() if is_meshed}
    only_ours, only_theirs = sorted(meshed - their_meshed), sorted(their_meshed - meshed)
    row = (f"| {generator} | {len(valid)} | {len(meshed)} | {len(their_meshed)} | {len(only_ours)} | "
           f"{len(only_theirs)} | {sum(s.splits for s in valid)} | {sum(s.left for s in valid)} | "
           f"{sum(s.seconds for s in valid):.1f} | {their_seconds:.1f} |")
    return row, only_ours, only_theirs


def seed_range(text):
    first, end = text.split(":")
    return int(first), int(end)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--generators", default=",".join(GENERATORS), help="names, with commas between them")
    parser.add_argument("--size", type=int, default=1, help="1 small, 3 some thousand triangles")
    parser.add_argument("--seeds", type=seed_range, default=(0, 100), metavar="FIRST:END")
    parser.add_argument("--timeout", type=float, default=60, help="seconds for a surface")
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/recovery_trial"))
    parser.add_argument("--tetgen", default="tetgen")
    return parser.parse_args()


def main():
    options = parse_arguments()
    done = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True,
                          check=False)
    print(f"{time.strftime('%Y-%m-%d')}, commit {done.stdout.strip()}, {platform.machine()}, "
          f"{os.cpu_count()} cores, size {options.size}, seeds {options.seeds[0]} to {options.seeds[1] - 1}, "
          f"{options.timeout:g} s a surface\n")
    print("| generator | valid | ours | tetgen | ours only | tetgen only | points on the boundary for a while | "
          "left inside | CPU s, ours | s, tetgen |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|")
    worse = 0
    notes = []
    for generator in options.generators.split(","):
        row, only_ours, only_theirs = compare(options, generator)
        print(row, flush=True)
        worse += len(only_theirs)
        if only_ours or only_theirs:
            notes.append(f"{generator}: only ours {only_ours}, only tetgen {only_theirs}")
    if notes:
        print("\n" + "\n".join(notes))
    return 1 if worse else 0


if __name__ == "__main__":
    sys.exit(main())
