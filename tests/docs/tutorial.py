"""A tutorial as a test reads it: blocks of commands, what they are said to print, and what of it a machine may leave out.

A block ```sh is run; a block ```text that follows it is what it has to print. There … in a line stands for
anything, and a line of … alone for any lines. A block is not run when the line above it is

    <!-- not run: REASON -->                 never
    <!-- run where there is PROGRAM -->      where that program is not installed
"""

import dataclasses
import re

FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
NOT_RUN = re.compile(r"<!-- not run: .+ -->")
RUN_WHERE = re.compile(r"<!-- run where there is (\S+) -->")
NUMBER = re.compile(r"[0-9]+(?:[.,][0-9]+)*(?:e[+-]?[0-9]+)?")


@dataclasses.dataclass
class Block:
    commands: str
    line: int  # of the page, from 1
    never: bool = False
    wants: str = ""  # a program
    said: str = ""  # what it prints
    place: tuple[int, int] = (0, 0)  # where in the page that stands


def blocks_of(page):
    blocks, end = [], 0
    for found in FENCE.finditer(page):
        between = page[end:found.start()]
        above = between.rstrip("\n").rsplit("\n", 1)[-1]
        end = found.end()
        if found.group(1) == "sh":
            wants = RUN_WHERE.fullmatch(above)
            blocks.append(Block(found.group(2), page.count("\n", 0, found.start()) + 2, bool(NOT_RUN.fullmatch(above)),
                                wants.group(1) if wants else ""))
        elif found.group(1) == "text" and blocks and not blocks[-1].said:
            blocks[-1].said, blocks[-1].place = found.group(2), found.span(2)
    return blocks


def pattern_of(line, numbers=re.escape):
    """What matches a line of what is said; `numbers` gives the pattern of a number in it."""
    parts, end = [], 0
    for found in NUMBER.finditer(line):
        parts += [re.escape(line[end:found.start()]), numbers(found.group())]
        end = found.end()
    return "".join([*parts, re.escape(line[end:])]).replace("…", ".*")


def first_difference(said, printed):
    """Of what a block is said to print and what it printed; "" when there is none."""
    pattern = "".join("(?:.*\n)*?" if line == "…" else pattern_of(line) + "\n" for line in said.splitlines())
    if re.fullmatch(pattern, printed):
        return ""
    lines = printed.splitlines()
    for line in said.splitlines():
        if line != "…" and not any(re.fullmatch(pattern_of(line), other) for other in lines):
            return f"does not print `{line}`"
    return "prints other lines too, or in another order"


def brought_up_to_date(said, printed):
    """What is said, with the numbers of what was printed; each line is looked for behind the one before."""
    lines, result = printed.splitlines(), []
    for line in said.splitlines():
        pattern = re.compile(pattern_of(line, lambda _: f"({NUMBER.pattern})"))
        found = None if line == "…" else next(filter(None, map(pattern.fullmatch, lines)), None)
        if found:
            lines = lines[lines.index(found.string) + 1:]
            numbers = iter(found.groups())
            line = NUMBER.sub(lambda _, numbers=numbers: next(numbers), line)
        result.append(line)
    return "\n".join(result) + "\n"
