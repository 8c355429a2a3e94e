#!/usr/bin/env python3
"""One name, one definition: no type, function or inline constant of a namespace is defined in two files.

Two definitions of one name in two rooms are undefined behaviour once a program links both, and no
compiler of today's says so. What stands in an unnamed namespace is a file's own, and may share its
name with others. Overloads are told apart by the text of their parameters. Run in the root of the
repository, or with that as argument.
"""

import collections
import re

from source_files import end, root_of_arguments, texts

RAW_STRING = re.compile(r'R"(\w*)\(.*?\)\1"', re.DOTALL)
COMMENT_OR_TEXT = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"|(?<!\w)'(?:\\.|[^'\\\n])+'", re.DOTALL)
DIRECTIVE = re.compile(r"^[ \t]*#(?:\\\n|[^\n])*", re.MULTILINE)
NAMESPACE = re.compile(r"\bnamespace\b\s*([\w:]*)\s*$")
TYPE = re.compile(r"\b(?:struct|class|union|enum(?:\s+class|\s+struct)?)\s+(?:\[\[[^\]]*\]\]\s*)?([\w:]+)"
                  r"(?:\s+final)?\s*(?::[^:].*)?$", re.DOTALL)
FUNCTION = re.compile(r"^[^=(]*?((?:\w+::)*(?:operator\s*[^\s\w(]+|operator\(\)|~?\w+))\s*\((.*?)\)[^()]*(?: :.*)?$", re.DOTALL)
CONSTANT = re.compile(r"\binline\s+(?:constexpr\s+|const\s+)[^=(]*?\b(\w+)\s*(?:\[[^\]]*\]\s*)?(?:=.*)?$", re.DOTALL)
UNNAMED = "(unnamed)"


def without_comments(text):
    text = RAW_STRING.sub('""', text)
    text = COMMENT_OR_TEXT.sub(lambda found: '""' if found[0][0] in "\"'" else " ", text)
    return DIRECTIVE.sub(" ", text)


def name_of(head, opens_block):
    """What the words before a brace or a semicolon define in a namespace, or None."""
    head = " ".join(head.split())
    if head.startswith(("template <>", "static ")):
        return None
    if opens_block:
        found = TYPE.search(head)
        if found and "(" not in head[:found.start()] and "=" not in head:
            return found[1]
        found = FUNCTION.search(head)
        if found:
            return f"{found[1]}({found[2].strip()})"
    found = CONSTANT.search(head)
    return found[1] if found and "(" not in head.partition("=")[0] else None


def definitions(text):
    """The qualified names that a file defines for all programs that it is linked into."""
    names, scopes, head = [], [], []
    for piece in re.split(r"([{};])", without_comments(text)):
        if piece not in ("{", "}", ";"):
            head.append(piece)
            continue
        words, head = "".join(head), []
        is_open = all(kind == "namespace" for kind, _ in scopes)
        is_shared = is_open and scopes and UNNAMED not in [name for _, name in scopes]
        if piece == "}":
            if scopes:
                scopes.pop()
            continue
        namespace = NAMESPACE.search(words) if piece == "{" else None
        if namespace:
            scopes.append(("namespace", namespace[1] or UNNAMED))
            continue
        name = name_of(words, piece == "{") if is_shared else None
        if name:
            names.append("::".join([scope for _, scope in scopes] + [name]))
        if piece == "{":
            scopes.append(("block", ""))
    return names


def check(files):
    """Complaints about files, {path: text}; empty when every name is defined in one of them."""
    places = collections.defaultdict(set)
    for path, text in files.items():
        for name in definitions(text):
            places[name].add(path)
    return [f"{name} is defined in {' and in '.join(sorted(paths))}: one of them wants another name"
            for name, paths in sorted(places.items()) if len(paths) > 1]


def main():
    files = texts(root_of_arguments(), without=("tests", "examples"))
    end(check(files), f"{len(files)} files: every name has one definition")


if __name__ == "__main__":
    main()
