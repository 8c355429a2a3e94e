#!/usr/bin/env python3
"""Surfaces of TETFARM_DATA remeshed at three sizes, beside CGAL and Gmsh, and then meshed: a table in Markdown.

  bench/remeshing.py                                      edges of 1/30, 1/100 and 1/300 of the diagonal
  bench/remeshing.py --parts 30 --surfaces flange,pipe
  bench/remeshing.py --peers none

All get the same closed surface and keep its edges sharper than 30 degrees. One program that shares no code with ours
(bench/remeshing_with_cgal.cpp) judges all: whether the result is closed, of the same Euler number and free of triangles that
meet, its angles, and how far it and the input are from each other, at 15 points of each triangle. An input that touches itself
along edges is open to that program, and so is what comes of it. "Free" triangles have no corner on a sharp edge. Ours shortens
edges for curvature and narrow places, the others have one length; edges are compared with that. The remeshed surface is then
meshed inside by `tetfarm run`. Seconds are CPU time of remeshing alone for the others, of the whole command for ours. A program
that is not installed, or over its time limit, is left out and named.
"""

import argparse
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

from real_models import ROOT, first_line, last_json, machine, surface_file

SURFACES = ["cube_sphere", "flange", "pipe", "nasa_almond_quarter", "onera_m6_sharp_te", "dtc_hull", "cessna210", "d150_aircraft",
            "prime_open_duct", "swept_wing_openvsp", "cdt_bracket/bracket.off", "netgen_plane", "printer_lcd_knob", "printer_adapter_printer",
            "printer_cable_holder", "printer_spool_holder", "printer_extruder_cover", "printer_fs_cover", "thingi_58011",
            "thingi_65004", "thingi_72214", "thingi_472042", "thingi_520644"]
PEERS = ("cgal", "gmsh")


class Trial:
    """One surface at one size: its files, and what each program made of it."""

    def __init__(self, options, name, folder):
        self.options, self.name, self.folder = options, name, folder
        self.surface = folder / "in.off"
        subprocess.run([options.program, "convert", str(surface_file(pathlib.Path(options.data), name)), str(self.surface)],
                       check=True, capture_output=True)
        subprocess.run([options.program, "convert", str(self.surface), str(folder / "in.stl")], check=True, capture_output=True)
        points = [[float(word) for word in line.split()] for line in self.surface.read_text(encoding="ascii").split("\n")[2:]
                  if len(line.split()) == 3]
        self.diagonal = sum((max(p[i] for p in points) - min(p[i] for p in points)) ** 2 for i in range(3)) ** 0.5

    def run(self, command):
        """(status, words, CPU seconds); None for the status where it was over its time."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False,
                                  timeout=self.options.timeout)
        except subprocess.TimeoutExpired:
            return None, "over the time limit", self.options.timeout
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return done.returncode, done.stdout + done.stderr, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

    def remeshed_by(self, program, edge):
        """(the file or None, CPU seconds or the reason)."""
        if program == "tetfarm":
            out = self.folder / "tetfarm.off"
            status, words, seconds = self.run([self.options.program, "surface", self.surface, "-o", out, "--size", edge, "--json"])
        elif program == "cgal":
            out = self.folder / "cgal.off"
            status, words, seconds = self.run([self.options.judge, "remesh", self.surface, out, edge])
        else:
            out = self.folder / "gmsh.stl"
            status, words, seconds = self.run([sys.executable, ROOT / "bench/remeshing_by_gmsh.py", self.folder / "in.stl", out, edge])
        if status != 0:
            return None, f"{words.strip().splitlines()[-1] if words.strip() else status}"[:100]
        if program != "tetfarm":
            seconds = json.loads(words.strip().splitlines()[-1])["seconds"]
        return out, seconds

    def judged(self, remeshed, edge):
        status, words, _ = self.run([self.options.judge, "judge", self.surface, remeshed, edge])
        return json.loads(words) if status == 0 else None

    def meshed(self, remeshed):
        """(tetrahedra, smallest dihedral angle, mean radius ratio) or why not."""
        out = self.folder / "out"
        status, words, _ = self.run([self.options.program, "run", remeshed, "-o", out, "--workers", 1, "--json", "--progress", "none", "--force"])
        result = last_json(words, "result")
        if status != 0 or result is None:
            return f"exit {status}: {words.strip().splitlines()[-1][:100] if words.strip() else ''}"
        return f"{result['elements']} | {result['min_dihedral_deg']:.1f} | {result['mean_radius_ratio']:.3f}"


def row(name, part, program, seconds, judged, meshed):
    if judged is None:
        return f"| {name} | 1/{part} | {program} | | | | | | | | | | {str(seconds).replace('|', '/')} | | |"
    is_sound = judged["closed"] and judged["self_intersections"] == 0 and judged["euler"] == judged["euler_before"]
    touches = not judged["closed_before"] and judged["self_intersections_before"] > 0 and judged["euler"] == judged["euler_before"]
    wrong = "sound" if is_sound else "touches itself, as the input" if touches else (f"{'closed' if judged['closed'] else 'open'}, {judged['self_intersections']} meet, "
                                      f"Euler {judged['euler_before']} → {judged['euler']}")
    free = "–" if judged["free"] == 0 else f"{judged['smallest_free_deg']:.1f} | {100 * judged['free_below_30'] / judged['free']:.2f}"
    return (f"| {name} | 1/{part} | {program} | {judged['triangles']} | {seconds:.2f} | {wrong} | {judged['smallest_deg']:.2f} | "
            f"{free if judged['free'] else '– | –'} | {judged['mean_ratio']:.3f} | {judged['mean_length']:.2f} | "
            f"{100 * judged['well_sized']:.1f} | {judged['of_diagonal']:.2e} | {meshed} |")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--surfaces", default=",".join(SURFACES), help="names, with commas between them")
    parser.add_argument("--parts", default="30,100,300", help="of the diagonal, that edges are long")
    parser.add_argument("--peers", default="cgal,gmsh", help="cgal, gmsh, both, or none")
    parser.add_argument("--timeout", type=float, default=300, help="seconds for each program")
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/tetfarm"))
    parser.add_argument("--judge", default=str(ROOT / "build/release/bin/remeshing_with_cgal"))
    parser.add_argument("--data", default=os.environ.get("TETFARM_DATA", ""))
    return parser.parse_args()


def main():
    options = parse_arguments()
    if not options.data or not pathlib.Path(options.data).is_dir():
        sys.exit("set TETFARM_DATA to the folder of the models, or give --data")
    peers = [] if options.peers == "none" else options.peers.split(",")
    if set(peers) - set(PEERS):
        sys.exit(f"--peers takes {', '.join(PEERS)} and none")
    print(f"{time.strftime('%Y-%m-%d')}, commit {first_line(['git', 'rev-parse', '--short', 'HEAD'])}, {machine()}\n")
    print("| surface | edges | program | triangles | CPU s | result | smallest angle | free: smallest | below 30°, % | shape | edges: mean "
          "| 0.6–1.5, % | distance / diagonal | tetrahedra | smallest dihedral | radius ratio |\n" + "|---" * 16 + "|")
    wrong = 0
    for name in options.surfaces.split(","):
        with tempfile.TemporaryDirectory(prefix="tetfarm_bench.") as folder:
            trial = Trial(options, name, pathlib.Path(folder))
            for part in (int(word) for word in options.parts.split(",")):
                edge = trial.diagonal / part
                for program in ["tetfarm", *peers]:
                    remeshed, seconds = trial.remeshed_by(program, edge)
                    judged = trial.judged(remeshed, edge) if remeshed else None
                    if judged:
                        judged["of_diagonal"] = max(judged["distance_to"], judged["distance_from"]) / trial.diagonal
                    meshed = trial.meshed(remeshed) if remeshed and program == "tetfarm" else " | | "
                    print(row(name, part, program, seconds, judged, meshed), flush=True)
                    wrong += program == "tetfarm" and judged is None
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
