"""The sources of the repository, as the checks beside this file read them, and how these checks end."""

import pathlib
import re
import sys

SOURCES = (".h", ".cpp")
OUTSIDE = ("tests", "bench", "examples")  # they see every room, and no room sees them
MADE = ("build", "out")
NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)


def root_of_arguments():
    """The root of the repository: the first argument, or the folder that the check is run in."""
    return pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()


def sources(root):
    """The files of C++ that are not made by a build, in order."""
    for path in sorted(root.rglob("*")):
        first = path.relative_to(root).parts[0]
        if first not in MADE and not first.startswith(".") and path.suffix in SOURCES and path.is_file():
            yield path


def texts(root, without=()):
    """{path in the repository: text} of the sources, but for those of the folders `without`; ends the program when there are none."""
    names = {path.relative_to(root).as_posix(): path for path in sources(root)}
    files = {name: path.read_text(encoding="utf-8") for name, path in names.items() if name.split("/")[0] not in without}
    if not files:
        sys.exit(f"{root}: no sources")
    return files


def count_in_code(pattern, text):
    """How often the pattern is in the text of a file, its comments and texts left out."""
    return len(re.findall(pattern, NOT_CODE.sub("", text)))


def end(complaints, summary=""):
    """Prints the complaints, a line each, then the summary, and ends the program: 1 when there are complaints."""
    for line in [*complaints, summary]:
        if line:
            print(line)
    sys.exit(1 if complaints else 0)
