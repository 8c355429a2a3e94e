"""What the Markdown of this repository links to, and which anchors its headings have, as GitHub and GitLab make them."""

import re

FENCE = re.compile(r"^ *(```+|~~~+)")
HEADING = re.compile(r"^(#{1,6}) +(.*?) *#*$")
# What stands behind the text of a link, which may itself have a picture in it.
LINK = re.compile(r"\]\(([^()\s]+)(?:\s+\"[^\"]*\")?\)")
CODE = re.compile(r"(`+)((?:(?!\n\n).)+?)\1", re.DOTALL)
ITEM = re.compile(r"^ *(?:[-*+]|\d+\.) ")


def lines_with_fences(text):
    """(line, whether it is within a block of code or one of its two fences) of each line."""
    fence = ""
    for line in text.splitlines():
        found = FENCE.match(line)
        if fence:
            yield line, True
            if found and found.group(1).startswith(fence) and line.strip() == found.group(1):
                fence = ""
        else:
            fence = found.group(1) if found else ""
            yield line, bool(fence)


def without_code(text):
    """Of the same length, blank where there is code."""
    lines = [" " * len(line) if code else line for line, code in lines_with_fences(text)]
    return CODE.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), "\n".join(lines))


def links(text):
    """(start, end, target) of each link and picture that is not code."""
    return [(found.start(1), found.end(1), found.group(1)) for found in LINK.finditer(without_code(text))]


def anchor(heading):
    """What a heading is called in links: small letters, no marks but - and _, a hyphen for each blank."""
    words = re.sub(r"!?\[((?:[^\[\]]|\[[^\[\]]*\])*)\]\([^()]*\)", r"\1", heading)
    words = re.sub(r"[`*]", "", words).strip().lower()
    return re.sub(r"[^\w\- ]", "", words).replace(" ", "-")


def headings(text):
    """{number of the line: its anchor}; the second heading of the same words has -1 behind it, the third -2."""
    found, taken = {}, {}
    for number, (line, code) in enumerate(lines_with_fences(text)):
        heading = None if code else HEADING.match(line)
        if heading:
            name = anchor(heading.group(2))
            before = taken.get(name, 0)
            taken[name] = before + 1
            found[number] = f"{name}-{before}" if before else name
    return found
