#!/usr/bin/env python3
"""What a tetrahedron costs from a million to a thousand million: time, memory and disk of whole runs.

The space between two spheres is meshed with even sizes, in sub-domains of about 1.6 million tetrahedra, each size
alone. Of each run: seconds, CPU seconds by kind of task and for a million tetrahedra, how that is to the first row's,
the largest task and the largest resident set of any process, and the disk: the result, and the most that lay in the output folder at any time, result included. Nothing else should run on
the machine. A thousand million need some 70 GB of disk, 40 with --files needed; the folder of a size is removed before the next. With --kill-every all processes of
a run are killed with SIGKILL again and again, and the same command goes on: the digest tells whether anything was lost.

    bench/scale.py FOLDER [--to 2e7] [--from 1e6] [--program build/release/bin/tetfarm] [--workers 2] [--files needed] [--kill-every 20] [--keep]
"""

import argparse
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import threading
import time

from real_models import ROOT, first_line, machine

# The shape with this edge length has so many tetrahedra; their number goes with its third power.
KNOWN_SPACING, KNOWN_TETS = 0.064, 1.022e6
TETS_OF_SUBDOMAIN = 1.56e6
KINDS = ("inspect", "decompose", "mesh", "order", "extract", "cosmetic", "number", "write", "assemble")


def sizes(least, most):
    """1, 2, 5, 10, … times a power of ten."""
    power = 1.0
    while power <= most:
        for step in (1, 2, 5):
            if least <= step * power <= most:
                yield step * power
        power *= 10


class DiskPeak(threading.Thread):
    """The most that a folder held, looked at ten times a second; files with several names count once."""

    def __init__(self, folder):
        super().__init__(daemon=True)
        self.folder, self.most, self.over = folder, 0, threading.Event()

    def held(self):
        blocks, seen = 0, set()
        for base, _, names in os.walk(self.folder):
            for name in names:
                try:
                    status = os.stat(os.path.join(base, name), follow_symlinks=False)
                except FileNotFoundError:
                    continue
                if status.st_ino not in seen:
                    seen.add(status.st_ino)
                    blocks += status.st_blocks
        return 512 * blocks

    def run(self):
        while not self.over.wait(0.1):
            self.most = max(self.most, self.held())

    def finish(self):
        self.over.set()
        self.join()
        return max(self.most, self.held())


def kill_with_descendants(pid):
    """At once and without warning, as a power cut does."""
    children = {}
    for status in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            parent = int(status.read_text().rsplit(")", 1)[1].split()[1])
        except (OSError, IndexError):
            continue
        children.setdefault(parent, []).append(int(status.parent.name))
    doomed = [pid]
    for process in doomed:
        doomed += children.get(process, [])
    for process in doomed:
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            pass


class Run:
    """A run that is over: its last line, its exit status, its largest resident set, and how often it was killed."""

    def __init__(self, command, kill_every):
        self.kills, self.largest = 0, 0
        while True:
            child = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
            is_over = threading.Event()
            killer = threading.Thread(target=self.kill_after, args=(child.pid, kill_every, is_over))
            killer.start()
            lines = child.stdout.read().strip().split("\n")
            _, self.status, usage = os.wait4(child.pid, 0)
            is_over.set()
            killer.join()
            self.largest = max(self.largest, usage.ru_maxrss * 1024)
            if not (os.WIFSIGNALED(self.status) and os.WTERMSIG(self.status) == signal.SIGKILL and kill_every):
                self.last_line = lines[-1]
                return

    def kill_after(self, pid, seconds, is_over):
        if seconds and not is_over.wait(seconds):
            self.kills += 1
            kill_with_descendants(pid)


def measured(options, tets):
    folder = options.folder / f"{tets:.0f}"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    spacing = KNOWN_SPACING * (KNOWN_TETS / tets) ** (1 / 3)
    surface = folder / "ball.off"
    subprocess.run([options.program, "shape", "sphere-in-sphere", "-o", surface, "--spacing", str(spacing)], check=True,
                   stdout=subprocess.DEVNULL)
    disk = DiskPeak(folder / "out")
    disk.start()
    begin = time.monotonic()
    run = Run([options.program, "run", surface, "-o", folder / "out", "--size", str(spacing), "--subdomains",
               str(max(2, round(tets / TETS_OF_SUBDOMAIN))), "--workers", str(options.workers), "--keep", options.files,
               "--json", "--progress", "none"], options.kill_every)
    seconds = time.monotonic() - begin
    peak = disk.finish()
    if run.status != 0:
        sys.exit(f"the run of {tets:.0f} tetrahedra failed; its folder is {folder}")
    result = json.loads(run.last_line)
    result.update(seconds=seconds, disk=peak, file=(folder / "out" / "ball.vtkhdf").stat().st_size,
                  largest=run.largest, kills=run.kills)
    if not options.keep:
        shutil.rmtree(folder)
    return result


def row(result, first):
    tasks, tets = result["tasks"], result["elements"]
    cpu = {kind: tasks[kind]["cpu_seconds"] for kind in KINDS if kind in tasks}
    cpu["others"] = sum(task["cpu_seconds"] for kind, task in tasks.items() if kind not in cpu)
    per_million = 1e6 * sum(cpu.values()) / tets
    heaviest = max(tasks, key=lambda kind: tasks[kind]["bytes"])
    cells = [f"{tets / 1e6:.1f} M", result["subdomains"], f"{result['seconds']:.1f}", f"{sum(cpu.values()):.1f}",
             f"{per_million:.3f}", f"{per_million / (first or per_million):.2f}",
             *(f"{seconds:.1f}" for seconds in cpu.values()),
             f"{heaviest} {tasks[heaviest]['bytes'] / 1e6:.0f}", f"{result['largest'] / 1e6:.0f}",
             f"{result['file'] / tets:.1f}", f"{result['disk'] / tets:.1f}", f"{result['disk'] / result['file']:.2f}",
             f"{result['min_dihedral_deg']:.1f}", result["kills"], result["digest"][:8]]
    return per_million, "| " + " | ".join(str(cell) for cell in cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path, nargs="?", default=ROOT / "build/scale")
    parser.add_argument("--from", dest="least", type=float, default=1e6, help="tetrahedra of the first row (default 1e6)")
    parser.add_argument("--to", dest="most", type=float, default=2e7, help="tetrahedra of the last row (default 2e7)")
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/bin/tetfarm")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--files", choices=("needed", "all"), default="all", help="files between the tasks that stay (default all)")
    parser.add_argument("--kill-every", type=float, metavar="SECONDS", help="kill all processes of a run that often")
    parser.add_argument("--keep", action="store_true", help="keep the folders")
    options = parser.parse_args()
    commit = first_line(["git", "rev-parse", "--short", "HEAD"])
    print(f"{time.strftime('%Y-%m-%d')}, commit {commit}, {machine()}, {options.workers} workers, files: {options.files}\n")
    heads = ["tets", "sub-domains", "s", "CPU s", "CPU s a M", "to first", *KINDS, "others", "largest task, MB", "largest process, MB",
             "result, B a tet", "disk, B a tet", "disk / result", "least dihedral", "kills", "digest"]
    print("| " + " | ".join(heads) + " |\n|" + "--:|" * len(heads), flush=True)
    first = None
    for tets in sizes(options.least, options.most):
        per_million, text = row(measured(options, tets), first)
        first = first or per_million
        print(text, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
