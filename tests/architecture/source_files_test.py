#!/usr/bin/env python3
"""The checks read all sources, and nothing else."""

import pathlib
import tempfile
import unittest

from source_files import OUTSIDE, count_in_code, texts


class SourceFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def add(self, *names):
        for name in names:
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(name, encoding="utf-8")

    def test_are_those_of_all_folders_that_no_build_made(self):
        self.add("a/a.h", "tests/b/b.cpp", "a/a.py", "build/dev/c.h", "out/d.cpp", ".git/e.h", "a/build/f.h")
        self.assertEqual(texts(self.root), {name: name for name in ("a/a.h", "a/build/f.h", "tests/b/b.cpp")})

    def test_without_folders_are_those_of_the_rest(self):
        self.add("a/a.h", "a/tests/b.h", "tests/c.h", "bench/d.cpp", "examples/library/e.cpp")
        self.assertEqual(list(texts(self.root, without=OUTSIDE)), ["a/a.h", "a/tests/b.h"])

    def test_that_are_not_there_end_the_check(self):
        with self.assertRaises(SystemExit):
            texts(self.root)

    def test_counts_neither_comments_nor_texts(self):
        self.assertEqual(count_in_code(r"\ba\(", '// a(\n/* a(\na( */ const char* b = "a(\\" a(";'), 0)
        self.assertEqual(count_in_code(r"\ba\(", "a();  // a(\nba(a(1));"), 2)


if __name__ == "__main__":
    unittest.main()
