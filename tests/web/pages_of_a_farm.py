#!/usr/bin/env python3
"""The dashboard as people have it: a coordinator, a worker and a job of a real surface, the pages that are in the
program, and a browser that goes through all of them.

pages_of_a_farm.py TETFARM WEB: the program, and the folder in which npm has built web/. Ends with 77 where there is no
browser, but fails in continuous integration.
"""

import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time

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
        self.coordinator = f"tcp://127.0.0.1:{free_port()}"
        self.running = []

    def __enter__(self):
        store = str(self.folder / "store")
        self.start("coordinator", "--store", store, "--listen", self.coordinator)
        self.start("worker", "--connect", self.coordinator, "--store", store)
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
        dashboard = self.start("dashboard", "--connect", self.coordinator, "--http", "127.0.0.1:0", "--acts",
                               stdout=subprocess.PIPE)
        line = dashboard.stdout.readline()
        found = re.search(r"http://[\d.]+:\d+", line)
        if not found:
            raise SystemExit(f"the dashboard does not say where it is: {line!r}")
        return found.group()


def main(program, web):
    if not os.access(CHROMIUM, os.X_OK):
        print(f"no browser at {CHROMIUM}")
        return 1 if os.environ.get("CI") else 77
    with tempfile.TemporaryDirectory() as folder, Farm(program, folder) as farm:
        subprocess.run([program, "shape", "sphere-in-box", "-o", "ball.stl"], cwd=folder, check=True, timeout=PATIENCE_S,
                       stdout=subprocess.DEVNULL)
        address = farm.address_of_dashboard()
        deadline = time.monotonic() + PATIENCE_S
        farm.ask("submit", "ball.stl", "--subdomains", "12")
        while '"state":"running"' in farm.ask("status", "--json") and time.monotonic() < deadline:
            time.sleep(0.5)
        farm.ask("submit", "ball.stl", "--subdomains", "40", "--size", "0.05")
        return subprocess.run(["node", "tests/browser.mjs"], cwd=web, timeout=400,
                              env={**os.environ, "TETFARM_DASHBOARD_URL": address}).returncode


if __name__ == "__main__":
    sys.exit(main(os.path.abspath(sys.argv[1]), sys.argv[2]))
