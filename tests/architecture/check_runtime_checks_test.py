#!/usr/bin/env python3
"""The count of run-time checks finds what it is there for."""

import unittest

from check_runtime_checks import check, count


class CheckRuntimeChecks(unittest.TestCase):
    def test_refuses_a_room_without_a_check_however_short(self):
        self.assertIn("b: 0 run-time checks in 40 lines", check({"a": (1000, 100), "b": (40, 0)}, {})[0])

    def test_refuses_a_room_that_grew_without_checks(self):
        self.assertEqual(check({"a": (1000, 100), "b": (1000, 2)}, {}), [])
        self.assertIn("b: 2 run-time checks in 1001 lines", check({"a": (1000, 100), "b": (1001, 2)}, {})[0])

    def test_a_room_of_the_list_loses_no_check_and_leaves_it_with_enough(self):
        few = {"b": 1}
        self.assertEqual(check({"a": (1000, 100), "b": (1000, 1)}, few), [])
        self.assertIn("it had 1", check({"a": (1000, 100), "b": (1000, 0)}, few)[0])
        self.assertIn("take it out", check({"a": (1000, 100), "b": (1000, 2)}, few)[0])

    def test_refuses_too_few_in_all_rooms_together(self):
        few = {"a": 1, "b": 1}
        self.assertEqual(check({"a": (1000, 1), "b": (1500, 1), "c": (500, 1)}, few), [])
        self.assertIn("all rooms: 3 run-time checks in 3001 lines",
                      check({"a": (1000, 1), "b": (1501, 1), "c": (500, 1)}, few)[0])

    def test_counts_neither_comments_nor_texts(self):
        self.assertEqual(count('// TF_CHECK(a);\n/* TF_CHECK(\nb); */ const char* c = "TF_CHECK(d)";'), 0)
        self.assertEqual(count("TF_CHECK(a);  // TF_CHECK(b)\nif (c) TF_CHECK (d);\nNOT_TF_CHECK(e);"), 2)


if __name__ == "__main__":
    unittest.main()
