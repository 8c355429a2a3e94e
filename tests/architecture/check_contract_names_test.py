#!/usr/bin/env python3
"""The check of the names of fields of contracts finds what it is there for."""

import pathlib
import re
import unittest

import check_contract_names
from source_files import texts

ROOT = pathlib.Path(__file__).resolve().parents[2]


class CheckContractNames(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sources = texts(ROOT)

    def setUp(self):
        self.files = dict(self.sources)
        self.protocol = (ROOT / check_contract_names.PROTOCOL).read_text(encoding="utf-8")

    def complaints(self):
        return "\n".join(check_contract_names.check(self.files, self.protocol))

    def test_knows_both_contracts_of_every_kind_and_all_ways_of_a_field(self):
        contracts = check_contract_names.fields_of(self.files)
        self.assertEqual({side for _, side in contracts}, {"Given", "Made"})
        kinds = re.findall(r"^  KIND\((\w+)\)", self.files["tasks/task_kind.h"], re.MULTILINE)
        self.assertGreaterEqual(len(kinds), 10)
        self.assertEqual({kind for kind, _ in contracts}, set(kinds))
        self.assertEqual(len(contracts), 2 * len(kinds))
        self.assertEqual(contracts["number", "Given"],
                         {"surface": "file", "layer_table": "file", "dropped": "file", "core:": "files", "elements:": "files",
                          "table": "text", "order": "text"})
        self.assertIn("across_cuts", contracts["inspect", "Made"])
        self.assertIn("reason", contracts["decompose", "Made"])

    def test_refuses_a_field_by_its_name_in_the_rules_of_the_graph(self):
        self.files["coordinator/decisions/task_graph.cpp"] += 'auto work = task.parameters.find("work");\n'
        self.assertIn('coordinator/decisions/task_graph.cpp: names the field "work"', self.complaints())

    def test_refuses_files_of_leaves_by_their_prefix_in_a_task(self):
        self.files["worker/number_task.cpp"] += 'io.read("core:" + std::to_string(heap));\n'
        self.assertIn('worker/number_task.cpp: names the field "core:"', self.complaints())

    def test_refuses_a_number_of_the_contract_beside_it_but_no_figure_that_is_called_like_another_kinds(self):
        self.files["worker/mesh_task.cpp"] += 'io.number("tets", 3);\nio.number("needles", 3);\n'
        self.assertIn('worker/mesh_task.cpp: names the field "tets"', self.complaints())
        self.assertNotIn("needles", self.complaints())

    def test_passes_comments_and_longer_texts(self):
        self.files["worker/mesh_task.cpp"] += '// "work"\nthrow Error("no work: mesh");\n'
        self.assertEqual("", self.complaints())

    def test_refuses_exceptions_that_are_none_any_more(self):
        self.files["worker/job_forecast.cpp"] = ""
        del self.files["coordinator/surface_roots.cpp"]
        self.assertIn('worker/job_forecast.cpp: has no "spacing" any more', self.complaints())
        self.assertIn("coordinator/surface_roots.cpp: is no source any more", self.complaints())

    def test_refuses_a_field_that_the_table_of_the_protocol_leaves_out(self):
        self.protocol = self.protocol.replace("waits:HEAP or had_turn:HEAP", "had_turn:HEAP", 1)
        self.assertIn("the row of cosmetic leaves out waits:", self.complaints())


if __name__ == "__main__":
    unittest.main()
