#!/usr/bin/env python3
"""What somebody does in the first hour, with nothing but the package: a job file, a run that is watched, a farm of two workers
of which one is killed, the result without a shared disk, the same mesh, and a case for OpenFOAM.

  newcomer.py BUILD [--chroot]

The package of Debian is made from a build folder whose program is there. It is installed in a folder of its own, in place of
the root of a system, where the program uses the libraries of this machine; with --chroot in a fresh Debian 12, by debootstrap
and apt-get, which want a network. Chromium opens the page of the run, and checkMesh looks at the case, where they are installed. Ends with 77 where a program is
missing or nobody may install, unless CI is set and nothing is fetched, and with 1 when something is not as it should be.
"""

import contextlib
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request

from check_packages import NEEDED, SKIPPED, Root, make_packages, require, run, told_when_wrong

SIZE = 0.35  # of the tetrahedra in the wing's air: some seconds of work for each of 8 sub-domains
PATIENCE = 120  # seconds
MIRROR = "http://deb.debian.org/debian"
WORK = "/srv/newcomer"


def await_that(condition, what):
    until = time.monotonic() + PATIENCE
    while time.monotonic() < until:
        found = condition()
        if found:
            return found
        time.sleep(0.05)
    require(False, f"in vain for {PATIENCE} s: {what}")


def install(package, folder):
    """In a folder in place of a root; gives back the words that start the program, and the root."""
    root = Root(folder / "root")
    root.dpkg("-i", package)
    return [root / "usr/bin/tetfarm"], root.folder


def install_in_debian(package, folder):
    """The same in a fresh Debian, with the libraries that the package asks for."""
    root = folder / "root"
    run(["debootstrap", "--variant=minbase", "bookworm", root, MIRROR])
    shutil.copy(package, root / "tmp")
    # Its /proc is there for the one command only, so that nothing is left mounted.
    there = ["unshare", "--mount", "sh", "-c", 'mount -t proc proc "$0/proc" && exec chroot "$0" "$@"', root]
    run([*there, "apt-get", "-q", "install", "-y", "--no-install-recommends", f"/tmp/{package.name}"],
        env={**os.environ, "DEBIAN_FRONTEND": "noninteractive", "LC_ALL": "C.UTF-8"})
    return [*there, "env", "-C", WORK, "tetfarm"], root


class Session:
    """A folder to work in, the installed program, and the processes that were left running.

    `command` starts the program in the folder; in its environment paths begin at `root`, where it has one of its own.
    """

    def __init__(self, command, root):
        self.folder = root / WORK.lstrip("/")
        self.folder.mkdir(parents=True)
        here = WORK if len(command) > 1 else str(self.folder)
        self.command, self.here, self._running = command, here, []
        kept = {name: value for name, value in os.environ.items() if not name.startswith("TETFARM")}
        self.environment = {**kept, "HOME": here, "XDG_CONFIG_HOME": f"{here}/configuration", "LC_ALL": "C.UTF-8",
                            "TMPDIR": here}

    def tetfarm(self, *words):
        return run([*self.command, *words], cwd=self.folder, env=self.environment)

    def start(self, output, *words):
        """In the background; what it says is in the file `output`."""
        with open(self.folder / output, "w", encoding="utf-8") as out:
            process = subprocess.Popen([str(word) for word in (*self.command, *words)], cwd=self.folder,
                                       env=self.environment, stdout=out, stderr=subprocess.STDOUT)
        self._running.append(process)
        return process

    def said(self, output, pattern):
        """What a pattern finds in the words of a program that runs."""
        def found():
            return re.search(pattern, (self.folder / output).read_text(encoding="utf-8"))
        return await_that(found, f"{pattern} in {output}").group(1)

    def close(self):
        for process in reversed(self._running):
            process.send_signal(signal.SIGKILL)
            process.wait()


def answer_of(url):
    try:
        with urllib.request.urlopen(url, timeout=20) as answer:
            return answer.read().decode("utf-8")
    except (urllib.error.URLError, ConnectionError):
        return ""


def write_job_file(session):
    """The surface, and the job file that `init` writes for it; two of its settings are taken up with other values."""
    session.tetfarm("shape", "wing", "-o", "wing.stl", "--spacing", "0.1")
    session.tetfarm("init", "wing.stl")
    job = session.folder / "wing.toml"
    text = job.read_text(encoding="utf-8")
    require("symmetry" in text and "far field" in text, f"init does not tell of the patches:\n{text}")
    for key, value in (("default", SIZE), ("subdomains", 8)):
        text, count = re.subn(rf"^#{key} = .*$", f"{key} = {value}", text, flags=re.MULTILINE)
        require(count == 1, f"`#{key} = …` is there {count} times:\n{text}")
    job.write_text(text, encoding="utf-8")


def watch_a_run(session):
    """The run answers browsers while it lasts; gives back its digest."""
    running = session.start("run.txt", "run", "wing.toml", "-o", "out", "-j", "1", "--watch", "--http", "127.0.0.1:0",
                            "--json", "--progress", "none")
    address = session.said("run.txt", r"(http://127\.0\.0\.1:\d+/)")
    await_that(lambda: '"wing"' in answer_of(address + "api/v1/jobs"), "an answer that tells of the run that is watched")
    require("<script" in answer_of(address), "the watched run has no page")
    if shutil.which("chromium"):
        shown = subprocess.run(["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--dump-dom",
                                f"--user-data-dir={session.folder / 'browser'}", address],
                               text=True, check=False, capture_output=True, timeout=PATIENCE)
        require("<h1>Jobs</h1>" in shown.stdout, f"Chromium shows {shown.stdout}{shown.stderr}")
    require(running.wait(PATIENCE) == 0, (session.folder / "run.txt").read_text(encoding="utf-8"))
    return digest_in((session.folder / "run.txt").read_text(encoding="utf-8"))


def digest_in(output):
    results = [line for line in output.splitlines() if line.startswith('{"type":"result"')]
    require(results, f"there is no result in\n{output}")
    return json.loads(results[-1])["digest"]


def start_farm(session):
    """A coordinator that knows its peers by keys, and two workers that share no folder with it."""
    session.tetfarm("keys", "new", "coordinator", "--keys", "keys")
    for name, role in (("node", "worker"), ("anna", "submitter")):
        session.tetfarm("keys", "new", name)
        session.tetfarm("keys", "authorize", f"{name}.pub", "--role", role, "--keys", "keys")
    session.start("coordinator.txt", "coordinator", "--store", "store", "--keys", "keys", "--listen",
                  "tcp://127.0.0.1:*", "--heartbeat-ms", "200", "--lease-ms", "2000")
    address = session.said("coordinator.txt", r"listening on (tcp://\S+)")
    session.environment.update(TETFARM_COORDINATOR=address, TETFARM_KEY=f"{session.here}/anna.key",
                               TETFARM_COORDINATOR_KEY=f"{session.here}/keys/coordinator.pub")
    return [session.start(f"worker_{name}.txt", "worker", "--connect", address, "--key", "node.key", "--cache",
                          f"cache_{name}", "--no-shared-store") for name in ("first", "second")]


def mesh_on_the_farm(session):
    """One of two workers is killed at its work; gives back the digest of what is fetched."""
    workers = start_farm(session)
    job = session.tetfarm("submit", "wing.toml").strip()
    await_that(lambda: session.tetfarm("tasks", job, "--state", "running", "--json").count('"kind":"mesh"') >= 2,
               "both workers at work")
    workers[0].send_signal(signal.SIGKILL)
    digest = digest_in(session.tetfarm("wait", job, "-o", "fetched", "--json", "--progress", "none"))
    lost = json.loads(session.tetfarm("status", job, "--json").splitlines()[-1])["attempts_lost"]
    require(lost >= 1, "the worker that was killed has lost no attempt")
    return digest


def look_with_openfoam(session):
    session.tetfarm("export", "fetched", "-o", "case", "--format", "openfoam", "--patch-type", "wing=wall")
    require((session.folder / "case/system/controlDict").is_file(), "the case has no controlDict")
    if shutil.which("checkMesh") is None:
        return "checkMesh is not there"
    said = run(["checkMesh", "-case", "case"], cwd=session.folder,
               env={**session.environment, "WM_PROJECT_DIR": "/usr/share/openfoam"})
    require("Mesh OK" in said, said)
    return "checkMesh: Mesh OK"


def main():
    build, in_debian = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:] == ["--chroot"]
    missing = [name for name in (*NEEDED, *(["debootstrap"] if in_debian else [])) if shutil.which(name) is None]
    if missing or os.geteuid() != 0:
        print(f"missing: {', '.join(missing)}" if missing else "only root can install packages")
        sys.exit(1 if os.environ.get("CI") and not in_debian else SKIPPED)
    with told_when_wrong(), tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name).resolve()
        packages = make_packages(build, folder / "packages")
        session = Session(*(install_in_debian if in_debian else install)(packages["tetfarm"], folder))
        with contextlib.closing(session):
            write_job_file(session)
            watched = watch_a_run(session)
            require(mesh_on_the_farm(session) == watched, "the farm makes another mesh than the run")
            print(look_with_openfoam(session))


if __name__ == "__main__":
    main()
