#!/usr/bin/env python3
"""Meshes the real models of TETFARM_DATA and prints a table in Markdown.

  bench/real_models.py                         every model with 1, 4 and 16 sub-domains
  bench/real_models.py --models pipe,flange --subdomains 1,4
  bench/real_models.py --list

Each mesh is measured by `tetfarm quality`, which also checks it. A model that has to be refused is right
when it ends with exit code 3.
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

ROOT = pathlib.Path(__file__).resolve().parents[1]

# name of the case: (file, outer boundary)
MODELS = {
    "cube_sphere": ("cube_sphere/cube_sphere.msh", "none"),
    "nasa_almond_quarter": ("nasa_almond_quarter/NasaAlmondQuarterWavelengthv2.stl", "none"),
    "nasa_almond_quarter_box2": ("nasa_almond_quarter/NasaAlmondQuarterWavelengthv2.stl", "box:2"),
    "nasa_almond_tenth": ("nasa_almond_tenth/NasaAlmondTenthWavelengthv2.stl", "none"),
    "nasa_almond_tenth_box2": ("nasa_almond_tenth/NasaAlmondTenthWavelengthv2.stl", "box:2"),
    "nasa_almond_in_box": ("nasa_almond_in_box/nasa_almond_in_box.msh", "none"),
    "flange": ("flange/flange.msh", "none"),
    "pipe": ("pipe/pipe.msh", "none"),
    "onera_m6_sharp_te": ("onera_m6_sharp_te/onera_m6_sharp_te.msh.gz", "none"),
    "dtc_hull": ("dtc_hull/dtc_hull.off.gz", "none"),
    "dtc_hull_box2": ("dtc_hull/dtc_hull.off.gz", "box:2"),
    "netgen_plane": ("netgen_plane/netgen_plane.stl", "none"),
    "cessna210": ("cessna210/cessna210.msh.gz", "none"),
    "prime_open_duct": ("prime_open_duct", "none"),
    "prime_open_duct_box2": ("prime_open_duct", "box:2"),
    "d150_aircraft": ("d150_aircraft/d150_aircraft.msh.gz", "none"),
    "d150_aircraft_box2": ("d150_aircraft/d150_aircraft.msh.gz", "box:2"),
}

REFUSED = {
    "bad_open_object": "bad_open_object/bad_open_object.msh",
    "bad_airplane_4shells": "bad_airplane_4shells/bad_airplane_4shells.msh",
    "gmsh_piece_4vol": "gmsh_piece_4vol/gmsh_piece_4vol.msh",
}
EXIT_BAD_GEOMETRY = 3
SURFACES = (".msh", ".msh.gz", ".off.gz", ".obj.gz", ".stl", ".stl.gz")


def surface_file(data, name):
    """The file, or the first surface in the folder, in the order of SURFACES."""
    path = data / name
    if not path.is_dir():
        return path
    for ending in SURFACES:
        for found in sorted(path.iterdir()):
            if found.name.endswith(ending):
                return found
    return path


def first_line(command):
    try:
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
        return done.stdout.strip().split("\n")[0]
    except OSError:
        return ""


def machine():
    model = ""
    cpuinfo = pathlib.Path("/proc/cpuinfo")
    if cpuinfo.exists():
        for line in cpuinfo.read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                model = line.split(":", 1)[1].strip()
                break
    return f"{model or platform.processor()}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}"


def last_json(text, kind):
    found = None
    for line in text.splitlines():
        try:
            value = json.loads(line)
        except ValueError:
            continue
        if isinstance(value, dict) and value.get("type", kind) == kind:
            found = value
    return found


def run_case(program, surface, outer, subdomains, workers, timeout_s):
    """(exit code, seconds, the result's JSON or None, what quality said, the last words)."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="tetfarm_bench."))
    start = time.monotonic()
    try:
        command = [program, "run", str(surface), "--subdomains", str(subdomains), "--outer", outer,
                   "-o", str(folder), "-j", str(workers), "--json", "--progress", "none"]
        done = subprocess.run(command, capture_output=True, text=True, check=False,
                              timeout=timeout_s)
        seconds = time.monotonic() - start
        result = last_json(done.stdout, "result")
        quality = "-"
        if done.returncode == 0:
            checked = subprocess.run([program, "quality", str(folder), "--json"],
                                     capture_output=True, text=True, check=False)
            quality = "right" if checked.returncode == 0 else f"exit {checked.returncode}"
        words = (done.stderr or done.stdout).strip().splitlines()
        return done.returncode, seconds, result, quality, words[-1] if words else ""
    except subprocess.TimeoutExpired:
        return "time out", time.monotonic() - start, None, "-", ""
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def row(case, subdomains, outcome):
    code, seconds, result, quality, words = outcome
    if result is None:
        return (f"| {case} | {subdomains} | - | {seconds:.1f} | - | - | - | - | "
                f"exit {code}: {words[:100].replace('|', '/')} |")
    return (f"| {case} | {subdomains} | {result['subdomains']} | {seconds:.1f} | "
            f"{result['elements']} | {result['min_dihedral_deg']:.2f} | "
            f"{result['peak_rss_bytes_worker'] / 1e6:.0f} | `{result['digest'][:12]}` | {quality} |")


def numbers(text):
    return [int(word) for word in text.split(",")]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--models", default="all", help="names, with commas between them")
    parser.add_argument("--subdomains", type=numbers, default=[1, 4, 16])
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/tetfarm"))
    parser.add_argument("--data", default=os.environ.get("TETFARM_DATA", ""))
    parser.add_argument("--timeout", type=float, default=1800, help="seconds for each mesh")
    parser.add_argument("--list", action="store_true", help="print the names of the models")
    return parser.parse_args()


def main():
    options = parse_arguments()
    names = [*MODELS, *REFUSED]
    if options.list:
        print("\n".join(names))
        return 0
    chosen = names if options.models == "all" else options.models.split(",")
    unknown = sorted(set(chosen) - set(names))
    if unknown:
        print(f"unknown models: {', '.join(unknown)}; --list gives all", file=sys.stderr)
        return 2
    data = pathlib.Path(options.data)
    if not options.data or not data.is_dir():
        print("set TETFARM_DATA to the folder of the models, or give --data", file=sys.stderr)
        return 2
    commit = first_line(["git", "rev-parse", "--short", "HEAD"])
    print(f"{time.strftime('%Y-%m-%d')}, commit {commit}, {machine()}, {options.workers} workers\n")
    print("| model | asked | sub-domains | seconds | tets | worst dihedral, deg | peak MB of a worker "
          "| digest | mesh |\n|---|---|---|---|---|---|---|---|---|")
    wrong = 0
    for case in chosen:
        if case in REFUSED:
            outcome = run_case(options.program, surface_file(data, REFUSED[case]), "none", 1,
                               options.workers, options.timeout)
            right = outcome[0] == EXIT_BAD_GEOMETRY
            print(f"| {case} | 1 | - | {outcome[1]:.1f} | - | - | - | - | "
                  f"{'refused, as it has to be' if right else f'exit {outcome[0]}'} |", flush=True)
            wrong += not right
            continue
        file_name, outer = MODELS[case]
        for subdomains in options.subdomains:
            outcome = run_case(options.program, surface_file(data, file_name), outer, subdomains,
                               options.workers, options.timeout)
            print(row(case, subdomains, outcome), flush=True)
            wrong += outcome[0] != 0 or outcome[3] != "right"
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
