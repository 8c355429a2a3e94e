#!/usr/bin/env python3
"""What check_own_header_first.py lets pass and what it reports."""

import unittest

from check_own_header_first import check

HEADER = {"mesh/a.h": "#pragma once\n"}


class OwnHeaderFirst(unittest.TestCase):
    def test_passes_a_header_that_comes_first(self):
        self.assertEqual(check(HEADER | {"mesh/a.cpp": '// why\n#include "mesh/a.h"\n\n#include <map>\n'}), [])

    def test_reports_a_header_that_comes_after_another(self):
        complaints = check(HEADER | {"mesh/a.cpp": '#include <map>\n\n#include "mesh/a.h"\n'})
        self.assertEqual(complaints, ["mesh/a.cpp: the first include is to be mesh/a.h"])

    def test_reports_a_header_that_its_source_leaves_out(self):
        self.assertEqual(len(check(HEADER | {"mesh/a.cpp": "int x;\n"})), 1)

    def test_asks_nothing_of_a_source_without_a_header(self):
        self.assertEqual(check({"cli/main.cpp": "#include <map>\n"}), [])


if __name__ == "__main__":
    unittest.main()
