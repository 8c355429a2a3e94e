#!/usr/bin/env python3
"""The example of the library is built with what `cmake --install` leaves, by CMake and by pkg-config, and run.

  use_installed_library.py SOURCES BUILD FLAGS

FLAGS are those the library was compiled with, as far as all that is linked with it wants them too.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def run(words, **more):
    done = subprocess.run([str(word) for word in words], text=True, capture_output=True, **more)
    if done.returncode != 0:
        sys.exit(f"{' '.join(str(word) for word in words)}\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    sources, build = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    flags = [flag for flag in sys.argv[3].split() if flag.startswith("-fsanitize") or flag.startswith("-D_GLIBCXX")]
    example = sources / "examples/library"
    with tempfile.TemporaryDirectory() as folder:
        prefix = pathlib.Path(folder) / "prefix"
        run(["cmake", "--install", build, "--prefix", prefix])
        surface = sources / "examples/cube_sphere/cube_sphere.msh"

        consumer = pathlib.Path(folder) / "consumer"
        run(["cmake", "-S", example, "-B", consumer, f"-DCMAKE_PREFIX_PATH={prefix}",
             f"-DCMAKE_CXX_FLAGS={' '.join(flags)}", "-DCMAKE_CXX_STANDARD=20"])
        run(["cmake", "--build", consumer])
        by_cmake = run([consumer / "mesh_a_surface", surface])

        pc = next(prefix.rglob("tetfarm.pc"))
        pc.write_text(re.sub(r"^prefix=.*$", f"prefix={prefix}", pc.read_text(), flags=re.MULTILINE))
        told = run(["pkg-config", "--cflags", "--libs", "--static", "tetfarm"],
                   env={**os.environ, "PKG_CONFIG_PATH": str(pc.parent)}).split()
        program = pathlib.Path(folder) / "by_hand"
        run(["c++", "-std=c++20", *flags, example / "mesh_a_surface.cpp", *told, "-o", program])
        by_hand = run([program, surface])

        meshed = run([prefix / "bin/tetfarm", "run", surface, "--growth", "0.2", "--subdomains", "1", "-j", "1", "--json",
                      "--progress", "none", "-o", pathlib.Path(folder) / "out"])
    result = json.loads(meshed.splitlines()[-1])
    wanted = f"{result['nodes']} nodes, {result['elements']} tets, volume {result['volume']:.9g}\n"
    for told in (by_cmake, by_hand):
        if told != wanted:
            sys.exit(f"the example says {told!r}, and the program makes {wanted!r}")
    print(wanted, end="")


if __name__ == "__main__":
    main()
