#!/usr/bin/env python3
"""The check of the layers finds what it is there for."""

import unittest

from check_layers import FOR_FORMATS, ROOMS, check

TABLE = {"base": [], "mesh/core": ["base"], "store": ["base"], "worker": ["mesh/core", "base"]}


class CheckLayers(unittest.TestCase):
    def test_accepts_includes_within_a_room_and_of_the_rooms_that_are_named(self):
        files = {"worker/a.h": '#include "worker/b.h"\n#include "mesh/core/c.h"\n#include "base/d.h"\n',
                 "worker/b.h": "#include <vector>\n", "mesh/core/c.h": '#include "base/d.h"\n', "base/d.h": ""}
        self.assertEqual(check(files, TABLE), [])

    def test_refuses_an_include_through_a_room(self):
        table = {"base": [], "store": ["base"], "worker": ["store"]}
        files = {"worker/a.h": '#include "store/b.h"\n#include "base/c.h"\n', "store/b.h": '#include "base/c.h"\n'}
        self.assertEqual(len(check(files, table)), 1)
        self.assertIn("may not include", check(files, table)[0])

    def test_refuses_a_room_that_is_named_and_not_used(self):
        files = {"worker/a.h": '#include "mesh/core/c.h"\n', "mesh/core/c.h": '#include "base/d.h"\n'}
        self.assertEqual(check(files, TABLE), ["worker includes nothing of base, which the table lets it"])

    def test_refuses_an_include_upward(self):
        self.assertIn("may not include", check({"base/a.h": '#include "store/b.h"\n'}, TABLE)[0])

    def test_refuses_an_include_of_a_neighbour(self):
        self.assertIn("may not include", check({"mesh/core/a.cpp": '  #  include "store/b.h"\n'}, TABLE)[0])

    def test_refuses_headers_in_a_circle(self):
        files = {"base/a.h": '#include "base/b.h"\n', "base/b.h": '#include "base/a.h"\n'}
        self.assertIn("circle", check(files, TABLE)[0])

    def test_refuses_a_circle_of_the_table(self):
        self.assertIn("circle", check({}, {"a": ["b"], "b": ["a"]})[0])

    def test_refuses_an_unknown_room(self):
        self.assertIn("no room", check({"mesh/kitchen/a.h": ""}, TABLE)[0])
        self.assertIn("no room", check({"worker/a.h": '#include "kitchen/b.h"\n'}, TABLE)[0])

    def test_refuses_links_that_differ_from_the_table(self):
        cmake = "add_room(base)\nadd_room(mesh/core base)\nadd_room(store base mesh/core)\n" \
                "add_room(worker mesh/core base)\n"
        self.assertIn("add_room(store)", check({}, TABLE, cmake)[0])

    def test_a_folder_of_formats_needs_only_its_line(self):
        table = {room: [] for room in FOR_FORMATS} | {"store": []}
        cmake = "".join(f"add_room({room})\n" for room in table) + "add_format(su2 store)\n"
        files = {"mesh/formats/su2/a.h": '#include "mesh/formats/list/b.h"\n#include "store/c.h"\n'}
        self.assertEqual(check(files, table, cmake), [])
        for other in ("worker/a.h", "mesh/formats/stl/a.h"):
            self.assertTrue(check({"mesh/formats/su2/a.h": f'#include "{other}"\n'} | {other: ""}, table, cmake))
        unused = {"mesh/formats/su2/a.h": ""}
        self.assertEqual(check(unused, table, cmake),
                         ["mesh/formats/su2 includes nothing of store, which the table lets it"])

    def test_refuses_a_line_of_formats_with_a_room_that_is_none(self):
        self.assertIn("kitchen", check({}, TABLE, "add_format(su2 kitchen)\n")[0])

    def test_tests_see_every_room(self):
        self.assertEqual(check({"tests/base/a_test.cpp": '#include "worker/a.h"\n'}, TABLE), [])

    def test_coordinator_and_worker_do_not_see_each_other(self):
        for here, there in (("coordinator", "worker"), ("worker", "coordinator"),
                            ("coordinator", "mesh/geometry"), ("mesh/core", "proto"),
                            ("mesh/shapes", "mesh/formats"), ("mesh/volume", "mesh/shapes"), ("mesh/recovery", "mesh/filling"),
                            ("coordinator/decisions", "coordinator/views"), ("coordinator/views", "coordinator")):
            self.assertTrue(check({f"{here}/a.h": f'#include "{there}/b.h"\n'}, ROOMS))


if __name__ == "__main__":
    unittest.main()
