#!/usr/bin/env python3
"""Every link and picture of the Markdown of the repository leads to a file or a folder of it, and to a heading that is there;
every page is linked from another one.

Links to other sites are not followed. Argument: the root of the repository.
"""

import os
import pathlib
import sys
import urllib.parse

from source_files import MADE, end, root_of_arguments

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "docs/site"))
from markdown_pages import headings, links  # noqa: E402

NOT_OURS = {*MADE, "node_modules"}


def pages(root):
    """{path: text}"""
    found = {}
    for folder, folders, files in os.walk(root):
        folders[:] = [name for name in folders if name not in NOT_OURS and not name.startswith(".")]
        for name in files:
            if name.endswith(".md"):
                path = pathlib.Path(folder) / name
                found[path] = path.read_text(encoding="utf-8")
    return found


def wrong_links(root, files):
    """(complaints, how many links there are within the repository)"""
    anchors = {path: set(headings(text).values()) for path, text in files.items()}
    complaints, count, reached = [], 0, {root / "README.md"}
    for page, text in sorted(files.items()):
        for start, _, target in links(text):
            url = urllib.parse.urlsplit(target)
            if url.scheme or url.netloc:
                continue
            count += 1
            path = pathlib.Path(os.path.normpath(page.parent / urllib.parse.unquote(url.path))) if url.path else page
            if path != page:
                reached |= {path, path / "README.md"}
            what = ""
            if not path.is_relative_to(root):
                what = "leads out of the repository"
            elif not path.exists():
                what = "leads to no file"
            elif url.fragment and url.fragment not in anchors.get(path, set()):
                what = "leads to no heading"
            if what:
                line = text.count("\n", 0, start) + 1
                complaints.append(f"{page.relative_to(root)}:{line}: {target} {what}")
    complaints += [f"{page.relative_to(root)}: no page links it" for page in sorted(set(files) - reached)]
    return complaints, count


def main():
    root = root_of_arguments()
    files = pages(root)
    complaints, count = wrong_links(root, files)
    if not count:
        complaints.append(f"{root}: no links")
    end(complaints, f"{count} links in {len(files)} pages, {len(complaints)} wrong")


if __name__ == "__main__":
    main()
