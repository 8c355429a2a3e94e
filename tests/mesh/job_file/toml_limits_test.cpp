#include "mesh/job_file/toml_limits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "mesh/job_file/job_file.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string repeated(std::string_view text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

/// "a.a. … .a" of so many segments.
std::string dotted(std::size_t segments) { return repeated("a.", segments - 1) + "a"; }

/// What is said of the text; "" when it may be parsed.
std::string said_of(const std::string& text) {
  try {
    check_toml_limits(text, "job.toml");
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(TomlLimits, refuse_long_dotted_keys_with_their_place) {
  EXPECT_EQ(said_of(dotted(most_key_segments) + " = 1\n"), "");
  EXPECT_EQ(said_of("# a job\n" + dotted(most_key_segments + 1) + " = 1\n"),
            "job.toml:2:32: a key of more than 16 parts");
  for (const std::string& text :
       {dotted(120'000) + "=1", "[" + dotted(120'000) + "]", "[[" + dotted(120'000) + "]]",
        "a = {" + dotted(120'000) + " = 1}", "a = [{b = 1, " + dotted(120'000) + " = 1}]",
        "'a' . " + repeated("\"é.\" . ", 100'000) + "b = 1",
        "k = \"\"\"text\"\"\"\"\"\n" + dotted(120'000) + "=1",
        "x = {k = \"\"\"text\"\"\"\"\", " + dotted(120'000) + " = 1}",
        "x = {k = '''it''''', " + dotted(120'000) + " = 1}",
        "x = {k = \"\"\"text\"\"\"\", " + dotted(120'000) + " = 1}",
        "x = {k = '''it'''', " + dotted(120'000) + " = 1}",
        "x = {k = \"\\\"\", " + dotted(120'000) + " = 1}",
        "x = {k = '\\', " + dotted(120'000) + " = 1}"}) {
    EXPECT_THAT(said_of(text), HasSubstr("a key of more than 16 parts")) << text.substr(0, 40);
  }
}

TEST(TomlLimits, refuse_deep_nesting_with_its_place) {
  EXPECT_EQ(said_of("a = " + repeated("[", deepest_toml) + repeated("]", deepest_toml)), "");
  EXPECT_EQ(said_of("é = 1\na = " + repeated("[", 1000)),
            "job.toml:2:37: more than 32 nested arrays or tables");
  EXPECT_EQ(said_of("é = " + repeated("[", 33)),
            "job.toml:1:37: more than 32 nested arrays or tables")
      << "columns are letters";
  EXPECT_THAT(said_of("a = " + repeated("{b=", 500'00)), HasSubstr("more than 32"));
}

TEST(TomlLimits, refuse_more_than_a_mebibyte) {
  EXPECT_EQ(said_of(std::string(largest_job_file, '\n')), "");
  EXPECT_EQ(said_of(std::string(largest_job_file + 1, '\n')),
            "job.toml: more than 1048576 bytes, the most that a job file may have");
}

TEST(TomlLimits, let_long_texts_numbers_and_comments_be) {
  EXPECT_EQ(said_of("name = \"" + repeated("a.[{", 1000) + "\"\n"), "");
  EXPECT_EQ(said_of("name = '" + repeated("a.[{\"", 1000) + "'\n"), "");
  EXPECT_EQ(said_of("name = \"\"\"" + repeated("a.\n[{'\\\"", 1000) + "\"\"\"\n"), "");
  EXPECT_EQ(said_of("name = '''" + repeated("a.\n[{''", 1000) + "'''\n"), "");
  EXPECT_EQ(said_of("# " + repeated("a.[{\"", 1000) + "\na = 1\n"), "");
  EXPECT_EQ(said_of("at = [" + repeated("1.5, -2.5e-3, ", 20'000) + "0]\n"), "");
  EXPECT_EQ(said_of(repeated("[[source]]\nat = [0.0, 1.0, 2.0]\n", 20'000)), "");
  EXPECT_EQ(said_of(""), "");
}

TEST(TomlLimits, keep_the_parser_of_job_files_from_overflowing_its_stack) {
  for (const std::string& text :
       {dotted(120'000) + "=1\n", "[" + dotted(120'000) + "]\n", "a = " + repeated("[", 500'000)}) {
    try {
      parse_job_file(text, "/job/job.toml");
      FAIL() << "taken";
    } catch (const UsageError& error) {
      EXPECT_THAT(error.what(), StartsWith("/job/job.toml:1:"));
    }
  }
}

TEST(TomlLimits, keep_messages_short_whatever_is_wrong) {
  for (const std::string& text : {std::string(500'000, 'k') + " = 1\n",
                                  "[geometry]\nsurface = \"a.stl\"\n[domain]\nouter = \"" +
                                      std::string(500'000, 'v') + "\"\n"}) {
    try {
      parse_job_file(text, "/job/job.toml");
      FAIL() << "taken";
    } catch (const UsageError& error) {
      EXPECT_LT(std::string(error.what()).size(), 1000U);
    }
  }
}

}  // namespace
}  // namespace tetfarm
