#!/usr/bin/env python3
"""How a job of 10^9 elements would scale: recorded task times, the coordinator's real decisions, simulated time.

Reads what the tasks of finished jobs of several sizes took (CPU seconds; run with one worker each), fits the seconds of
each kind of task to what it reads and makes, and gives the fits for a larger job to bench/service_scaling.cpp, which
hands out its tasks by the coordinator's own code (JobState) to 1 .. 10,000 workers. Prints the fits, the efficiency and
the longest chain of tasks, and draws them.

    bench/scaling.py DATABASE... [--elements 1e9] [--leaves 8192] [--svg FILE]
"""

import argparse
import json
import math
import os
import pathlib
import platform
import sqlite3
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
WORKERS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000]

# What the seconds of a kind of task follow, each with a constant: files in MB, elements in millions.
FOLLOWS = {
    "inspect": ("surface",),
    "decompose": ("subdomain", "spacing"),
    "mesh": ("tets", "spacing"),
    "order": ("subdomains",),
    "extract": ("tets",),
    "cosmetic": ("tets", "spacing"),
    "number": ("leaves", "surface"),
    "write": ("tets", "surface"),
    "assemble": ("elements",),
}


class Run:
    """One finished job: its tasks as (seconds, what they follow), and sizes that grow with the job."""

    def __init__(self, path):
        database = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
        values = {}
        for task, name, number in database.execute("SELECT task, name, number FROM task_values WHERE sort = 'number'"):
            values.setdefault(task, {})[name] = number
        sizes = {}
        for table in ("task_inputs", "task_outputs"):
            for task, name, size in database.execute(f"SELECT task, name, size FROM {table} JOIN artifacts USING (hash)"):
                sizes.setdefault(task, {}).setdefault(name, size / 1e6)
        rows = database.execute("SELECT id, kind, path FROM tasks WHERE state = 'done' ORDER BY id").fetchall()
        by_kind = {kind: number for number, kind, _ in rows}
        if "assemble" not in by_kind:
            sys.exit(f"{path}: not a finished job")
        inspect = sizes[by_kind["inspect"]]
        self.leaves = sum(kind == "mesh" for _, kind, _ in rows)
        self.elements = values[by_kind["assemble"]]["elements"] / 1e6
        self.surface, self.spacing = inspect["surface"], inspect["spacing"]
        self.subdomain = {path: sizes[number]["subdomain"] for number, kind, path in rows if kind in ("decompose", "mesh")}
        tets = {path: values[number]["tets"] / 1e6 for number, kind, path in rows if kind == "mesh"}
        self.tasks = []
        for number, kind, path in rows:
            about = {"surface": self.surface, "spacing": self.spacing, "elements": self.elements, "leaves": self.leaves,
                     "subdomain": self.subdomain.get(path, 0.0), "tets": tets.get(path, 0.0),
                     "subdomains": sum(self.subdomain[leaf] for leaf in tets)}
            self.tasks.append((kind, values[number]["cpu_seconds"], [1.0] + [about[name] for name in FOLLOWS[kind]]))


def solve(matrix, right):
    """Gauss, with the largest pivot."""
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    for i in range(len(rows)):
        pivot = max(range(i, len(rows)), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for k in range(len(rows)):
            if k != i and rows[i][i] != 0:
                factor = rows[k][i] / rows[i][i]
                rows[k] = [a - factor * b for a, b in zip(rows[k], rows[i])]
    return [row[-1] / row[i] if row[i] else 0.0 for i, row in enumerate(rows)]


def fit(samples):
    """Least squares of relative errors; what comes out negative does not count."""
    used = list(range(len(samples[0][1])))
    while True:
        weights = [1 / max(seconds, 1e-3) ** 2 for seconds, _ in samples]
        matrix = [[sum(w * about[i] * about[j] for w, (_, about) in zip(weights, samples)) for j in used] for i in used]
        right = [sum(w * about[i] * seconds for w, (seconds, about) in zip(weights, samples)) for i in used]
        found = solve(matrix, right)
        worst = min(range(len(used)), key=lambda i: found[i])
        if found[worst] >= 0 or len(used) == 1:
            break
        del used[worst]
    factors = [0.0] * len(samples[0][1])
    for i, factor in zip(used, found):
        factors[i] = factor
    return factors


def power(points):
    """exponent, factor of y = factor * x^exponent through the points."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    mean_x, mean_y = statistics.mean(x for x, _ in logs), statistics.mean(y for _, y in logs)
    exponent = sum((x - mean_x) * (y - mean_y) for x, y in logs) / sum((x - mean_x) ** 2 for x, _ in logs)
    return exponent, math.exp(mean_y - exponent * mean_x)


def model_of(runs, args):
    """The text of the model for service_scaling."""
    millions = args.elements / 1e6
    grown = {}
    print(f"\nfiles of a job of {millions:.0f} million elements, by those of {len(runs)} jobs:")
    for name in ("surface", "spacing"):
        exponent, factor = power([(run.elements, getattr(run, name)) for run in runs])
        grown[name] = factor * millions ** exponent
        print(f"  {name}: {', '.join(f'{getattr(run, name):.1f}' for run in runs)} MB, "
              f"as elements^{exponent:.2f}: {grown[name]:.0f} MB")
    areas = [(run.elements * 2.0 ** -(path.bit_length() - 1), size) for run in runs for path, size in run.subdomain.items()]
    exponent, factor = power(areas)
    print(f"  sub-domain: {factor:.3f} MB x (its million elements)^{exponent:.2f}, of {len(areas)} sub-domains")
    subdomain = lambda elements: factor * elements ** exponent
    tets = millions / args.leaves
    about = {"surface": grown["surface"], "spacing": grown["spacing"], "elements": millions, "leaves": args.leaves,
             "tets": tets, "subdomains": args.leaves * subdomain(tets)}
    print("\nseconds of a task: fitted, of how many, and the middle half of recorded / fitted")
    lines = []
    for kind, follows in FOLLOWS.items():
        samples = [(seconds, what) for run in runs for k, seconds, what in run.tasks if k == kind]
        factors = fit(samples)
        guess = lambda what: sum(f * x for f, x in zip(factors, what))
        ratios = sorted(seconds / guess(what) for seconds, what in samples)
        text = " + ".join([f"{factors[0]:.3g}"] + [f"{f:.3g} {name}" for f, name in zip(factors[1:], follows) if f > 0])
        print(f"  {kind:9} {text:46} {len(samples):4}   {ratios[len(ratios) // 4]:.2f} to {ratios[3 * len(ratios) // 4]:.2f}")
        if kind == "decompose":
            depth = args.leaves.bit_length() - 1
            each = [guess([1.0, subdomain(millions / 2 ** level), grown["spacing"]]) for level in range(depth)]
            lines.append("decompose " + " ".join(f"{s:.4f}" for s in each))
            print(f"            here: {each[0]:.1f} s the first cut, {each[-1]:.2f} s the last ones")
            continue
        seconds = guess([1.0] + [about[name] for name in follows])
        print(f"            here: {seconds:.2f} s")
        spread = ratios if len(ratios) > 3 else []
        lines.append(f"{kind} {seconds:.4f} " + " ".join(f"{ratio:.3f}" for ratio in spread))
    lines += [f"coordinator {args.coordinator}", f"start {args.start}"]
    return "\n".join(lines)


def draw(outcomes, chain_s, path, title):
    """Speed over workers on logarithmic axes, efficiency beside the points."""
    width, height, left, bottom, top = 760, 500, 70, 60, 50
    most = math.log10(outcomes[-1]["workers"])
    x = lambda value: left + (width - left - 110) * math.log10(value) / most
    y = lambda value: height - bottom - (height - bottom - top) * math.log10(value) / most
    bound = outcomes[0]["alone"] / chain_s
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="13">',
           f'<rect width="{width}" height="{height}" fill="white"/>',
           f'<text x="{left}" y="28" font-size="15">{title}</text>']
    for power_of_ten in range(int(most) + 1):
        value = 10 ** power_of_ten
        out += [f'<path d="M{x(value):.1f} {y(1):.1f}V{top}M{left} {y(value):.1f}H{x(10 ** most):.1f}" stroke="#ddd"/>',
                f'<text x="{x(value):.1f}" y="{height - bottom + 20}" text-anchor="middle">{value}</text>',
                f'<text x="{left - 8}" y="{y(value) + 4:.1f}" text-anchor="end">{value}</text>']
    out += [f'<text x="{(left + x(10 ** most)) / 2:.0f}" y="{height - 15}" text-anchor="middle">workers</text>',
            f'<text transform="translate(20 {height / 2:.0f}) rotate(-90)" text-anchor="middle">times as fast as one</text>',
            f'<path d="M{x(1):.1f} {y(1):.1f}L{x(10 ** most):.1f} {y(10 ** most):.1f}" stroke="#999" stroke-dasharray="5 4"/>',
            f'<path d="M{left} {y(bound):.1f}H{x(10 ** most):.1f}" stroke="#c33" stroke-dasharray="5 4"/>',
            f'<text x="{x(10 ** most) + 6:.1f}" y="{y(bound) - 6:.1f}" fill="#c33">longest chain</text>',
            f'<text x="{x(10 ** most) + 6:.1f}" y="{y(bound) + 10:.1f}" fill="#c33">{chain_s:.0f} s</text>',
            '<path d="M' + "L".join(f"{x(o['workers']):.1f} {y(o['alone'] / o['seconds']):.1f}" for o in outcomes)
            + '" fill="none" stroke="#147" stroke-width="2"/>']
    for o in outcomes:
        speed = o["alone"] / o["seconds"]
        out += [f'<circle cx="{x(o["workers"]):.1f}" cy="{y(speed):.1f}" r="4" fill="#147"/>',
                f'<text x="{x(o["workers"]):.1f}" y="{y(speed) + 20:.1f}" text-anchor="middle" font-size="11" fill="#147">'
                f'{100 * speed / o["workers"]:.0f} %</text>']
    path.write_text("\n".join(out + ["</svg>"]) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("databases", nargs="+")
    parser.add_argument("--elements", type=float, default=1e9)
    parser.add_argument("--leaves", type=int, default=8192, help="a power of two")
    parser.add_argument("--coordinator", type=float, default=0.0002, help="seconds of the coordinator for a task")
    parser.add_argument("--start", type=float, default=0.05, help="seconds from the hand-out to the task's first instruction")
    parser.add_argument("--faster", action="append", default=[], metavar="KIND:FACTOR", help="what if")
    parser.add_argument("--svg", type=pathlib.Path)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/bin/service_scaling")
    args = parser.parse_args()
    runs = sorted((Run(path) for path in args.databases), key=lambda run: run.elements)
    model_name = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "?")
    print(f"{model_name}, {os.cpu_count()} cores, {platform.release()}; recorded: "
          + ", ".join(f"{run.elements:.2f} million elements in {run.leaves}" for run in runs))
    model = model_of(runs, args)
    for wish in args.faster:
        kind, factor = wish.split(":")
        words = next(line for line in model.splitlines() if line.startswith(kind + " ")).split()
        count = len(words) if kind == "decompose" else 2
        faster = [f"{float(word) / float(factor):.4f}" for word in words[1:count]] + words[count:]
        model = model.replace(" ".join(words), " ".join([kind] + faster))
    found = subprocess.run([args.program, str(args.leaves), str(args.elements), *map(str, WORKERS)], input=model,
                           text=True, capture_output=True, check=True)
    outcomes = [json.loads(line) for line in found.stdout.splitlines()]
    chain_s = outcomes[-1]["chain_s"]
    print(f"\n{outcomes[0]['tasks']} tasks, {outcomes[0]['alone']:.0f} s of one worker; longest chain {chain_s:.0f} s: at most "
          f"{outcomes[0]['alone'] / chain_s:.1f} times as fast")
    for kind in FOLLOWS:
        if kind in outcomes[-1]["chain"]:
            count, seconds = outcomes[-1]["chain"][kind]
            print(f"  {kind:9} {count:3} tasks {seconds:8.1f} s {100 * seconds / chain_s:5.1f} %")
    print("\n| workers | seconds | times as fast as one | efficiency, % | of what the chain allows, % |\n|--:|--:|--:|--:|--:|")
    for o in outcomes:
        speed = o["alone"] / o["seconds"]
        allowed = min(o["workers"], o["alone"] / chain_s)
        print(f"| {o['workers']} | {o['seconds']:.0f} | {speed:.2f} | {100 * speed / o['workers']:.1f} | {100 * speed / allowed:.0f} |")
    if args.svg:
        title = f"{args.elements / 1e6:.0f} million elements in {args.leaves} sub-domains: the coordinator's decisions, simulated"
        draw(outcomes, chain_s, args.svg, title)


if __name__ == "__main__":
    main()
