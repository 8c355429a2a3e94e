#!/usr/bin/env python3
"""The check of definitions finds what it is there for."""

import unittest

from check_one_definition import check, definitions


def in_namespace(text):
    return "namespace tetfarm {\n" + text + "\n}  // namespace tetfarm\n"


class CheckOneDefinition(unittest.TestCase):
    def test_refuses_a_type_of_two_files(self):
        for one in ("struct View { int a; };", "class View final : public Base {};", "enum class View : int { a };"):
            files = {"a/a.h": in_namespace(one), "b/b.h": in_namespace("struct View { double b = {}; };")}
            self.assertIn("tetfarm::View is defined in a/a.h and in b/b.h", check(files)[0])

    def test_refuses_an_inline_function_of_two_files(self):
        one = in_namespace("inline int twice(int a) { return 2 * a; }")
        self.assertIn("twice(int a)", check({"a/a.h": one, "b/b.h": one})[0])

    def test_refuses_a_function_that_two_sources_define(self):
        one = in_namespace("std::vector<int> twice(const std::string& a) { if (a.empty()) { return {}; } return {1}; }")
        self.assertIn("twice(const std::string& a)", check({"a/a.cpp": one, "b/b.cpp": one})[0])

    def test_refuses_an_inline_constant_of_two_files(self):
        files = {"a/a.h": in_namespace("inline constexpr int most = 3;"),
                 "b/b.h": in_namespace("inline constexpr double most = (3 + 1) * 2;")}
        self.assertIn("tetfarm::most", check(files)[0])
        self.assertEqual(definitions(in_namespace("inline constexpr Colour grey{0.5F, 0.5F};")), ["tetfarm::grey"])

    def test_accepts_what_is_a_files_own(self):
        one = in_namespace("namespace {\nstruct View {};\nint twice() { return 2; }\n}\nstatic int half() { return 1; }")
        self.assertEqual(check({"a/a.cpp": one, "b/b.cpp": one}), [])

    def test_accepts_members_overloads_declarations_and_other_namespaces(self):
        files = {"a/a.h": in_namespace("struct View;\nint size(int a);\nstruct A { struct Row {}; int size() { return 1; } };"),
                 "b/b.h": in_namespace("struct View {};\nstruct B { struct Row {}; int size() { return 1; } };"),
                 "c/c.cpp": in_namespace("int size(int a) { return a; }\nint A::size() const { return 2; }"),
                 "d/d.cpp": in_namespace("int size(double a) { return 1; }\nint B::size() const { return 2; }"),
                 "e/e.h": "namespace other {\nstruct View {};\n}"}
        self.assertEqual(check(files), [])

    def test_words_in_comments_texts_and_directives_define_nothing(self):
        text = in_namespace('// struct View {\n/* struct View { */\n#define A struct View {\nconst char* a = "struct View {";'
                            '\nconst char* b = R"(struct View {)";\nconst int c = 1\'000;')
        self.assertEqual(definitions(text), [])


if __name__ == "__main__":
    unittest.main()
