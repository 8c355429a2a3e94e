#include "cli/findings.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace tetfarm {
namespace {

const Findings three_of_them = {
    {"memory", Verdict::ok, "8.0 GB, 6.0 GB of it available", ""},
    {"open files", Verdict::warning, "a process may have 1024 open", "raise the limit"},
    {"disk", Verdict::problem, "/farm\n: full", "make room"}};

TEST(Findings, of_people_have_a_line_each_and_what_to_do_below_it) {
  EXPECT_EQ(findings_text(three_of_them),
            "ok       memory        8.0 GB, 6.0 GB of it available\n"
            "warning  open files    a process may have 1024 open\n"
            "                       raise the limit\n"
            "problem  disk          /farm\\n: full\n"
            "                       make room\n"
            "1 problem, 1 warning\n");
  EXPECT_EQ(findings_text({}), "0 problems, 0 warnings\n");
}

TEST(Findings, of_programs_are_an_object_each_and_one_for_all) {
  std::istringstream lines(findings_json(three_of_them));
  std::vector<nlohmann::json> objects;
  for (std::string line; std::getline(lines, line);) objects.push_back(nlohmann::json::parse(line));
  ASSERT_EQ(objects.size(), 4U);
  EXPECT_EQ(objects[1], (nlohmann::json{{"type", "finding"},
                                        {"check", "open files"},
                                        {"verdict", "warning"},
                                        {"found", "a process may have 1024 open"},
                                        {"remedy", "raise the limit"}}));
  EXPECT_EQ(objects[3],
            (nlohmann::json{{"type", "doctor"}, {"ok", 1}, {"warnings", 1}, {"problems", 1}}));
}

TEST(Findings, are_the_same_after_they_were_packed) {
  EXPECT_EQ(unpacked_findings(packed_findings(three_of_them)), three_of_them);
  EXPECT_EQ(unpacked_findings(packed_findings({})), Findings());
  EXPECT_EQ(unpacked_findings(packed_findings(three_of_them).substr(0, 50)), Findings());
}

}  // namespace
}  // namespace tetfarm
