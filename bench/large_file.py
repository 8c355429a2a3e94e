#!/usr/bin/env python3
"""How fast a large mesh is written, beside what the disk can: 100 million elements, each format by `tetfarm export`.

Meshes the space between two spheres (or takes the folder of a run), writes it in each format, and after each one as
many random bytes with fdatasync. Prints bytes, seconds, MB/s of both, and the peak memory of the export.

    bench/large_file.py FOLDER [--program build/release/bin/tetfarm] [--spacing 0.0138] [--subdomains 64]
                        [--formats vtkhdf,cgns,lb8.ugrid,lb8l.ugrid]
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent


def run(words):
    """Seconds and peak memory in bytes."""
    begin = time.monotonic()
    child = subprocess.Popen([str(word) for word in words], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        sys.exit(f"{words[0]} {words[1]} failed")
    return time.monotonic() - begin, usage.ru_maxrss * 1024


def make_mesh(program, folder, spacing, subdomains):
    surface = folder / "ball.off"
    run([program, "shape", "sphere-in-sphere", "-o", surface, "--spacing", spacing])
    done = subprocess.run([program, "run", surface, "-o", folder / "out", "--size", str(spacing), "--subdomains",
                           str(subdomains), "--json", "--progress", "none"], capture_output=True, text=True, check=True)
    result = json.loads(done.stdout.strip().split("\n")[-1])
    print(f"{result['elements']} elements in {result['subdomains']} sub-domains, {result['seconds']:.0f} s, "
          f"largest worker {result['peak_rss_bytes_worker'] / 1e6:.0f} MB, "
          f"assembling {result['tasks']['assemble']['seconds']:.0f} s")


def disk_speed(folder, size):
    """MB/s of as many random bytes, in one row: disks of virtual machines take zeros faster than data."""
    target = folder / "random"
    block = os.urandom(1 << 24)
    begin = time.monotonic()
    with open(target, "wb", buffering=0) as file:
        for first in range(0, size, len(block)):
            file.write(block[: size - first])
        os.fdatasync(file.fileno())
    seconds = time.monotonic() - begin
    target.unlink()
    return size / seconds / 1e6


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/bin/tetfarm")
    parser.add_argument("--spacing", type=float, default=0.0138)
    parser.add_argument("--subdomains", type=int, default=64)
    parser.add_argument("--formats", default="vtkhdf,cgns,lb8.ugrid,lb8l.ugrid")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    if not list((options.folder / "out").glob("*.vtkhdf")):
        make_mesh(options.program, options.folder, options.spacing, options.subdomains)
    print("| format | GB | s | MB/s | disk, MB/s | of it, % | peak, MB |\n|---|--:|--:|--:|--:|--:|--:|")
    for name in options.formats.split(","):
        target = options.folder / f"written.{name}"
        seconds, peak = run([options.program, "export", options.folder / "out", "-o", target])
        size = target.stat().st_size
        for written in options.folder.glob("written.*"):
            written.unlink()
        speed, disk = size / seconds / 1e6, disk_speed(options.folder, size)
        print(f"| `{name}` | {size / 1e9:.2f} | {seconds:.1f} | {speed:.0f} | {disk:.0f} | {100 * speed / disk:.0f} | {peak / 1e6:.0f} |",
              flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
