#!/usr/bin/env python3
"""clang-tidy over all files of the rooms, in the batches of a build folder of the preset `lint`: lint.py FOLDER

The checks are those of .clang-tidy; any finding is an error. Each finding is told once, though headers are read by many.
Headers that no .cpp of their name includes first (check_own_header_first.py sees to the others), those of tests among
them, are compiled alone. What was clean before and reads the same, comments and macros included, is not looked at again
(lint_cache.py).
"""

import concurrent.futures
import json
import os
import re
import shlex
import subprocess
import sys

import lint_cache

ROOMS = "base json mesh tasks proto store coordinator worker pool report http dashboard cli".split()
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


def preprocessed(command, folder):
    """What the compiler reads, with comments and macros, which clang-tidy reads too; None where that fails."""
    run = subprocess.run([*command, "-E", "-C", "-dD", "-o", "-"], cwd=folder, capture_output=True)
    return run.stdout if run.returncode == 0 else None


def command_of(entry):
    """Of a compilation, without where its object goes."""
    words = shlex.split(entry["command"])
    if "-o" in words:
        at = words.index("-o")
        del words[at:at + 2]
    return [word for word in words if word not in ("-c", "ccache") and not word.endswith("/ccache")]


def what_clean_rests_on(root):
    """What a clean result rests on beside the file: the checks, the programs, and this one."""
    versions = [subprocess.run([program, "--version"], capture_output=True).stdout
                for program in ("clang-tidy", "clang++")]
    files = []
    for path in (os.path.join(root, ".clang-tidy"), os.path.abspath(__file__)):
        with open(path, "rb") as file:
            files.append(file.read())
    return versions + files


class Lint:
    """The checks of one run, which know what was clean before."""

    def __init__(self, folder, root, entries, results):
        self.folder = folder
        self.root = root
        self.commands = {entry["file"]: (command_of(entry), entry["directory"]) for entry in entries}
        self.options = ways_to_headers(entries)
        self.results = results
        self.rests_on = what_clean_rests_on(root)

    def key(self, command, folder):
        text = preprocessed(command, folder)
        return text and lint_cache.key_of(*self.rests_on, " ".join(command).encode(), text)

    def tidy(self, path):
        key = self.key(*self.commands[path])
        if key and self.results.has(key):
            return 0, "", ""
        status, output, errors = tidy(self.folder, path)
        if key and status == 0 and not findings_of(output):
            self.results.add(key)
        return status, output, errors

    def compile_alone(self, header):
        key = self.key(command_alone(header, self.options, self.root), self.root)
        if key and self.results.has(key):
            return ""
        problem = compile_alone(header, self.options, self.root)
        if key and not problem:
            self.results.add(key)
        return problem


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


def command_alone(header, options, root):
    return ["clang++", "-std=c++20", "-Wno-pragma-once-outside-header", *options, "-x", "c++", os.path.join(root, header)]


def compile_alone(header, options, root):
    run = subprocess.run([*command_alone(header, options, root), "-fsyntax-only"], capture_output=True, text=True)
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
    results = lint_cache.CleanResults(lint_cache.folder_of_user())
    results.forget_unused()
    lint = Lint(folder, root, entries, results)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for path, (status, output, errors) in zip(order, pool.map(lint.tidy, order)):
            found = findings_of(output)
            findings.update(found)
            if status != 0 and not found:
                problems.append(f"{path}: clang-tidy ended with {status}\n{errors.strip()}")
        headers = headers_alone(root)
        problems += filter(None, pool.map(lint.compile_alone, headers))
    for _, lines in sorted(findings.items()):
        print("\n".join(lines))
    print("\n".join(problems))
    print(f"{len(linted)} files in {len(files)} batches and {len(headers)} headers, {len(findings) + len(problems)} findings")
    sys.exit(1 if findings or problems else 0)


if __name__ == "__main__":
    main()
