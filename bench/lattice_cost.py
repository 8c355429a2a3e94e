#!/usr/bin/env python3
"""What filling thin domains costs in looking for lattice nodes: visited beside kept, a table in Markdown.

  bench/lattice_cost.py                    thin domains by formula (tests/support/thin_domains.h), and the swept
                                           wing of TETFARM_DATA, inside and in boxes
  bench/lattice_cost.py --cases spiral,shell

Each case is filled in one piece by bench/lattice_trial.cpp. Visited: cells of the octree and of its blocks that the
walk over the lattice came to. Asked: how often it had to be found out whether a box is outside. Kept: nodes inside.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import time

from real_models import ROOT, first_line, machine

SWEPT_WING = "swept_wing_openvsp/swept_wing_openvsp.stl"

# name of the case: (spacing far from everything, 0: what the surface allows; shape; factor of a box round a file)
CASES = {
    "wing": ("0", "wing", None),
    "wing, 0.01": ("0.01", "wing", None),
    "wing in a box": ("0", "wing-in-box", None),
    "spiral": ("0", "spiral", None),
    "spiral, 0.01": ("0.01", "spiral", None),
    "spiral in a box": ("0", "spiral-in-box", None),
    "shell": ("0", "shell", None),
    "bodies": ("0", "bodies", None),
    "swept wing": ("0", "file", "0"),
    "swept wing, box:3": ("0", "file", "3"),
    "swept wing, box:20": ("0", "file", "20"),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", default="", help="shapes of the cases, with commas between; default: all")
    options = parser.parse_args()
    program = ROOT / "build/release/bin/lattice_trial"
    if not program.exists():
        sys.exit(f"{program} is not there: ninja -C build/release lattice_trial")
    data = pathlib.Path(os.environ.get("TETFARM_DATA", ROOT / "../shared/data"))
    commit = first_line(["git", "rev-parse", "--short", "HEAD"])
    print(f"{time.strftime('%Y-%m-%d')}, commit {commit}, {machine()}\n")
    print("| case | triangles | tets | visited | asked | listed | kept | visited / (kept + triangles) | CPU s | checksum |")
    print("|---|--:|--:|--:|--:|--:|--:|--:|--:|---|")
    asked = options.cases.split(",")
    for name, (size, shape, factor) in CASES.items():
        if options.cases and shape not in asked:
            continue
        command = [program, size, shape]
        if factor is not None:
            if not (data / SWEPT_WING).exists():
                print(f"{name}: TETFARM_DATA is not set", file=sys.stderr)
                continue
            command += [data / SWEPT_WING, factor]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        print(f"| {name} " + done.stdout.strip() if done.returncode == 0 else f"| {name} | {done.stderr.strip()} |",
              flush=True)


if __name__ == "__main__":
    main()
