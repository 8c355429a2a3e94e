#!/usr/bin/env python3
"""What `cmake --install` leaves of the program: its manual and its completions lie where man and shells look.

  check_installed_program.py BUILD
"""

import pathlib
import subprocess
import sys
import tempfile


def printed_by(words):
    done = subprocess.run([str(word) for word in words], text=True, capture_output=True)
    if done.returncode != 0 or done.stderr:
        sys.exit(f"{' '.join(str(word) for word in words)}\n{done.stdout}{done.stderr}")
    return done.stdout


def wanted_files(program):
    """path below the prefix -> what the program prints for it"""
    return {
        "share/man/man1/tetfarm.1": [program, "man"],
        "share/man/man1/tetfarm-run.1": [program, "man", "run"],
        "share/man/man5/tetfarm-job.5": [program, "man", "job"],
        "share/man/man8/tetfarm-worker.8": [program, "man", "worker"],
        "share/bash-completion/completions/tetfarm": [program, "completion", "bash"],
        "share/zsh/site-functions/_tetfarm": [program, "completion", "zsh"],
        "share/fish/vendor_completions.d/tetfarm.fish": [program, "completion", "fish"],
    }


def complaints_of_files(prefix):
    for file, words in wanted_files(prefix / "bin/tetfarm").items():
        path = prefix / file
        if not path.is_file():
            yield f"{file} is not there"
        elif path.read_text(encoding="utf-8") != printed_by(words):
            yield f"{file} is not what the program prints"
    for file in ("systemd/tetfarm-coordinator.service", "README.md"):
        if not (prefix / "share/doc/tetfarm/examples/deploy" / file).is_file():
            yield f"{file} is not among the examples"
    if (prefix / "include").exists():
        yield "the library was installed too"


def complaints_below_usr(build, folder):
    """As a package of Debian is made: below /usr, which lies in another folder."""
    words = ["env", f"DESTDIR={folder}", "cmake", "--install", build, "--prefix", "/usr", "--component", "program"]
    printed_by(words)
    for file in ("bin/tetfarm", "share/zsh/vendor-completions/_tetfarm", "share/man/man1/tetfarm.1"):
        if not (folder / "usr" / file).is_file():
            yield f"{file} is not in the package"


def main():
    build = pathlib.Path(sys.argv[1])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prefix = folder / "prefix"
        printed_by(["cmake", "--install", build, "--prefix", prefix, "--component", "program"])
        complaints = [*complaints_of_files(prefix), *complaints_below_usr(build, folder / "package")]
    print("\n".join(complaints), end="")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
