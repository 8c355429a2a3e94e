#!/usr/bin/env python3
"""What lint.py makes of what clang-tidy says, and of what is compiled."""

import os
import tempfile
import unittest

import lint

OUTPUT = """/r/base/a.h:3:5: error: name is bad [readability-identifier-naming,-warnings-as-errors]
  int Bad;
      ^
/r/base/a.h:9:1: warning: moved [bugprone-use-after-move]
"""


class Lint(unittest.TestCase):
    def test_a_finding_is_its_line_and_those_below(self):
        findings = lint.findings_of(OUTPUT)
        self.assertEqual(len(findings), 2)
        self.assertEqual(len(list(findings.values())[0]), 3)

    def test_a_finding_that_two_batches_have_is_one(self):
        findings = lint.findings_of(OUTPUT)
        findings.update(lint.findings_of(OUTPUT))
        self.assertEqual(len(findings), 2)

    def test_a_batch_stands_for_the_files_that_it_includes(self):
        text = '#include "/r/base/a.cpp"\n\n#include "/r/base/b.cpp"\n'
        self.assertEqual(lint.sources_of("/r/build/Unity/unity_0_cxx.cxx", text), ["/r/base/a.cpp", "/r/base/b.cpp"])
        self.assertEqual(lint.sources_of("/r/base/c.cpp", "int x;"), ["/r/base/c.cpp"])

    def test_a_file_that_nothing_compiles_is_missed(self):
        with tempfile.TemporaryDirectory() as root:
            os.makedirs(os.path.join(root, "base"))
            for name in ("a.cpp", "b.cpp"):
                with open(os.path.join(root, "base", name), "w", encoding="utf-8"):
                    pass
            self.assertEqual(lint.missing_sources({os.path.join(root, "base", "a.cpp")}, root), ["base/b.cpp"])

    def test_a_header_that_lacks_an_include_does_not_compile_alone(self):
        with tempfile.TemporaryDirectory() as root:
            os.makedirs(os.path.join(root, "base"))
            for name, text in (("bad.h", "std::string name();\n"), ("good.h", "#include <string>\nstd::string name();\n"),
                               ("of_a_cpp.h", ""), ("of_a_cpp.cpp", "")):
                with open(os.path.join(root, "base", name), "w", encoding="utf-8") as file:
                    file.write(text)
            headers = lint.headers_alone(root)
            self.assertEqual(headers, ["base/bad.h", "base/good.h"])
            self.assertIn("does not compile alone", lint.compile_alone("base/bad.h", [], root))
            self.assertEqual(lint.compile_alone("base/good.h", [], root), "")


if __name__ == "__main__":
    unittest.main()
