#!/usr/bin/env python3
"""Tetfarm's sequential mesher beside Gmsh's HXT and TetGen, and its Delaunay kernel beside CGAL's:
tables in Markdown.

  bench/kernel_peers.py                    about 0.1 and 0.8 million tets, a million points
  bench/kernel_peers.py --large            also about 5 million tets, 20 of ours alone, 10 million points
  bench/kernel_peers.py --cases wing-0.1M --runs 5
  bench/kernel_peers.py --real             the insides of surfaces of TETFARM_DATA, needle triangles and all

All get the same closed surface and keep its triangles; the edge lengths of the surface spread inside. The
size of the others is scaled until they make about as many tets, where they let it. The programs run in turn,
one thread each. "Meshing" is what a program itself tells, without reading and writing files; of "process"
ours does not write, the others do. Quality is measured by one program (bench/kernel_bench.cpp) for all. A
program that is not installed is left out.
"""

import argparse
import gzip
import json
import os
import pathlib
import re
import shutil
import statistics
import struct
import subprocess
import sys
import tempfile
import time

from real_models import ROOT, first_line, machine

# name of the case: (shape, spacing, growth of our spacing, a point in each hole). The others spread the
# sizes of the surface over the inside without growth; even surfaces therefore get none from us either.
CASES = {
    "spheres-0.1M": ("sphere-in-sphere", 0.140, 0, ["0 0 0"]),
    "reflector-0.1M": ("corner-reflector", 0.220, 0, ["-0.5 -0.5 -0.5"]),
    "wing-0.1M": ("wing", 0.020, 0.3, []),
    "spheres-0.8M": ("sphere-in-sphere", 0.069, 0, ["0 0 0"]),
}
LARGE = {
    "spheres-5M": ("sphere-in-sphere", 0.0373, 0, ["0 0 0"]),
    "spheres-20M": ("sphere-in-sphere", 0.0237, 0, ["0 0 0"]),
}
# Only ours is run: whether the time for a tet grows with their number.
ALONE = {"spheres-20M"}

# name of the case: a surface of TETFARM_DATA, growth of our spacing. Meshed inside.
REAL = {
    "onera_m6": ("onera_m6_sharp_te/onera_m6_sharp_te.stl", 0.3),
    "d150": ("d150_aircraft/d150_aircraft.stl", 0.3),
    "dtc_hull": ("dtc_hull/dtc_hull.off.gz", 0.3),
    "prime": ("prime_open_duct/prime_open_duct.stl", 0.3),
    "pipe": ("pipe/pipe.stl", 0.3),
    "flange": ("flange/flange.stl", 0.3),
}

# name of the case: the kind of points, and how many.
POINTS = {"uniform-1e6": ("uniform", 1000000), "clustered-1e6": ("clustered", 1000000)}
LARGE_POINTS = {"uniform-1e7": ("uniform", 10000000)}

CLOSE_ENOUGH = 0.15
STL_HEADER, STL_TRIANGLE = 84, struct.Struct("<12x36s2x")
SCALINGS = 4


def read_off(path):
    lines = path.read_text(encoding="ascii").split("\n")
    vertices, faces = (int(word) for word in lines[1].split()[:2])
    points = lines[2:2 + vertices]
    triangles = [line.split()[1:4] for line in lines[2 + vertices:2 + vertices + faces]]
    return points, [[int(v) for v in triangle] for triangle in triangles]


def write_off(stl, path):
    """A binary STL with its equal corners made one."""
    nodes, triangles = {}, []
    for (corners,) in STL_TRIANGLE.iter_unpack(stl.read_bytes()[STL_HEADER:]):
        places = [struct.unpack_from("<3f", corners, 12 * corner) for corner in range(3)]
        triangles.append([nodes.setdefault(place, len(nodes)) for place in places])
    lines = ["OFF", f"{len(nodes)} {len(triangles)} 0"]
    lines += [f"{x!r} {y!r} {z!r}" for x, y, z in nodes]
    lines += [f"3 {a} {b} {c}" for a, b, c in triangles]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def mean_edges(points, triangles):
    """Of each vertex, the mean length of its edges."""
    at = [[float(word) for word in point.split()] for point in points]
    sums, counts = [0.0] * len(at), [0] * len(at)
    for triangle in triangles:
        for i in range(3):
            a, b = triangle[i], triangle[(i + 1) % 3]
            length = sum((p - q) ** 2 for p, q in zip(at[a], at[b])) ** 0.5
            sums[a] += length
            counts[a] += 1
    return [total / count for total, count in zip(sums, counts)]


def shells_of(vertices, triangles):
    """Of each triangle, the number of its shell, from 1."""
    parent = list(range(vertices))

    def root(v):
        while parent[v] != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v

    for a, b, c in triangles:
        parent[root(b)] = root(a)
        parent[root(c)] = root(a)
    numbers = {}
    return [numbers.setdefault(root(a), len(numbers) + 1) for a, _, _ in triangles]


class Gmsh:
    """gmsh -algo hxt with one thread, from a surface that it takes as discrete."""

    name = "Gmsh HXT"
    program = "gmsh"

    def __init__(self, folder, points, triangles, _holes):
        self.folder = folder
        self.mesh = folder / "gmsh_out.msh"
        self.longest = max(mean_edges(points, triangles))
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(points))]
        lines += [f"{i} {point}" for i, point in enumerate(points, 1)]
        lines += ["$EndNodes", "$Elements", str(len(triangles))]
        # HXT tells the outside and the holes from the volume by the shells round them.
        shells = shells_of(len(points), triangles)
        lines += [f"{i} 2 2 {shell} {shell} {a + 1} {b + 1} {c + 1}"
                  for i, ((a, b, c), shell) in enumerate(zip(triangles, shells), 1)]
        lines += ["$EndElements", ""]
        (folder / "gmsh.msh").write_text("\n".join(lines), encoding="ascii")
        (folder / "gmsh.geo").write_text(
            'Merge "gmsh.msh";\n' +
            "".join(f"Surface Loop({i}) = {{{i}}};\n" for i in range(1, max(shells) + 1)) +
            "Volume(1) = {" + ", ".join(str(i) for i in range(1, max(shells) + 1)) + "};\n",
            encoding="ascii")

    def command(self, scale):
        """Size factors have no effect on a discrete surface; only an upper bound has."""
        bound = ["-setnumber", "Mesh.MeshSizeMax", f"{scale * self.longest:.6g}"]
        return ["gmsh", "gmsh.geo", "-3", "-algo", "hxt", "-nt", "1", "-save_all", "-format",
                "msh22", "-o", self.mesh.name, *(bound if scale < 1 else [])]

    @staticmethod
    def seconds(said):
        found = re.findall(r"Done meshing 3D \(Wall ([0-9.]+)s, CPU ([0-9.]+)s\)", said)
        return float(found[-1][1]) if found else None


class TetGen:
    """tetgen -pYqm with the mean edge of each vertex as its size."""

    name = "TetGen"
    program = "tetgen"

    def __init__(self, folder, points, triangles, holes):
        self.folder = folder
        self.mesh = folder / "tetgen.1.ele"
        self.sizes = mean_edges(points, triangles)
        lines = [f"{len(points)} 3 0 0"] + [f"{i} {point}" for i, point in enumerate(points)]
        lines += [f"{len(triangles)} 0"] + [f"3 {a} {b} {c}" for a, b, c in triangles]
        lines += [str(len(holes))] + [f"{i} {hole}" for i, hole in enumerate(holes)] + ["0", ""]
        (folder / "tetgen.smesh").write_text("\n".join(lines), encoding="ascii")

    def command(self, scale):
        lines = [f"{len(self.sizes)} 1"] + [f"{scale * size:.9g}" for size in self.sizes] + [""]
        (self.folder / "tetgen.mtr").write_text("\n".join(lines), encoding="ascii")
        return ["tetgen", "-pYqm", "tetgen.smesh"]

    @staticmethod
    def seconds(said):
        total = re.search(r"Total running seconds:\s*([0-9.]+)", said)
        output = re.search(r"Output seconds:\s*([0-9.]+)", said)
        return float(total[1]) - (float(output[1]) if output else 0) if total else None


def run(command, folder, timeout_s):
    """(what it said, CPU seconds, wall seconds, peak MB) of the whole process."""
    with open(folder / "said", "w+", encoding="utf-8", errors="replace") as said:
        child = subprocess.Popen(command, cwd=folder, stdout=said, stderr=subprocess.STDOUT,
                                 env={**os.environ, "OMP_NUM_THREADS": "1"})
        start = time.monotonic()
        while True:
            process, status, use = os.wait4(child.pid, os.WNOHANG)
            if process:
                break
            if time.monotonic() > start + timeout_s:
                child.kill()
            time.sleep(0.02)
        child.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        text = said.read()
    if child.returncode != 0:
        raise RuntimeError(f"{command[0]} ended with {child.returncode}: {text[-300:].strip()}")
    return text, use.ru_utime + use.ru_stime, time.monotonic() - start, use.ru_maxrss * 1024e-6


class Contest:
    """One case: the surface, and each program's figures, run after run."""

    def __init__(self, options, name, case, folder):
        self.options, self.name, self.folder = options, name, folder
        self.surface = folder / "surface.off"
        holes = self.make_surface(case)
        points, self.triangles = read_off(self.surface)
        self.peers = [peer(folder, points, self.triangles, holes) for peer in (Gmsh, TetGen)
                      if name not in ALONE and shutil.which(peer.program)]
        self.scale = {}
        self.runs = {}

    def make_surface(self, case):
        """The surface's file and the growth; a point in each hole is returned."""
        if self.name in REAL:
            file, self.growth = case
            file = pathlib.Path(os.environ["TETFARM_DATA"]) / file
            if file.suffix == ".gz":
                self.surface.write_bytes(gzip.decompress(file.read_bytes()))
            else:
                write_off(file, self.surface)
            return []
        shape, spacing, self.growth, holes = case
        subprocess.run([self.options.program, "shape", shape, "-o", str(self.surface), "--spacing",
                        str(spacing)], check=True, capture_output=True)
        return holes

    def run_ours(self):
        said, *_ = run([self.options.bench, "mesh", str(self.surface), str(self.growth)], self.folder,
                         self.options.timeout)
        figures = json.loads(said)
        self.runs.setdefault("Tetfarm", []).append(figures)
        return figures["elements"]

    def measure(self, peer):
        said, *_ = run([self.options.bench, "measure", str(self.surface), str(self.growth), str(peer.mesh)],
                         self.folder, self.options.timeout)
        return json.loads(said)

    def run_peer(self, peer, scale):
        peer.mesh.unlink(missing_ok=True)
        said, cpu, wall, memory = run(peer.command(scale), self.folder, self.options.timeout)
        return {"cpu_s": peer.seconds(said), "process_cpu_s": cpu, "process_wall_s": wall,
                "peak_mb": memory, **self.measure(peer)}

    def find_scale(self, peer, wanted):
        """The first run of a peer: scaled until it makes about as many tets as are wanted. One that
        cannot be brought there keeps its own size."""
        scale, unscaled = 1.0, None
        for _ in range(SCALINGS):
            figures = self.run_peer(peer, scale)
            unscaled = unscaled or figures
            ratio = figures["elements"] / wanted
            if abs(ratio - 1) <= CLOSE_ENOUGH:
                self.scale[peer.name], self.runs[peer.name] = scale, [figures]
                return
            scale *= ratio ** (1 / 3)
        self.scale[peer.name], self.runs[peer.name] = 1.0, [unscaled]

    def hold(self):
        wanted = self.run_ours()
        for peer in list(self.peers):
            try:
                self.find_scale(peer, wanted)
            except RuntimeError as error:
                print(f"{self.name}: {error}", file=sys.stderr)
                self.peers.remove(peer)
        for _ in range(self.options.runs - 1):
            self.run_ours()
            for peer in self.peers:
                self.runs[peer.name].append(self.run_peer(peer, self.scale[peer.name]))

    def rows(self):
        ours = statistics.median(run["cpu_s"] / run["elements"] for run in self.runs["Tetfarm"])
        for name, runs in self.runs.items():
            one = runs[-1]
            tets = one["elements"]

            def median(key):
                return statistics.median(figures[key] for figures in runs)

            cpu, theirs = median("cpu_s"), median("cpu_s") / tets
            cracks = "" if one["boundary_faces"] == len(self.triangles) else ", cracked"
            yield (f"| {self.name} | {name}{cracks} | {tets / 1e3:.0f} | {cpu:.2f} | "
                   f"{median('process_cpu_s'):.2f} / {median('process_wall_s'):.2f} | "
                   f"{tets / cpu / 1e3:.0f} | "
                   f"{theirs / ours:.2f} | {median('peak_mb'):.0f} | "
                   f"{one['min_dihedral_deg']:.1f} / {one['max_dihedral_deg']:.1f} | "
                   f"{100 * one['share_below_20_deg']:.3f} | {one['mean_radius_ratio']:.3f} | "
                   f"{one['mean_edge_over_spacing']:.2f} | "
                   f"{100 * one['share_of_fitting_edges']:.0f} |")


def hold_delaunay(options, kind, count):
    """{program: [(tets, CPU seconds, peak MB, bytes a tet or None)]}, the programs in turn."""
    programs = [("Tetfarm", "delaunay_trial"), ("CGAL", "delaunay_with_cgal")]
    runs = {}
    with tempfile.TemporaryDirectory(prefix="tetfarm_peers.") as folder:
        for _ in range(options.runs):
            for name, file in programs:
                path = pathlib.Path(options.bench).parent / file
                if not path.exists():
                    continue
                said, _, _, memory = run([str(path), kind, str(count), "1"], pathlib.Path(folder),
                                         options.timeout)
                tets, seconds = re.search(r"([0-9.e+]+) tets, ([0-9.e+-]+) s", said).groups()
                held = re.search(r"([0-9.]+) bytes a tet", said)
                runs.setdefault(name, []).append((float(tets), float(seconds), memory,
                                                  held and float(held[1])))
    return runs


def delaunay_rows(case, runs):
    def rate(one):
        return one[0] / one[1]

    medians = {name: statistics.median(rate(one) for one in of) for name, of in runs.items()}
    for name, of in runs.items():
        held = f"{of[0][3]:.1f}" if of[0][3] else ""
        ratio = f"{medians['Tetfarm'] / medians[name]:.2f}"
        yield (f"| {case} | {name} | {of[0][0] / 1e6:.2f} | {medians[name] / 1e6:.2f} | {ratio} | "
               f"{held} | {statistics.median(one[2] for one in of):.0f} |")


def print_delaunay(options, cases):
    print("\n| points | program | M tets | M tets/s | ours is so many times faster | bytes a tet, held "
          "| peak MB |\n" + "|---" * 2 + "|--:" * 5 + "|")
    for name, (kind, count) in cases.items():
        print("\n".join(delaunay_rows(name, hold_delaunay(options, kind, count))), flush=True)


def print_contests(options, cases):
    print("| case | program | k tets | meshing, CPU s | process, CPU / wall s | k tets/s | time per tet, ours = 1 "
          "| peak MB | dihedral min / max, deg | angles < 20 deg, % | mean radius ratio "
          "| edge / spacing | edges in 0.7-1.4, % |\n" + "|---" * 2 + "|--:" * 11 + "|")
    for name, case in cases.items():
        folder = pathlib.Path(tempfile.mkdtemp(prefix="tetfarm_peers."))
        try:
            contest = Contest(options, name, case, folder)
            contest.hold()
            print("\n".join(contest.rows()), flush=True)
        finally:
            shutil.rmtree(folder, ignore_errors=True)


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--large", action="store_true", help="also the large cases")
    parser.add_argument("--real", action="store_true", help="real surfaces instead")
    parser.add_argument("--cases", default="", help="names, with commas between them")
    parser.add_argument("--runs", type=int, default=5, help="of each program; the median is told")
    parser.add_argument("--program", default=str(ROOT / "build/release/bin/tetfarm"))
    parser.add_argument("--bench", default=str(ROOT / "build/release/bin/kernel_bench"))
    parser.add_argument("--timeout", type=float, default=1800, help="seconds for each run")
    return parser.parse_args()


def main():
    options = parse_arguments()
    cases = {**CASES, **LARGE, **REAL}
    points = {**POINTS, **LARGE_POINTS}
    usual = [*CASES, *POINTS, *([*LARGE, *LARGE_POINTS] if options.large else [])]
    usual = [*REAL] if options.real else usual
    chosen = options.cases.split(",") if options.cases else usual
    unknown = sorted(set(chosen) - {*cases, *points})
    if unknown:
        print(f"unknown cases: {', '.join(unknown)}; there are {', '.join([*cases, *points])}",
              file=sys.stderr)
        return 2
    commit = first_line(["git", "rev-parse", "--short", "HEAD"])
    print(f"{time.strftime('%Y-%m-%d')}, commit {commit}, {machine()}; one thread, median of "
          f"{options.runs} runs in turn.\n")
    contests = {name: cases[name] for name in chosen if name in cases}
    if contests:
        print_contests(options, contests)
    delaunay = {name: points[name] for name in chosen if name in points}
    if delaunay:
        print_delaunay(options, delaunay)
    return 0


if __name__ == "__main__":
    sys.exit(main())
