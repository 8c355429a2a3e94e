#!/usr/bin/env python3
"""The dashboard as people have it: a coordinator, a worker and a job of a real surface, the pages that are in the
program, and a browser that goes through all of them.

pages_of_a_farm.py TETFARM WEB: the program, and the folder in which npm has built web/. Ends with 77 where there is no
browser, but fails in continuous integration.
"""

import json
import math
import os
import pathlib
import re
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time
import urllib.request

CHROMIUM = os.environ.get("TETFARM_CHROMIUM", "/usr/bin/chromium")
PATIENCE_S = 60


def free_port():
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        return listener.getsockname()[1]


class Farm:
    """Processes that end with the block, whatever happens."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = pathlib.Path(folder)
        self.store = str(self.folder / "store")
        self.coordinator = f"tcp://127.0.0.1:{free_port()}"
        self.running = []

    def __enter__(self):
        self.start("coordinator", "--store", self.store, "--listen", self.coordinator)
        self.start("worker", "--connect", self.coordinator, "--store", self.store)
        return self

    def __exit__(self, *_):
        for process in reversed(self.running):
            process.send_signal(signal.SIGTERM)
        for process in reversed(self.running):
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()

    def start(self, *words, **options):
        process = subprocess.Popen([self.program, *words], cwd=self.folder, text=True, **options)
        self.running.append(process)
        return process

    def ask(self, *words):
        return subprocess.run([self.program, *words, "--connect", self.coordinator], cwd=self.folder, text=True,
                              check=True, capture_output=True, timeout=PATIENCE_S).stdout

    def address_of_dashboard(self):
        dashboard = self.start("dashboard", "--connect", self.coordinator, "--store", self.store, "--http", "127.0.0.1:0",
                               "--acts", stdout=subprocess.PIPE)
        line = dashboard.stdout.readline()
        found = re.search(r"http://[\d.]+:\d+", line)
        if not found:
            raise SystemExit(f"the dashboard does not say where it is: {line!r}")
        return found.group()


def answer(address):
    with urllib.request.urlopen(address, timeout=PATIENCE_S) as response:
        return response.read()


def expect(holds, what):
    if not holds:
        raise SystemExit(f"not so: {what}")


def box_of(surface, vertices):
    """The bounding box, six numbers, of a surface as docs/api.md has it."""
    origin = struct.unpack_from("<3d", surface, 24)
    places = struct.unpack_from(f"<{3 * vertices}f", surface, 48)
    axes = [[origin[axis] + value for value in places[axis::3]] for axis in range(3)]
    return [min(axis) for axis in axes] + [max(axis) for axis in axes]


def volume_of(box):
    return math.prod(box[axis + 3] - box[axis] for axis in range(3))


def check_surfaces(address, job):
    """Those of a job that is done: all of them, in the form of docs/api.md, fewer triangles where that is asked for."""
    base = f"{address}/api/v1/jobs/{job}/surfaces"
    told = json.loads(answer(base))
    expect(told["sees_files"] and told["left_out"] == 0, "all files are seen")
    expect(len(told["surfaces"]) == json.loads(answer(f"{address}/api/v1/jobs/{job}"))["subdomains"], "all leaves are there")
    boxes = []
    for line in told["surfaces"]:
        expect(line["is_there"] and line["meshed"] and line["state"] == "leaf", f"{line} is a leaf with its file")
        whole = answer(f"{base}/{line['path']}?triangles=131072")
        version, vertices, triangles, before = struct.unpack_from("<4I", whole, 8)
        expect(whole[:8] == b"TFSHOWN\n" and version == 1 and triangles == before > 0, "a surface, all of it")
        expect(len(whole) == 48 + 12 * vertices + 16 * triangles, "of the size that it says")
        pieces = struct.unpack_from(f"<{triangles}i", whole, len(whole) - 4 * triangles)
        expect(set(pieces) <= {-1, *range(max(1, len(told["patches"])))} and -1 in pieces, "of patches and cuts")
        boxes.append(box_of(whole, vertices))
        few = answer(f"{base}/{line['path']}?triangles=64")
        expect(struct.unpack_from("<I", few, 16)[0] <= 64 and struct.unpack_from("<I", few, 20)[0] == before, "few triangles")
    low = [min(box[axis] for box in boxes) for axis in range(3)]
    high = [max(box[axis + 3] for box in boxes) for axis in range(3)]
    whole = volume_of(low + high)
    expect(all(0 < volume_of(box) < 0.6 * whole for box in boxes), "each a part of the domain")
    print(f"{len(boxes)} surfaces, the domain from {low} to {high}")


def check_maps(address, job):
    """Of a job whose surface was refused: its bad triangles, as docs/api.md says."""
    base = f"{address}/api/v1/jobs/{job}/maps"
    told = json.loads(answer(base))
    expect(told["sees_files"] and len(told["maps"]) == 1, f"{told} has one map")
    line = told["maps"][0]
    expect(line["of"] == "defects" and line["is_there"] and line["meanings"] == ["open edge"], f"{line} is of open edges")
    bad = answer(f"{base}/1")
    triangles = struct.unpack_from("<I", bad, 16)[0]
    expect(bad[:8] == b"TFSHOWN\n" and triangles == 3, f"the three neighbours of the hole, not {triangles}")
    expect(set(bad[-4 * triangles:]) == {0}, "all of the one defect")


def surface_with_hole(folder):
    """All triangles of a surface but the last."""
    text = (folder / "ball.stl").read_text()
    last = text.rindex("facet normal")
    (folder / "open.stl").write_text(text[:last] + text[text.rindex("endsolid"):])


def main(program, web):
    if not os.access(CHROMIUM, os.X_OK):
        print(f"no browser at {CHROMIUM}")
        return 1 if os.environ.get("CI") else 77
    with tempfile.TemporaryDirectory() as folder, Farm(program, folder) as farm:
        subprocess.run([program, "shape", "sphere-in-box", "-o", "ball.stl"], cwd=folder, check=True, timeout=PATIENCE_S,
                       stdout=subprocess.DEVNULL)
        address = farm.address_of_dashboard()
        deadline = time.monotonic() + 2 * PATIENCE_S
        farm.ask("submit", "ball.stl", "--subdomains", "12")
        while '"state":"running"' in farm.ask("status", "--json") and time.monotonic() < deadline:
            time.sleep(0.5)
        check_surfaces(address, "job-1")
        surface_with_hole(farm.folder)
        farm.ask("submit", "open.stl", "--no-check")
        while '"state":"running"' in farm.ask("status", "--json") and time.monotonic() < deadline:
            time.sleep(0.5)
        check_maps(address, "job-2")
        farm.ask("submit", "ball.stl", "--subdomains", "40", "--size", "0.05")
        return subprocess.run(["node", "tests/browser.mjs"], cwd=web, timeout=400,
                              env={**os.environ, "TETFARM_DASHBOARD_URL": address}).returncode


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1]), sys.argv[2]))
