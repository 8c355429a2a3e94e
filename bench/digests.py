#!/usr/bin/env python3
"""The same mesh whatever the number of workers and whatever is killed: docs/measurements/2026-11-elements_near_cuts.md.

  TETFARM_DATA=... bench/digests.py BUILD_FOLDER [--models pipe,flange] [--workers 1,2,3,8] [--kills 12] [--seed 1]

Each surface in 16 sub-domains by `tetfarm run` with so many workers, each time in a new folder, and once more with three
workers while processes of the run, drawn by the seed, get `kill -9`; it is begun again where it ends itself.
Ends with 1 where the digests of a surface differ.
"""

import argparse
import json
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

from chaos import children_of
from cuts_table import MODELS, run, surface_of

SUBDOMAINS = 16
MOST_STARTS = 100


def family_of(process):
    """The process and all that it started."""
    found = [process]
    for member in found:
        found += children_of(member)
    return found


class KilledRun:
    def __init__(self, build, surface, outer, out, dice):
        self.command = [build / "bin/tetfarm", "run", surface, "--subdomains", str(SUBDOMAINS), "--outer", outer,
                        "-o", out, "-j", "3", "--json", "--progress", "none"]
        self.dice = dice
        self.kills = 0
        self.starts = 0

    def start(self, most_kills):
        """What a run said that came to its end; None when it did not."""
        self.starts += 1
        running = subprocess.Popen(self.command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        while running.poll() is None and self.kills < most_kills:
            time.sleep(self.dice.uniform(0.05, 1.2))
            try:
                os.kill(self.dice.choice(family_of(running.pid)), signal.SIGKILL)
                self.kills += 1
            except ProcessLookupError:
                pass
        said = running.communicate()[0]
        return said if running.returncode == 0 else None

    def digest(self, most_kills):
        while self.starts < MOST_STARTS:
            said = self.start(most_kills)
            if said is not None:
                return json.loads(said.strip().splitlines()[-1])["digest"]
        return f"no end after {MOST_STARTS} starts"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--models", default="")
    parser.add_argument("--workers", default="1,2,3,8")
    parser.add_argument("--kills", type=int, default=12)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    build = options.build.resolve()
    workers = [int(n) for n in options.workers.split(",")]
    names = [name for name in MODELS if any(name.startswith(part) for part in options.models.split(","))]
    print(f"| surface | digest of {SUBDOMAINS} sub-domains | workers {options.workers} | after kills, starts |\n"
          "|---|---|---|---|")
    differ = False
    for name in names:
        where, outer = MODELS[name]
        with tempfile.TemporaryDirectory(prefix="tetfarm_digests.") as folder:
            surface = surface_of(build, where, folder)
            digests = [run(build, surface, outer, SUBDOMAINS, n)["digest"] for n in workers]
            killed = KilledRun(build, surface, outer, folder + "/killed", random.Random(f"{options.seed} {name}"))
            after_kills = killed.digest(options.kills)
        same = "the same" if len(set(digests)) == 1 else " ".join(digests)
        same_killed = "the same" if after_kills == digests[0] else after_kills
        differ |= same != "the same" or same_killed != "the same"
        print(f"| {name} | `{digests[0]}` | {same} | {same_killed} ({killed.kills}, {killed.starts}) |", flush=True)
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
