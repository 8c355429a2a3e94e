#!/usr/bin/env python3
"""What lint.py makes of what clang-tidy says, and of what is compiled."""

import json
import os
import tempfile
import unittest
from unittest import mock

import lint
import lint_cache

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

    def entry_of(self, root, text, check):
        """A file to look at and its compilation, in a folder whose checks are `check` alone."""
        for name, words in (("a.cpp", text), (".clang-tidy", f"Checks: '-*,{check}'\n")):
            with open(os.path.join(root, name), "w", encoding="utf-8") as file:
                file.write(words)
        path = os.path.join(root, "a.cpp")
        entry = {"file": path, "directory": root, "command": f"/usr/bin/ccache clang++ -std=c++20 -o a.o -c {path}"}
        with open(os.path.join(root, "compile_commands.json"), "w", encoding="utf-8") as file:
            json.dump([entry], file)
        return path, entry

    def looks(self, root, text, check="misc-unused-parameters"):
        """What is told of the text, and whether clang-tidy was asked."""
        path, entry = self.entry_of(root, text, check)
        checked = lint.Lint(root, root, [entry], lint_cache.CleanResults(os.path.join(root, "lint")))
        with mock.patch.object(lint, "tidy", wraps=lint.tidy) as asked:
            findings = lint.findings_of(checked.tidy(path)[1])
        return len(findings), asked.called

    def test_what_was_clean_is_not_looked_at_again_until_it_or_the_checks_change(self):
        with tempfile.TemporaryDirectory() as root:
            self.assertEqual(self.looks(root, "int f(int a) { return a; }\n"), (0, True))
            self.assertEqual(self.looks(root, "int f(int a) { return a; }\n"), (0, False))
            self.assertEqual(self.looks(root, "int f(int a) { return a; }  // said\n"), (0, True))
            self.assertEqual(self.looks(root, "int f(int a) { return a; }\n", "modernize-use-trailing-return-type"), (1, True))

    def test_a_finding_is_told_each_time(self):
        with tempfile.TemporaryDirectory() as root:
            for _ in range(2):
                self.assertEqual(self.looks(root, "int f(int a) { return 1; }\n"), (1, True))

    def test_a_header_that_compiled_alone_and_lacks_an_include_later_is_told(self):
        with tempfile.TemporaryDirectory() as root:
            _, entry = self.entry_of(root, "", "misc-unused-parameters")
            checked = lint.Lint(root, root, [entry], lint_cache.CleanResults(os.path.join(root, "lint")))
            header = os.path.join(root, "a.h")
            for text, problem in (("#include <string>\nstd::string f();\n", ""), ("std::string f();\n", "does not compile alone")):
                with open(header, "w", encoding="utf-8") as file:
                    file.write(text)
                self.assertIn(problem, checked.compile_alone("a.h"))
            self.assertNotEqual(checked.compile_alone("a.h"), "")

    def test_results_that_nobody_asked_for_in_a_month_go(self):
        with tempfile.TemporaryDirectory() as root:
            results = lint_cache.CleanResults(root)
            for key in ("old", "new"):
                results.add(key)
            os.utime(os.path.join(root, "old"), (1, 1))
            results.forget_unused()
            self.assertEqual((results.has("old"), results.has("new")), (False, True))

    def test_a_folder_that_cannot_be_written_keeps_nothing(self):
        results = lint_cache.CleanResults("/proc/none")
        results.add("key")
        results.forget_unused()
        self.assertFalse(results.has("key"))


if __name__ == "__main__":
    unittest.main()
