#!/usr/bin/env python3
"""Everything that can happen to a farm, at random: the mesh must stay the same.

  bench/chaos.py SURFACE|JOB.toml [--faults 200] [--subdomains 16] [--workers 3] [--seed N] [job options…]

Meshes the job once undisturbed, then on a farm of real processes (a coordinator, workers that see the
store, workers that do not, one of them behind a network of its own) while one fault after the other
happens: kill -9 and SIGSTOP of coordinator, workers and tasks, a full disk, artifacts flipped, cut and
removed, the network cut. When a job is done before the faults are, the next round begins on an empty store.
At the end of each round: the digest is the undisturbed one, no task was accepted twice (but for files that were
lost), and nothing is left behind after `tetfarm gc`. Exits with 1 when any of that fails.
Wants root (a small disk, a network). Linux only. $TETFARM names another program than the release build's.
"""

import argparse
import collections
import json
import os
import pathlib
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
TETFARM = pathlib.Path(os.environ.get("TETFARM", ROOT / "build" / "release" / "bin" / "tetfarm"))
PORT = 20000 + os.getpid() % 20000
NETWORK = f"tfchaos{os.getpid() % 10000}"
LEASE_MS = 3000


def sh(*words):
    return subprocess.run(words, capture_output=True, text=True)


def children_of(process):
    """Living children, from /proc."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            fields = (entry / "stat").read_text().rsplit(")", 1)[1].split()
        except (OSError, IndexError):
            continue
        if int(fields[1]) == process and fields[0] != "Z":
            found.append(int(entry.name))
    return found


class Network:
    """A network namespace with one cable to this one."""

    def __init__(self):
        self.number = 1 + os.getpid() % 250
        self.address = f"10.213.{self.number}.1"
        steps = [("ip", "netns", "add", NETWORK),
                 ("ip", "link", "add", NETWORK, "type", "veth", "peer", "name", "far", "netns", NETWORK),
                 ("ip", "addr", "add", f"{self.address}/24", "dev", NETWORK),
                 ("ip", "link", "set", NETWORK, "up"),
                 ("ip", "-n", NETWORK, "addr", "add", f"10.213.{self.number}.2/24", "dev", "far"),
                 ("ip", "-n", NETWORK, "link", "set", "far", "up")]
        self.trouble = ""
        for step in steps:
            try:
                done = sh(*step)
            except FileNotFoundError as error:
                self.trouble = str(error)
                return
            if done.returncode != 0:
                self.trouble = f"{' '.join(step)}: {done.stderr.strip()}"
                return

    def cut(self, seconds):
        sh("ip", "link", "set", NETWORK, "down")
        time.sleep(seconds)
        sh("ip", "link", "set", NETWORK, "up")

    def remove(self):
        if shutil.which("ip"):
            sh("ip", "link", "del", NETWORK)
            sh("ip", "netns", "del", NETWORK)


class Farm:
    def __init__(self, folder, workers, network):
        self.folder = folder
        self.network = network
        self.store = folder / "disk" / "store"
        self.log = open(folder / "farm.log", "a")
        self.processes = {}
        self.commands = {}
        hosts = ["127.0.0.1"] + ([network.address] if not network.trouble else [])
        listen = [word for host in hosts for word in ("--listen", f"tcp://{host}:{PORT}")]
        self.endpoint = f"tcp://127.0.0.1:{PORT}"
        (folder / "database").mkdir(exist_ok=True)
        self.commands["coordinator"] = [str(TETFARM), "coordinator", "-q", "--store", str(self.store), "--database",
                                        str(folder / "database"), "--insecure", "--heartbeat-ms", "300",
                                        "--lease-ms", str(LEASE_MS), *listen]
        for i in range(workers):
            name = f"near-{i}" if i % 2 == 0 else f"far-{i}"
            store = ["--store", str(self.store)] if i % 2 == 0 else ["--cache", str(folder / name)]
            self.commands[name] = [str(TETFARM), "worker", "-q", "--connect", self.endpoint, *store]
        if not network.trouble:
            self.commands["cable"] = ["ip", "netns", "exec", NETWORK, str(TETFARM), "worker", "-q", "--connect",
                                      f"tcp://{network.address}:{PORT}", "--cache", str(folder / "cable")]

    def look_after(self):
        for name, command in self.commands.items():
            process = self.processes.get(name)
            if process is None or process.poll() is not None:
                self.processes[name] = subprocess.Popen(command, stdout=self.log, stderr=self.log, cwd=self.folder)

    def stop(self):
        for process in self.processes.values():
            if process.poll() is None:
                process.send_signal(signal.SIGCONT)
                process.kill()
            process.wait()
        self.processes = {}

    def ask(self, *words):
        return subprocess.run([str(TETFARM), *words, "--connect", self.endpoint, "--timeout", "20"],
                              capture_output=True, text=True, cwd=self.folder)

    def rows(self, sql):
        path = self.folder / "database" / "tetfarm.db"
        with sqlite3.connect(f"file:{path}?mode=ro", uri=True, timeout=10) as database:
            return database.execute(sql).fetchall()


class Faults:
    """One method for each kind of fault; says what it did, or nothing when there was nothing to do it to."""

    def __init__(self, farm, dice):
        self.farm = farm
        self.dice = dice
        self.kinds = [self.kill_coordinator, self.kill_worker, self.kill_worker, self.kill_task, self.kill_task,
                      self.freeze, self.freeze, self.fill_disk, self.harm_file, self.harm_file, self.harm_file]
        if not farm.network.trouble:
            self.kinds += [self.cut_network]

    def worker(self):
        return self.dice.choice([name for name in self.farm.commands if name != "coordinator"])

    def tasks(self):
        return [child for name, process in self.farm.processes.items() if name != "coordinator"
                for child in children_of(process.pid)]

    def kill_coordinator(self):
        self.farm.processes["coordinator"].kill()
        return "kill coordinator"

    def kill_worker(self):
        name = self.worker()
        self.farm.processes[name].kill()
        return "kill worker"

    def kill_task(self):
        tasks = self.tasks()
        if not tasks:
            return None
        try:
            os.kill(self.dice.choice(tasks), signal.SIGKILL)
        except ProcessLookupError:
            return None
        return "kill task"

    def freeze(self):
        name = self.dice.choice(list(self.farm.commands))
        process = self.farm.processes[name]
        process.send_signal(signal.SIGSTOP)
        time.sleep(self.dice.choice([0.3, 1.0, LEASE_MS / 1000 + 1]))
        process.send_signal(signal.SIGCONT)
        return "stop and continue"

    def fill_disk(self):
        filler = self.farm.store.parent / "filler"
        try:
            with open(filler, "wb") as file:
                while True:
                    file.write(bytes(1 << 20))
                    file.flush()
        except OSError:
            pass
        time.sleep(self.dice.uniform(0.5, 2))
        filler.unlink()
        return "full disk"

    def harm_file(self):
        try:
            made = self.farm.rows("SELECT DISTINCT hash FROM task_outputs ORDER BY hash")
        except sqlite3.Error:
            return None
        there = [path for (name,) in made if (path := self.farm.store / "artifacts" / name[:2] / name).exists()]
        if not there:
            return None
        path = self.dice.choice(there)
        how = self.dice.choice(["flip", "cut", "remove"])
        data = bytearray(path.read_bytes())
        if not data or how == "remove":
            path.unlink()
            return "file removed"
        if how == "flip":
            data[self.dice.randrange(len(data))] ^= 1 << self.dice.randrange(8)
        else:
            del data[self.dice.randrange(len(data)):]
        try:
            path.write_bytes(data)  # in place, as a failing disk would
        except OSError:
            return None
        return "bit flipped" if how == "flip" else "file cut"

    def cut_network(self):
        self.farm.network.cut(self.dice.choice([0.5, LEASE_MS / 1000 + 1]))
        return "network cut"


def job_words(args):
    return [str(pathlib.Path(args.input).resolve()), "--subdomains", str(args.subdomains), *args.rest]


def undisturbed(args, folder):
    done = subprocess.run([str(TETFARM), "run", *job_words(args), "-o", str(folder / "reference"), "--json",
                           "--progress", "none"], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"undisturbed: exit {done.returncode}: {done.stderr[-2000:]}")
    return json.loads(done.stdout.strip().splitlines()[-1])


def accepted_twice(farm):
    """Tasks with more accepted attempts than there were reasons to run them again."""
    done = dict(farm.rows("SELECT task, count(*) FROM attempts WHERE state = 'done' GROUP BY task"))
    again = dict(farm.rows("SELECT task, count(*) FROM events WHERE what = 'again' GROUP BY task"))
    return [task for task, count in done.items() if count > 1 + again.get(task, 0)]


def left_behind(farm):
    known = {name for (name,) in farm.rows("SELECT hash FROM task_inputs UNION SELECT hash FROM task_outputs")}
    left = [str(path) for path in (farm.store / "scratch").iterdir()]
    return left + [str(path) for path in (farm.store / "artifacts").rglob("*")
                   if path.is_file() and path.name not in known]


def status_of(farm, job):
    done = farm.ask("status", job, "--json")
    return json.loads(done.stdout.strip().splitlines()[-1]) if done.returncode == 0 else {}


def disturbed_round(args, folder, network, dice, counts):
    """The digest; faults until the job is done or there were enough."""
    disk = folder / "disk"
    disk.mkdir(parents=True)
    mounted = sh("mount", "-t", "tmpfs", "-o", f"size={args.disk}", "tmpfs", str(disk))
    if mounted.returncode != 0:
        sys.exit(f"a small disk cannot be mounted: {mounted.stderr.strip()}")
    farm = Farm(folder, args.workers, network)
    try:
        farm.look_after()
        job = ""
        while not job:
            submitted = farm.ask("submit", *job_words(args), "--store", str(farm.store))
            job = submitted.stdout.strip()
            farm.look_after()
        faults = Faults(farm, dice)
        asked = 0.0
        while True:
            if sum(counts.values()) < args.faults:
                what = dice.choice(faults.kinds)()
                if what:
                    counts[what] += 1
                time.sleep(dice.uniform(0.05, args.pause))
            else:
                time.sleep(0.5)
            farm.look_after()
            if time.monotonic() - asked < 2:
                continue
            asked = time.monotonic()
            status = status_of(farm, job)
            if status.get("state") == "failed":
                counts["retries after quarantine"] += 1
                farm.ask("retry", job)
            if status.get("state") != "done":
                continue
            delivered = farm.ask("wait", job, "--store", str(farm.store), "-o", str(folder / "out"), "--json",
                                 "--progress", "none")
            if delivered.returncode == 0:
                digest = json.loads(delivered.stdout.strip().splitlines()[-1])["digest"]
                break
            # A result was harmed after it was made: the same submission makes it again.
            counts["results made again"] += 1
            check = subprocess.run([str(TETFARM), "check", "--store", str(farm.store), "--database",
                                    str(folder / "database"), "--json"], capture_output=True, text=True)
            for file in json.loads(check.stdout.splitlines()[0])["damaged"] if check.stdout else []:
                path = farm.store / "artifacts" / file["hash"][:2] / file["hash"]
                if file["needed"]:
                    path.unlink(missing_ok=True)
            farm.ask("submit", *job_words(args), "--store", str(farm.store))
        farm.stop()
        gc = subprocess.run([str(TETFARM), "gc", str(farm.store), "--database", str(folder / "database"), "--json"],
                            capture_output=True, text=True)
        if gc.returncode != 0:
            sys.exit(f"gc: {gc.stderr}")
        return digest, accepted_twice(farm), left_behind(farm), json.loads(gc.stdout)
    finally:
        farm.stop()
        sh("umount", "-l", str(disk))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("input")
    parser.add_argument("--faults", type=int, default=200)
    parser.add_argument("--subdomains", type=int, default=16)
    parser.add_argument("--workers", type=int, default=3)
    parser.add_argument("--disk", default="1g", help="size of the store's disk")
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(1 << 30))
    parser.add_argument("--pause", type=float, default=0.6, help="longest time between faults, seconds")
    args, args.rest = parser.parse_known_args()
    print(f"seed {args.seed}", flush=True)
    dice = random.Random(args.seed)
    network = Network()
    if network.trouble:
        print(f"the network is not cut: {network.trouble}", flush=True)
    counts = collections.Counter()
    failed = False
    start = time.monotonic()
    try:
        with tempfile.TemporaryDirectory(prefix="tetfarm-chaos-") as name:
            folder = pathlib.Path(name)
            reference = undisturbed(args, folder)
            print(f"undisturbed: {reference['digest']}  {reference['elements']} elements, "
                  f"{reference['seconds']:.1f} s", flush=True)
            rounds = 0
            while rounds == 0 or sum(counts.values()) < args.faults:
                rounds += 1
                digest, twice, left, gc = disturbed_round(args, folder / f"round{rounds}", network, dice, counts)
                good = digest == reference["digest"] and not twice and not left
                failed = failed or not good
                print(f"round {rounds}: {digest} {'same' if digest == reference['digest'] else 'DIFFERENT'}; "
                      f"accepted twice {twice}; gc removed {gc['files']} files; left {left[:5]}; "
                      f"{sum(counts.values())} faults, {time.monotonic() - start:.0f} s", flush=True)
    finally:
        network.remove()
    print(", ".join(f"{count} {what}" for what, count in sorted(counts.items())))
    print("FAILED" if failed else "the same mesh, each time")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
