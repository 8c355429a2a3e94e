#!/usr/bin/env python3
"""Other compilers, optimisation and processor features make the same bytes.

Builds tests/builds/kernel_digests.cpp, and the kernel with it, in other ways, and compares what it prints
with what the build's own prints. Then looks for fused multiply-adds in the kernel's machine code: the surfaces may
not come by one. Arguments: the root of the repository, a folder for the other builds, the
program of the own build. Real models count when TETFARM_DATA names their folder.

Ends with 77, a skipped test, where there is no clang; where CI is set that is a failure.
"""

import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys

SKIPPED = 77

# What x86-64-v3 asks for beyond what every 64-bit processor has, as /proc/cpuinfo calls it.
V3_FLAGS = {"avx", "avx2", "bmi1", "bmi2", "f16c", "fma", "abm", "movbe"}

FUSED = re.compile(r"\bvfn?m(add|sub)\w*")


def processor_flags():
    path = pathlib.Path("/proc/cpuinfo")
    if platform.machine() != "x86_64" or not path.is_file():
        return set()
    lines = [line for line in path.read_text(encoding="utf-8").splitlines() if line.startswith("flags")]
    return set(lines[0].split(":", 1)[1].split()) if lines else set()


def other_builds():
    """name: (C++ compiler, C compiler, flags)"""
    has_v3 = V3_FLAGS <= processor_flags()
    return {
        "clang": ("clang++", "clang", "-O3 -march=x86-64-v3" if has_v3 else "-O3"),
        "gcc": ("g++", "gcc", "-O3 -march=native"),
    }


def run(command):
    """Its output; a command that fails ends the test with what it said."""
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(f"{' '.join(command)}\nended with {done.returncode}:\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
        sys.exit(1)
    return done.stdout


def built(root, folder, compiler, c_compiler, flags):
    run(["cmake", "-G", "Ninja", "-S", str(root), "-B", str(folder), f"-DCMAKE_CXX_COMPILER={compiler}",
         f"-DCMAKE_C_COMPILER={c_compiler}", f"-DCMAKE_CXX_FLAGS={flags}", "-DCMAKE_BUILD_TYPE=",
         "-DTETFARM_ROOMS_IN_BATCHES=ON"])
    run(["cmake", "--build", str(folder), "--target", "kernel_digests"])
    return folder / "bin" / "kernel_digests"


def digests(program):
    data = os.environ.get("TETFARM_DATA")
    lines = run([str(program)] + ([data] if data else [])).splitlines()
    return {tuple(line.split()[:2]): line.split()[2] for line in lines}


def differences(own, other):
    """The first step of each case that is not the same: those after it follow from it."""
    found = {}
    for case, step in list(own) + list(other):
        if own.get((case, step)) != other.get((case, step)):
            found.setdefault(case, step)
    return found


def fused_instructions(folder):
    """The kernel's functions with x86's fused multiply-adds (vfmadd132sd, vfnmsub..., vfmaddsub...), one of each."""
    found = {}
    for library in sorted(folder.glob("libmesh_*.a")):
        function = ""
        for line in run(["objdump", "-d", "-C", "--no-show-raw-insn", str(library)]).splitlines():
            if line.endswith(">:"):
                function = line.split(" ", 1)[1]
            instruction = FUSED.search(line)
            if instruction:
                found[library.name + " " + function] = instruction.group()
    return found


def main():
    root, folder, program = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
    if shutil.which("clang++") is None:
        print("clang++ is not installed: builds cannot be compared (./dev packages installs it)")
        return 1 if os.environ.get("CI") else SKIPPED
    own = digests(program)
    failed = not own
    for name, (compiler, c_compiler, flags) in other_builds().items():
        found = differences(own, digests(built(root, folder / name, compiler, c_compiler, flags)))
        print(f"{compiler} {flags}: {len(own)} digests, {len(found)} cases differ")
        for case, step in found.items():
            print(f"  {case}: first in {step}")
        fused = fused_instructions(folder / name)
        for function, instruction in fused.items():
            print(f"  {instruction} in {function}")
        failed = failed or bool(found) or bool(fused)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
