#!/usr/bin/env python3
"""The check of the kinds of tasks finds what it is there for."""

import pathlib
import unittest

import check_task_kinds
from source_files import texts

ROOT = pathlib.Path(__file__).resolve().parents[2]


class CheckTaskKinds(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sources = texts(ROOT)

    def setUp(self):
        self.files = dict(self.sources)
        self.architecture = (ROOT / "ARCHITECTURE.md").read_text()
        self.kinds = check_task_kinds.kinds_of(self.files["tasks/task_kind.h"])

    def complaints(self):
        return "\n".join(check_task_kinds.check(self.files, self.architecture))

    def test_refuses_one_more_place_that_names_every_kind(self):
        self.files["cli/kinds.cpp"] = "\n".join(f"case TaskKind::{kind}:" for kind in self.kinds)
        self.assertIn("cli/kinds.cpp: names every kind", self.complaints())

    def test_refuses_one_more_place_that_names_a_kind(self):
        self.files["cli/kinds.cpp"] = "if (kind == TaskKind::order) return;"
        self.assertIn("cli/kinds.cpp: names kinds", self.complaints())

    def test_refuses_a_contract_that_names_another_kind(self):
        path = "tasks/order_contract.h"
        self.assertIn("TaskKind::order", self.files[path])
        self.files[path] = self.files[path].replace("TaskKind::order", "TaskKind::mesh", 1)
        self.assertIn(f"{path}: names kinds", self.complaints())

    def test_refuses_a_list_of_the_kinds_as_texts(self):
        self.files["report/kinds.cpp"] = ", ".join(f'"{kind}"' for kind in self.kinds)
        self.assertIn("report/kinds.cpp: a list", self.complaints())

    def test_refuses_places_that_are_none_any_more(self):
        self.files["coordinator/decisions/mesh_share.cpp"] = ""
        self.files["coordinator/decisions/job_decisions.cpp"] = ""
        self.assertIn("coordinator/decisions/mesh_share.cpp: names no kind", self.complaints())
        self.assertIn("job_decisions.cpp: does not name every kind", self.complaints())

    def test_refuses_another_number_in_the_architecture(self):
        self.architecture = self.architecture.replace(" existing files", " or more existing files")
        self.assertIn("does not say", self.complaints())


if __name__ == "__main__":
    unittest.main()
