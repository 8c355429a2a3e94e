#!/usr/bin/env python3
"""Makes a site of the Markdown of the repository, with mkdocs.

  build_site.py SOURCE OUT

OUT/source has the pages where they lie in the repository, with the pictures and files that they link, so that each link
means the same as in the repository; OUT/html is the site, which wants no server. Warnings of mkdocs are errors.
"""

import os
import pathlib
import shutil
import subprocess
import sys

import yaml

from markdown_pages import HEADING, ITEM, headings, lines_with_fences, links


# Which Debian's mkdocs 1.4 has under another name than its theme asks for, or not at all.
SCRIPTS = {"jquery-3.6.0.min.js": "/usr/share/javascript/jquery/jquery.min.js", "theme_extra.js": "theme_extra.js"}


class WrongPage(Exception):
    """A page that cannot be in the site as it is."""


def nav_for_mkdocs(nav):
    """The list of pages as mkdocs has it: README.md in place of each folder."""
    if isinstance(nav, list):
        return [{title: nav_for_mkdocs(value) for title, value in entry.items()} for entry in nav]
    return nav + "README.md" if nav.endswith("/") else nav


def pages_of(nav, source):
    """All pages: those of the list, and those of its folders."""
    if isinstance(nav, list):
        return [name for entry in nav for value in entry.values() for name in pages_of(value, source)]
    if nav.endswith("/"):
        return sorted(path.relative_to(source).as_posix() for path in (source / nav).glob("*.md"))
    return [nav]


def linked(text, name, source):
    """The text with links to folders changed to their pages, and the files and folders of the repository that it links."""
    page = source / name
    result, end, others = [], 0, []
    for start, stop, target in links(text):
        path, _, fragment = target.partition("#")
        if not path or ":" in path:
            continue
        file = pathlib.Path(os.path.normpath(page.parent / path))
        if not file.is_relative_to(source) or not file.exists():
            raise WrongPage(f"{name}: there is no {target}")
        if file.is_dir():
            path = path.rstrip("/") + "/README.md"
        result += [text[end:start], path + ("#" + fragment if fragment else "")]
        end = stop
        if file.suffix != ".md":
            others.append(file)
    return "".join([*result, text[end:]]), others


def for_mkdocs(text):
    """What GitHub reads, as Python-Markdown wants it: blank lines before lists and tables, anchors at headings."""
    anchors, result, before, in_list = headings(text), [], "", False
    for number, (line, code) in enumerate(lines_with_fences(text)):
        starts = not code and (ITEM.match(line) and not in_list or line.startswith("|") and not before.startswith("|"))
        if starts and before.strip():
            result.append("")
        if ITEM.match(line):
            in_list = True
        elif code or not line.startswith(" ") and (not before.strip() or HEADING.match(line)):
            in_list = False
        result.append(f"{line} {{#{anchors[number]}}}" if number in anchors else line)
        before = line
    return "\n".join(result) + "\n"


def listing_of(folder):
    """A page for a folder that has none: its files."""
    files = sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())
    return f"# {folder.name}\n\n" + "".join(f"- [{name}]({name})\n" for name in files if "__pycache__" not in name)


def put_in_place(names, source, out):
    """Pages and what they link, in the folder that mkdocs reads."""
    others = []
    for name in names:
        text, found = linked((source / name).read_text(encoding="utf-8"), name, source)
        others += found
        (out / name).parent.mkdir(parents=True, exist_ok=True)
        (out / name).write_text(for_mkdocs(text), encoding="utf-8")
    for path in others:
        to = out / path.relative_to(source)
        if path.is_file():
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, to)
        elif not (to / "README.md").exists():
            shutil.copytree(path, to, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))
            (to / "README.md").write_text(listing_of(path), encoding="utf-8")


def put_style(here, out):
    shutil.copyfile(here / "site.css", out / "site.css")
    (out / "js").mkdir()
    for name, path in SCRIPTS.items():
        if (here / path).exists():
            shutil.copyfile(here / path, out / "js" / name)


def lost_pages(names, source):
    """Pages of docs/ that are not in the list."""
    return sorted({path.relative_to(source).as_posix() for path in (source / "docs").rglob("*.md")} - set(names))


def main():
    source, out = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    here = source / "docs/site"
    settings = yaml.safe_load((here / "mkdocs.yml").read_text(encoding="utf-8"))
    names = pages_of(settings["nav"], source)
    settings["nav"] = nav_for_mkdocs(settings["nav"])
    if lost_pages(names, source):
        sys.exit(f"not in docs/site/mkdocs.yml: {', '.join(lost_pages(names, source))}")
    for folder in ("source", "html"):
        shutil.rmtree(out / folder, ignore_errors=True)
    try:
        put_in_place(names, source, out / "source")
    except WrongPage as wrong:
        sys.exit(str(wrong))
    put_style(here, out / "source")
    settings.update(docs_dir=str(out / "source"), site_dir=str(out / "html"))
    (out / "mkdocs.yml").write_text(yaml.safe_dump(settings, sort_keys=False), encoding="utf-8")
    sys.exit(subprocess.run(["mkdocs", "build", "--strict", "-f", out / "mkdocs.yml"], check=False).returncode)


if __name__ == "__main__":
    main()
