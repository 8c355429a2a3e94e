#!/usr/bin/env python3
"""Tutorials are read as their readers read them, and what is wrong in them is found."""

import unittest

from tutorial import blocks_of, brought_up_to_date, first_difference

PAGE = """# A page
```sh
one
```
```text
1 tets, 0.3 s
```
<!-- run where there is checkMesh -->
```sh
two
```
```toml
text = "that is shown"
```
<!-- not run: it takes a day -->
```sh
three
```
"""


class Blocks(unittest.TestCase):
    def test_are_commands_with_what_they_print(self):
        first, second, third = blocks_of(PAGE)
        self.assertEqual((first.commands, first.line, first.said), ("one\n", 3, "1 tets, 0.3 s\n"))
        self.assertEqual(PAGE[slice(*first.place)], first.said)
        self.assertEqual((second.commands, second.wants, second.said), ("two\n", "checkMesh", ""))
        self.assertEqual([block.never for block in (first, second, third)], [False, False, True])


class Differences(unittest.TestCase):
    def test_are_none_where_the_lines_are_the_same_but_for_ellipses(self):
        self.assertEqual(first_difference("a\n", "a\n"), "")
        self.assertEqual(first_difference("5 tets, … s\n…\nend\n", "5 tets, 0.31 s\nb\nc\nend\n"), "")
        self.assertEqual(first_difference("…\nend\n", "end\n"), "")

    def test_are_other_numbers_and_other_lines(self):
        self.assertEqual(first_difference("…\n5 tets\n", "b\n6 tets\n"), "does not print `5 tets`")
        self.assertNotEqual(first_difference("a\n", "a\nb\n"), "")
        self.assertNotEqual(first_difference("a\nb\n", "b\na\n"), "")
        self.assertNotEqual(first_difference("1.5\n", "1x5\n"), "")


class BroughtUpToDate(unittest.TestCase):
    def test_are_the_numbers_and_nothing_else(self):
        self.assertEqual(brought_up_to_date("…\n5,123 tets, … s\nend\n", "start\n1,234,567 tets, 0.5 s\nEND\n"),
                         "…\n1,234,567 tets, … s\nend\n")

    def test_keep_their_order(self):
        self.assertEqual(brought_up_to_date("1,4\n2,5\n", "1,6\n2,7\n"), "1,6\n2,7\n")


if __name__ == "__main__":
    unittest.main()
