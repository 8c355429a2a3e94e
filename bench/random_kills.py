#!/usr/bin/env python3
"""Kills processes of a run at random, `kill -9`, and looks whether the mesh stays the same.

  bench/random_kills.py SURFACE|JOB.toml [--kills 20] [--subdomains 16] [--seed N] [tetfarm run options…]

Runs the job undisturbed with -j 1, 2 and 4, then once with random kills: of `run`, the coordinator,
workers and tasks alike. When `run` itself dies, the same command starts again with another -j. Prints the
digests; exits with 1 when they differ. Linux only (/proc).
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

ROOT = pathlib.Path(__file__).resolve().parents[1]
TETFARM = ROOT / "build" / "release" / "bin" / "tetfarm"


def children_of_all():
    """parent -> children, from /proc."""
    children = {}
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            fields = (entry / "stat").read_text().rsplit(")", 1)[1].split()
        except (OSError, IndexError):
            continue
        children.setdefault(int(fields[1]), []).append(int(entry.name))
    return children


def descendants(process):
    children = children_of_all()
    found, queue = [], [process]
    while queue:
        for child in children.get(queue.pop(), []):
            found.append(child)
            queue.append(child)
    return found


def start(args, output, workers):
    command = [str(TETFARM), "run", args.input, "-o", str(output), "-j", str(workers),
               "--subdomains", str(args.subdomains), "--json", "--progress", "none", *args.rest]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def result_of(process):
    out, err = process.communicate()
    if process.returncode != 0:
        sys.exit(f"exit {process.returncode}: {err[-2000:]}")
    return json.loads(out.strip().splitlines()[-1])


def disturbed(args, output, dice):
    kills = starts = 0
    process = start(args, output, dice.choice([1, 2, 4]))
    starts += 1
    while True:
        if kills < args.kills:
            time.sleep(dice.uniform(0.02, args.pause))
            alive = [process.pid, *descendants(process.pid)]
            if process.poll() is None:
                victim = dice.choice(alive)
                try:
                    os.kill(victim, signal.SIGKILL)
                    kills += 1
                except ProcessLookupError:
                    pass
        else:
            process.wait()
        if process.poll() is None:
            continue
        if process.returncode == 0:
            return result_of(process), kills, starts
        process.communicate()
        process = start(args, output, dice.choice([1, 2, 4]))
        starts += 1


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("input")
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--subdomains", type=int, default=16)
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(1 << 30))
    parser.add_argument("--pause", type=float, default=0.5, help="longest time between kills, seconds")
    args, args.rest = parser.parse_known_args()
    print(f"seed {args.seed}", flush=True)
    digests = {}
    with tempfile.TemporaryDirectory(prefix="tetfarm-kills-") as folder:
        for workers in (1, 2, 4):
            result = result_of(start(args, pathlib.Path(folder) / f"j{workers}", workers))
            digests[f"-j {workers}"] = result["digest"]
            print(f"-j {workers}: {result['digest']}  {result['elements']} elements, "
                  f"{result['subdomains']} sub-domains, {result['seconds']:.1f} s", flush=True)
        result, kills, starts = disturbed(args, pathlib.Path(folder) / "killed", random.Random(args.seed))
        digests["killed"] = result["digest"]
        print(f"{kills} kills, {starts} starts: {result['digest']}", flush=True)
    same = len(set(digests.values())) == 1
    print("the same mesh" if same else "DIFFERENT MESHES")
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
