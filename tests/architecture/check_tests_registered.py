#!/usr/bin/env python3
"""Every *_test.cpp is compiled by some program: one that is not would never fail.

Arguments: the root of the repository, the build folder.
"""

import json
import pathlib
import re
import sys


def main():
    root, build = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    commands = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    compiled = {(pathlib.Path(entry["directory"]) / entry["file"]).resolve() for entry in commands}
    for batch in [path for path in compiled if path.parent == build / "batches"]:
        included = re.findall(r'#include "(tests/[^"]+_test\.cpp)"', batch.read_text(encoding="utf-8"))
        compiled |= {(root / path).resolve() for path in included}
    tests = sorted((root / "tests").rglob("*_test.cpp"))
    lost = [path for path in tests if path.resolve() not in compiled]
    for path in lost:
        print(f"{path.relative_to(root)}: no program compiles it "
              "(configure again, or add its room to tests/CMakeLists.txt)")
    print(f"{len(tests)} files of tests, {len(lost)} not compiled")
    return 1 if lost or not tests else 0


if __name__ == "__main__":
    sys.exit(main())
