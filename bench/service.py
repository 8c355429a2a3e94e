#!/usr/bin/env python3
"""How many durable tasks a second the coordinator hands out and takes back, and what it costs.

A real `tetfarm coordinator` on a database that bench/service_fill.cpp filled by the real decisions, and workers of
bench/service_load.cpp: each a connection of its own over tcp loopback, encrypted, speaking the real protocol; their
tasks take no time. Every answer comes after the COMMIT (write-ahead log, synchronous = FULL).

    bench/service.py [rate] [waiting] [idle] [memory]     all four unless named
"""

import argparse
import json
import os
import pathlib
import platform
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
TICKS = os.sysconf("SC_CLK_TCK")


class Farm:
    """A store in a folder of its own, its keys, and a coordinator while it is entered."""

    def __init__(self, programs, folder, fill, plain=False):
        self.programs, self.plain = programs, plain
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="tetfarm-bench-", dir=folder))
        self.store, self.keys = self.folder / "store", self.folder / "keys"
        self.store.mkdir()
        if not plain:
            for name in ("coordinator", "worker"):
                self.tetfarm("keys", "new", name, "--keys", self.keys)
            self.tetfarm("keys", "authorize", self.keys / "worker.pub", "--role", "worker", "--keys", self.keys)
        subprocess.run([self.programs / "service_fill", self.store, *map(str, fill)], check=True)

    def tetfarm(self, *words):
        subprocess.run([self.programs / "tetfarm", *map(str, words)], check=True, stdout=subprocess.DEVNULL)

    def __enter__(self):
        keys = [] if self.plain else ["--keys", str(self.keys)]
        begun = time.monotonic()
        self.process = subprocess.Popen([self.programs / "tetfarm", "coordinator", "--store", self.store, "--listen",
                                         "tcp://127.0.0.1:*", "--quiet", *keys])
        while not (self.store / "endpoints").exists():
            if self.process.poll() is not None:
                sys.exit("the coordinator ended")
            time.sleep(0.01)
        self.seconds_to_start = time.monotonic() - begun
        self.endpoint = (self.store / "endpoints").read_text().split()[0]
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        shutil.rmtree(self.folder)

    def cpu_seconds(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / TICKS

    def megabytes(self, figure):
        for line in pathlib.Path(f"/proc/{self.process.pid}/status").read_text().splitlines():
            if line.startswith(figure + ":"):
                return int(line.split()[1]) * 1024 / 1e6
        return 0.0

    def load(self, *words):
        key = [] if self.plain else ["--key", str(self.keys / "worker.key")]
        return subprocess.Popen([self.programs / "service_load", self.endpoint, self.store, *map(str, words), *key],
                                stdout=subprocess.PIPE, text=True)

    def do_tasks(self, workers, tasks):
        before = self.cpu_seconds()
        words = self.load("--workers", workers, "--tasks", tasks).communicate()[0].splitlines()
        if not words:
            sys.exit("the workers ended")
        outcome = json.loads(words[-1])
        outcome["rate"] = outcome["accepted"] / outcome["seconds"]
        outcome["cpu_us"] = 1e6 * (self.cpu_seconds() - before) / outcome["accepted"]
        return outcome


def sync_ms(folder):
    """What an fsync of 16 kB costs here, on average."""
    times = 50
    with tempfile.NamedTemporaryFile(dir=folder) as file:
        begun = time.monotonic()
        for _ in range(times):
            file.write(bytes(16384))
            file.flush()
            os.fdatasync(file.fileno())
        return 1000 * (time.monotonic() - begun) / times


def measure_rate(args):
    print(f"\n{args.tasks} tasks, {args.workers} workers, median of {args.runs} runs")
    for plain in (False, True):
        runs = []
        for _ in range(args.runs):
            with Farm(args.programs, args.folder, ["--waiting", args.tasks + 1000], plain) as farm:
                runs.append(farm.do_tasks(args.workers, args.tasks))
        runs.sort(key=lambda run: run["rate"])
        median = runs[len(runs) // 2]
        print(f"{'plain' if plain else 'encrypted':9} {median['rate']:8.0f} tasks/s ({runs[0]['rate']:.0f} to "
              f"{runs[-1]['rate']:.0f}), {median['cpu_us']:.0f} us of the coordinator's CPU time each")


def measure_waiting(args):
    tasks = 5000
    print(f"\n{tasks} tasks with others waiting behind them, {args.workers} workers, encrypted")
    for waiting in (100, 10_000, 100_000):
        rates = []
        with Farm(args.programs, args.folder, ["--waiting", waiting + args.runs * (tasks + args.workers)]) as farm:
            for _ in range(args.runs):
                rates.append(farm.do_tasks(args.workers, tasks))
        rates.sort(key=lambda run: run["rate"])
        median = rates[len(rates) // 2]
        print(f"{waiting:7} waiting {median['rate']:8.0f} tasks/s ({rates[0]['rate']:.0f} to {rates[-1]['rate']:.0f}), "
              f"{median['cpu_us']:.0f} us of CPU time each")


def measure_idle(args):
    print("\nidle workers, encrypted, default heartbeats")
    with Farm(args.programs, args.folder, ["--waiting", 100]) as farm:
        load = farm.load("--workers", 1000, "--threads", 2, "--idle", args.seconds)
        load.stdout.readline()
        before, begun = farm.cpu_seconds(), time.monotonic()
        outcome = json.loads(load.communicate()[0].splitlines()[-1])
        seconds = time.monotonic() - begun
        print(f"   1000 workers {100 * (farm.cpu_seconds() - before) / seconds:6.1f} % of a core, "
              f"{outcome['heartbeats'] / seconds:.0f} heartbeats/s, {outcome['answers'] / seconds:.0f} answers/s")


def measure_memory(args):
    print("\nmemory by the tasks on record")
    for jobs, waiting in ((2, 1000), (20, 10_000), (200, 10_000)):
        leaves = 1666
        with Farm(args.programs, args.folder, ["--finished", jobs, leaves, "--waiting", waiting]) as farm:
            farm.do_tasks(args.workers, waiting // 2)
            tasks = jobs * (3 * leaves + 2) + 2 * waiting
            size = (farm.store / "tetfarm.db").stat().st_size / 1e6
            print(f"{tasks:8} tasks in {jobs + 1} jobs, {waiting} of them waiting: {farm.megabytes('VmRSS'):.0f} MB, at most "
                  f"{farm.megabytes('VmHWM'):.0f} MB; database {size:.0f} MB, started in {farm.seconds_to_start:.1f} s")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("what", nargs="*", choices=["rate", "waiting", "idle", "memory"], default=[])
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("--folder", help="of the stores and databases; default: $TMPDIR")
    parser.add_argument("--workers", type=int, default=64)
    parser.add_argument("--tasks", type=int, default=30_000)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--seconds", type=int, default=20, help="how long idle workers are watched")
    args = parser.parse_args()
    model = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "?")
    commit = subprocess.run(["git", "-C", ROOT, "describe", "--always", "--dirty"], capture_output=True, text=True).stdout
    print(f"{time.strftime('%Y-%m-%d')}, {model}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}, "
          f"{platform.release()}, commit {commit.strip()}; fsync of 16 kB: {sync_ms(args.folder):.1f} ms")
    measures = {"rate": measure_rate, "waiting": measure_waiting, "idle": measure_idle, "memory": measure_memory}
    for name in args.what or measures:
        measures[name](args)


if __name__ == "__main__":
    main()
