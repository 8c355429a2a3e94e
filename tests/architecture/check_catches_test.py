#!/usr/bin/env python3
"""The list of the places where exceptions are caught finds what it is there for."""

import unittest

from check_catches import check, count

PLACES = {"a task is run": {"a/run.cpp": 2}, "a request is handled": {"b/handle.cpp": 1}}


class CheckCatches(unittest.TestCase):
    def test_accepts_the_named_places(self):
        self.assertEqual(check({"a/run.cpp": 2, "b/handle.cpp": 1}, PLACES), [])

    def test_refuses_a_catch_in_another_file(self):
        self.assertIn("c/c.cpp: 1 catches, 0 are allowed", check({"a/run.cpp": 2, "b/handle.cpp": 1, "c/c.cpp": 1}, PLACES)[0])

    def test_refuses_one_more_in_a_named_file(self):
        self.assertIn("a/run.cpp: 3 catches, 2 are allowed", check({"a/run.cpp": 3, "b/handle.cpp": 1}, PLACES)[0])

    def test_refuses_a_number_that_leaves_room_for_a_new_one(self):
        self.assertIn("lower the number", check({"a/run.cpp": 2}, PLACES)[0])

    def test_counts_neither_comments_nor_texts(self):
        self.assertEqual(count('// catch (a)\n/* catch (\nb) */ const char* c = "} catch (d) {";'), 0)
        self.assertEqual(count("} catch (const Error& error) {\n} catch (...) {\ntry_catch(e);"), 2)


if __name__ == "__main__":
    unittest.main()
