#!/usr/bin/env python3
"""The site of the documentation is made without a warning; all its links lead somewhere, and it needs nothing from elsewhere.

  check_site.py SOURCE OUT

Ends with 77 where mkdocs is missing, unless CI is set, and with 1 when something is not as it should be.
"""

import html.parser
import os
import pathlib
import shutil
import subprocess
import sys
import urllib.parse

SKIPPED = 77
# As text, these are Markdown that was not understood.
NOT_UNDERSTOOD = ("- ", "| ", "```", "## ")
LOADED = {("script", "src"), ("link", "href"), ("img", "src"), ("source", "src")}


class Page(html.parser.HTMLParser):
    """What a page links, and the places in it that can be linked."""

    def __init__(self, text):
        super().__init__()
        self.links, self.anchors, self.texts = [], {""}, []
        self._in_paragraph = False
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self._in_paragraph = tag == "p"
        for name, value in attrs:
            if name in ("href", "src"):
                self.links.append((value, (tag, name) in LOADED))
            elif name == "id":
                self.anchors.add(value)

    def handle_data(self, data):
        if self._in_paragraph:
            self.texts.append(data)
        self._in_paragraph = False


def complaints_about(root, pages, path):
    page = pages[path]
    for target, is_loaded in page.links:
        url = urllib.parse.urlsplit(target)
        if url.scheme or url.netloc:
            if is_loaded and url.scheme != "data":
                yield f"loads {target} from elsewhere"
            continue
        file = path if not url.path else pathlib.Path(os.path.normpath(path.parent / urllib.parse.unquote(url.path)))
        if not file.is_relative_to(root) or not file.exists():
            yield f"{target} leads to no file"
        elif file in pages and urllib.parse.unquote(url.fragment) not in pages[file].anchors:
            yield f"{target} leads to no heading"
    for text in page.texts:
        if text.startswith(NOT_UNDERSTOOD):
            yield f"not understood: {text[:60]!r}"


def main():
    source, out = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    if shutil.which("mkdocs") is None:
        print("missing: mkdocs")
        sys.exit(1 if os.environ.get("CI") else SKIPPED)
    made = subprocess.run([sys.executable, source / "docs/site/build_site.py", source, out], text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if made.returncode:
        sys.exit(made.stdout)
    root = out / "html"
    # That of pages that are not there is for a server.
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in root.rglob("*.html") if path.name != "404.html"}
    complaints = [f"{path.relative_to(root)}: {what}" for path in sorted(pages)
                  for what in complaints_about(root, pages, path)]
    links = sum(len(page.links) for page in pages.values())
    if len(pages) < 60 or links < 1000:
        complaints.append("there are pages missing")
    print("\n".join([*complaints, f"{len(pages)} pages, {links} links, {len(complaints)} complaints"]))
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
