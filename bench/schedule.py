#!/usr/bin/env python3
"""How long a job would take with more workers, from what its tasks took with one.

The tasks of a finished `tetfarm run -j 1` are handed out again to w workers that never wait for anything but the
files a task reads, each taking the CPU seconds that it took; the order among ready tasks is the coordinator's (first
made, first run). On a machine that others use too this says more than two clocks. Also: what each kind of task took,
and the longest chain of tasks that wait for each other.

    bench/schedule.py OUT/.tetfarm/tetfarm.db [--workers 2,4,8,16] [--chain]
"""

import argparse
import collections
import heapq
import sqlite3
import sys

Task = collections.namedtuple("Task", "number name kind seconds megabytes makers")

# What a task waits for besides the makers of the files it reads.
WAITS_FOR_ALL_OF = {"assimilate": ("decompose",), "order": ("decompose", "assimilate"), "number": ("mesh", "cosmetic")}


def tasks_of(database, job):
    rows = database.execute(
        "SELECT id, kind, path, peak_rss_bytes FROM tasks WHERE job = ? AND state = 'done' ORDER BY id", (job,)).fetchall()
    cpu = dict(database.execute(
        "SELECT task, number FROM task_values WHERE sort = 'number' AND name = 'cpu_seconds'"))
    maker, of_kind = {}, collections.defaultdict(set)
    for number, kind, _, _ in rows:
        of_kind[kind].add(number)
        for (file,) in database.execute("SELECT hash FROM task_outputs WHERE task = ?", (number,)):
            maker.setdefault(file, number)
    tasks = {}
    for number, kind, path, peak in rows:
        files = database.execute("SELECT hash FROM task_inputs WHERE task = ?", (number,))
        makers = {maker[file] for (file,) in files if file in maker}
        for other in WAITS_FOR_ALL_OF.get(kind, ()):
            makers |= of_kind[other]
        tasks[number] = Task(number, f"{kind} {path}" if path else kind, kind, cpu.get(number, 0.0), peak / 1e6,
                             makers - {number})
    return tasks


def seconds_with(tasks, workers):
    """When the last task ends."""
    left = {task.number: len(task.makers) for task in tasks.values()}
    wanted_by = collections.defaultdict(list)
    for task in tasks.values():
        for maker in task.makers:
            wanted_by[maker].append(task.number)
    ready = [number for number, count in left.items() if count == 0]
    heapq.heapify(ready)
    running, now = [], 0.0
    while ready or running:
        while ready and len(running) < workers:
            number = heapq.heappop(ready)
            heapq.heappush(running, (now + tasks[number].seconds, number))
        now, number = heapq.heappop(running)
        for other in wanted_by[number]:
            left[other] -= 1
            if left[other] == 0:
                heapq.heappush(ready, other)
    return now


def longest_chain(tasks):
    """The tasks of the chain, first to last."""
    ends, before = {}, {}
    for number in sorted(tasks):
        task = tasks[number]
        before[number] = max(task.makers, key=lambda maker: ends[maker], default=None)
        ends[number] = task.seconds + (ends[before[number]] if task.makers else 0.0)
    chain = [max(ends, key=ends.get)]
    while before[chain[-1]] is not None:
        chain.append(before[chain[-1]])
    return [tasks[number] for number in reversed(chain)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("database")
    parser.add_argument("--job", type=int, default=1)
    parser.add_argument("--workers", default="2,4,8,16")
    parser.add_argument("--chain", action="store_true", help="list the longest chain")
    args = parser.parse_args()
    database = sqlite3.connect(f"file:{args.database}?mode=ro", uri=True)
    tasks = tasks_of(database, args.job)
    if not tasks:
        sys.exit(f"job {args.job} has no finished tasks")
    kinds = collections.defaultdict(list)
    for task in tasks.values():
        kinds[task.kind].append(task)
    print("kind        tasks   CPU s   largest   MB")
    for kind, same in kinds.items():
        print(f"{kind:11} {len(same):5} {sum(t.seconds for t in same):7.2f} {max(t.seconds for t in same):9.2f}"
              f" {max(t.megabytes for t in same):4.0f}")
    alone = sum(task.seconds for task in tasks.values())
    print(f"{'all':11} {len(tasks):5} {alone:7.2f}")
    for workers in map(int, args.workers.split(",")):
        together = seconds_with(tasks, workers)
        print(f"{workers:3} workers: {together:7.2f} s, {alone / together:.2f} times as fast as one")
    chain = longest_chain(tasks)
    print(f"longest chain: {sum(task.seconds for task in chain):.2f} s")
    if args.chain:
        for task in chain:
            print(f"  {task.seconds:6.2f}  {task.name}")


if __name__ == "__main__":
    main()
