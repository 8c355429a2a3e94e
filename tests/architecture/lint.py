#!/usr/bin/env python3
"""clang-tidy over all files of the rooms, in the batches of a build folder of the preset `lint`: lint.py FOLDER

The checks are those of .clang-tidy; any finding is an error. Each finding is told once, though headers are read by many.
Headers that no .cpp of their name includes first (check_own_header_first.py sees to the others), those of tests among
them, are compiled alone.
"""

import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys

ROOMS = "base json mesh tasks proto store coordinator worker pool report cli".split()
FINDING = re.compile(r"^(/\S+?):(\d+):(\d+): (?:warning|error): .*")
INCLUDED = re.compile(r'^#include "(/[^"]+\.cpp)"', re.MULTILINE)


def sources_of(path, text):
    """The files of rooms that a file to compile stands for: those of its batch, or itself."""
    return INCLUDED.findall(text) if "/Unity/" in path else [path]


def is_of_room(path, root):
    return os.path.relpath(path, root).split("/")[0] in ROOMS


def missing_sources(linted, root):
    """Those .cpp of the rooms that no compilation has, relative to the root."""
    missing = []
    for room in ROOMS:
        for folder, _, names in os.walk(os.path.join(root, room)):
            for name in names:
                path = os.path.join(folder, name)
                if name.endswith(".cpp") and path not in linted:
                    missing.append(os.path.relpath(path, root))
    return sorted(missing)


def findings_of(output):
    """{first line of a finding: that and the lines below it}."""
    findings = {}
    current = None
    for line in output.splitlines():
        if FINDING.match(line):
            current = line
            findings[current] = [line]
        elif current:
            findings[current].append(line)
    return findings


def tidy(folder, path):
    run = subprocess.run(["clang-tidy", "--quiet", "-p", folder, path], capture_output=True, text=True)
    return run.returncode, run.stdout, run.stderr


def headers_alone(root):
    """Headers without a .cpp of their name, relative to the root."""
    headers = []
    for room in ROOMS + ["tests"]:
        for folder, _, names in os.walk(os.path.join(root, room)):
            headers += [os.path.join(folder, name) for name in names
                        if name.endswith(".h") and name[:-2] + ".cpp" not in names]
    return sorted(os.path.relpath(header, root) for header in headers)


def ways_to_headers(entries):
    """Every folder that a compilation of the build folder looks for headers in, and our own macros, as options."""
    ways = {}
    for entry in entries:
        words = shlex.split(entry["command"])
        for word, follower in zip(words, words[1:] + [""]):
            if word == "-isystem":
                ways[word + follower] = None
            elif word.startswith(("-I", "-DTETFARM")):
                ways[word] = None
    return list(ways)


def compile_alone(header, options, root):
    run = subprocess.run(["clang++", "-std=c++20", "-Wno-pragma-once-outside-header", *options, "-fsyntax-only", "-x", "c++", os.path.join(root, header)],
                         capture_output=True, text=True)
    return "" if run.returncode == 0 else f"{header}: does not compile alone\n{run.stderr.strip()}"


def main():
    folder = os.path.abspath(sys.argv[1])
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    with open(os.path.join(folder, "compile_commands.json"), encoding="utf-8") as file:
        entries = json.load(file)
    compiled = sorted({entry["file"] for entry in entries})
    files = {}
    for path in compiled:
        with open(path, encoding="utf-8") as file:
            sources = sources_of(path, file.read())
        if sources and all(is_of_room(source, root) for source in sources):
            files[path] = sources
    linted = {source for sources in files.values() for source in sources}
    problems = [f"{path}: is compiled by no target" for path in missing_sources(linted, root)]
    findings = {}
    # The longest first, so that the last to end is a short one.
    order = sorted(files, key=lambda path: -len(files[path]))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for path, (status, output, errors) in zip(order, pool.map(lambda path: tidy(folder, path), order)):
            found = findings_of(output)
            findings.update(found)
            if status != 0 and not found:
                problems.append(f"{path}: clang-tidy ended with {status}\n{errors.strip()}")
        headers = headers_alone(root)
        ways = ways_to_headers(entries)
        problems += filter(None, pool.map(lambda header: compile_alone(header, ways, root), headers))
    for _, lines in sorted(findings.items()):
        print("\n".join(lines))
    print("\n".join(problems))
    print(f"{len(linted)} files in {len(files)} batches and {len(headers)} headers, {len(findings) + len(problems)} findings")
    sys.exit(1 if findings or problems else 0)


if __name__ == "__main__":
    main()
