#!/usr/bin/env python3
"""The count of run-time checks finds what it is there for."""

import unittest

from check_runtime_checks import check, count


class CheckRuntimeChecks(unittest.TestCase):
    def test_refuses_a_room_without_a_check_however_short(self):
        self.assertIn("b: 0 run-time checks in 40 lines", check({"a": (1000, 100), "b": (40, 0)})[0])

    def test_refuses_a_room_that_grew_without_checks(self):
        self.assertEqual(check({"a": (1000, 100), "b": (1000, 2)}), [])
        self.assertIn("b: 2 run-time checks in 1001 lines", check({"a": (1000, 100), "b": (1001, 2)})[0])

    def test_refuses_too_few_in_all_rooms_together(self):
        self.assertEqual(check({"a": (1000, 6), "b": (1000, 6)}), [])
        self.assertIn("all rooms: 11 run-time checks in 2000 lines", check({"a": (1000, 6), "b": (1000, 5)})[0])

    def test_counts_neither_comments_nor_texts(self):
        self.assertEqual(count('// TF_CHECK(a);\n/* TF_CHECK(\nb); */ const char* c = "TF_CHECK(d)";'), 0)
        self.assertEqual(count("TF_CHECK(a);  // TF_CHECK(b)\nif (c) TF_CHECK (d);\nNOT_TF_CHECK(e);"), 2)


if __name__ == "__main__":
    unittest.main()
