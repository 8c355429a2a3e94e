#!/usr/bin/env python3
"""The check of links finds what it is there for, and knows headings as GitHub does."""

import pathlib
import tempfile
import unittest

from check_links import pages, wrong_links
from markdown_pages import anchor, headings, links


class Anchors(unittest.TestCase):
    def test_are_small_letters_without_marks(self):
        self.assertEqual(anchor("VTKHDF (`.vtkhdf`), for ParaView"), "vtkhdf-vtkhdf-for-paraview")
        self.assertEqual(anchor("Where the answers *come* from"), "where-the-answers-come-from")
        self.assertEqual(anchor("y+ & [the wall](wall.md)"), "y--the-wall")

    def test_are_counted_where_headings_are_the_same(self):
        self.assertEqual(list(headings("# A\n## B\n## B\n").values()), ["a", "b", "b-1"])

    def test_are_not_made_in_code(self):
        self.assertEqual(headings("```\n# no heading\n```\n# A\n"), {3: "a"})


class Links(unittest.TestCase):
    def targets(self, text):
        return [text[start:end] for start, end, _ in links(text)]

    def test_are_found_in_texts_pictures_and_both(self):
        self.assertEqual(self.targets("[`a[1]`](a.md), ![b](b.png)\n[![c](c.png)](d.md)"),
                         ["a.md", "b.png", "c.png", "d.md"])

    def test_are_not_found_in_code(self):
        self.assertEqual(self.targets("`[a](a.md)` and\n```\n[b](b.md)\n```\n[c](c.md#d)"), ["c.md#d"])


class CheckLinks(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve() / "root"
        (self.root / "docs").mkdir(parents=True)
        (self.root / "README.md").write_text("[a](a.md) [b](docs/b.md)\n", encoding="utf-8")
        (self.root / "docs/b.md").write_text("# B\n## There is one\n", encoding="utf-8")

    def complaints_of(self, text):
        (self.root / "a.md").write_text("# A\n" + text, encoding="utf-8")
        return wrong_links(self.root, pages(self.root))[0]

    def test_accepts_files_folders_and_headings(self):
        self.assertEqual(self.complaints_of("[1](docs/b.md#there-is-one) [2](docs) [3](#a) [4](https://example.org/x)"), [])

    def test_refuses_what_leads_nowhere(self):
        self.assertEqual(self.complaints_of("\n[1](docs/c.md)"), ["a.md:3: docs/c.md leads to no file"])
        self.assertEqual(self.complaints_of("[1](docs/b.md#there-is-none)"),
                         ["a.md:2: docs/b.md#there-is-none leads to no heading"])
        self.assertEqual(self.complaints_of("![1](../other.png)"), ["a.md:2: ../other.png leads out of the repository"])

    def test_refuses_a_page_that_no_other_links(self):
        (self.root / "docs/c.md").write_text("[c](c.md)", encoding="utf-8")
        self.assertEqual(self.complaints_of(""), ["docs/c.md: no page links it"])


if __name__ == "__main__":
    unittest.main()
