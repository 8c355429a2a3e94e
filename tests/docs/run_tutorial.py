#!/usr/bin/env python3
"""The commands of a tutorial are run, in turn and in one shell, and print what the page says.

  run_tutorial.py PAGE PROGRAM [--slurm]

They are run in an empty folder, with PROGRAM as `tetfarm` and with the folder examples of the repository. --slurm: with a
Slurm of its own on this machine, where one is installed. With UPDATE_GOLDEN=1 the numbers in the page are those of this
run afterwards. tutorial.py says how a page is read.
"""

import argparse
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from tutorial import blocks_of, brought_up_to_date, first_difference

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/python"))
from support import processes_in  # noqa: E402

TIME_LIMIT = 300  # seconds
SLURM = ROOT / "tests/system/slurm_farm.sh"
SLURM_PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch")


class Wrong(Exception):
    """The page and the program do not agree."""


def environment_of(folder, program):
    """As a reader has it, without what this one has set for Tetfarm."""
    (folder / "bin").mkdir()
    (folder / "bin/tetfarm").symlink_to(program)
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("TETFARM", "SLURM"))}
    return {**kept, "PATH": f"{folder / 'bin'}:{kept['PATH']}", "HOME": str(folder), "LC_ALL": "C.UTF-8",
            "XDG_CONFIG_HOME": str(folder / "configuration")}


def can_run(block, path):
    return not block.never and (not block.wants or shutil.which(block.wants, path=path) is not None)


def run_blocks(blocks, folder, environment):
    """Runs them in one shell, each with files of its own for what it prints; raises Wrong where one fails."""
    work, outputs = folder / "work", folder / "outputs"
    work.mkdir()
    outputs.mkdir()
    (work / "examples").symlink_to(ROOT / "examples")
    script = ["set -eu"]
    for number, block in enumerate(blocks):
        script.append(f"exec >{outputs}/{number} 2>&1\n{block.commands}")
    shell = subprocess.Popen(["bash", "--noprofile", "--norc", "-c", "\n".join(script)], cwd=work, env=environment,
                             stdin=subprocess.DEVNULL, start_new_session=True)
    try:
        code = shell.wait(TIME_LIMIT)
    except subprocess.TimeoutExpired:
        code = "too late"
    finally:
        end_all(shell, folder)
    printed = [(outputs / str(number)).read_text(encoding="utf-8", errors="replace")
               for number in range(len(list(outputs.iterdir())))]
    if code != 0:
        raise Wrong(f"line {blocks[len(printed) - 1].line}: the commands end with {code}:\n{printed[-1][-5000:]}")
    return printed


def end_all(shell, folder):
    """What the commands left running goes with them."""
    for _ in range(100):
        running = processes_in(folder)
        if shell.poll() is None:
            running[shell.pid] = ""
        if not running:
            return
        for process in running:
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                continue
        shell.poll()
        time.sleep(0.05)


def with_slurm(folder):
    """The settings of a Slurm on this machine; without one, none, but where nothing may be left out."""
    missing = [name for name in SLURM_PROGRAMS if shutil.which(name) is None]
    if missing:
        if os.environ.get("CI"):
            raise Wrong(f"missing: {', '.join(missing)}: ./dev packages batch")
        return {}
    folder.chmod(0o711)  # munge wants its socket to be reachable by all
    port = 32000 + os.getpid() % 60 * 10
    subprocess.run([SLURM, "up", folder / "slurm", "2", str(port), str(os.getpid())], check=True)
    return {"SLURM_CONF": str(folder / "slurm/slurm.conf")}


def complaints_about(blocks, printed):
    for block, output in zip(blocks, printed, strict=True):
        difference = first_difference(block.said, output) if block.said else ""
        if difference:
            yield f"line {block.line}: {difference}; it prints\n{output}"


def bring_up_to_date(path, page, blocks, printed):
    for block, output in reversed(list(zip(blocks, printed, strict=True))):
        if block.said:
            start, end = block.place
            block.said = brought_up_to_date(block.said, output)
            page = page[:start] + block.said + page[end:]
    path.write_text(page, encoding="utf-8")


def run_page(path, program, slurm, folder):
    """Complaints, and how many blocks were run."""
    page = path.read_text(encoding="utf-8")
    environment = environment_of(folder, program.resolve())
    if slurm:
        environment.update(with_slurm(folder))
    blocks = [block for block in blocks_of(page) if can_run(block, environment["PATH"])
              and (block.wants != "sbatch" or "SLURM_CONF" in environment)]
    if not blocks:
        raise Wrong("there is nothing to run")
    printed = run_blocks(blocks, folder, environment)
    if os.environ.get("UPDATE_GOLDEN") == "1":
        bring_up_to_date(path, page, blocks, printed)
    return list(complaints_about(blocks, printed)), len(blocks)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--slurm", action="store_true")
    arguments = parser.parse_args()
    # What ends last, such as Slurm's daemons, may still write as the folder is removed.
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
        folder = pathlib.Path(name).resolve()
        try:
            complaints, count = run_page(arguments.page, arguments.program, arguments.slurm, folder)
        except Wrong as wrong:
            complaints, count = [str(wrong)], 0
        finally:
            if (folder / "slurm").exists():
                subprocess.run([SLURM, "down", folder / "slurm"], check=False)
    print("\n".join([*(f"{arguments.page}: {complaint}" for complaint in complaints), f"{count} blocks run"]))
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
