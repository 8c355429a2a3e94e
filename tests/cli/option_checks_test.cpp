#include "cli/option_checks.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tetfarm {
namespace {

/// What is wrong with a text; "": nothing.
std::string wrong(const CLI::Validator& validator, std::string text) { return validator(text); }

/// Those that are taken, and those that are refused as "must be WANTED, not TEXT".
void expect(const CLI::Validator& validator, const std::string& wanted,
            const std::vector<std::string>& taken, const std::vector<std::string>& refused) {
  for (const std::string& text : taken) EXPECT_EQ(wrong(validator, text), "") << text;
  for (const std::string& text : refused) {
    EXPECT_EQ(wrong(validator, text), "must be " + wanted + ", not " + text);
  }
}

TEST(OptionChecks, a_positive_number_is_finite_and_above_0) {
  expect(positive_number(), "a number above 0", {"1", "+1", "1e-300", "0.5", ".5", "5."},
         {"0", "-0", "-1", "1x", "x", "inf", "-inf", "nan", "1e999", " 1", "1 ", "++1", "0x10"});
  EXPECT_EQ(wrong(positive_number(), ""), "must be a number above 0, not \"\"");
}

TEST(OptionChecks, a_number_that_is_not_negative_may_be_0) {
  expect(not_negative_number(), "a number, 0 or above", {"0", "+0", "1e-9", "7"},
         {"-1", "-1e-9", "x", "inf", "nan"});
}

TEST(OptionChecks, a_number_between_two_may_be_either) {
  expect(number_between(0.1, 3600), "a number from 0.1 to 3600", {"0.1", "3600", "17.5"},
         {"0.09", "3600.1", "-1", "x", "nan"});
}

TEST(OptionChecks, a_whole_number_has_no_point_and_keeps_to_its_ends) {
  expect(whole_number(1, 4096), "a whole number from 1 to 4096", {"1", "4096", "+7"},
         {"0", "4097", "8.5", "1e3", "x", "99999999999999999999", "-1"});
}

TEST(OptionChecks, a_counting_number_is_whole_and_above_0) {
  expect(counting_number(), "a whole number above 0", {"1", "9223372036854775807"},
         {"0", "-1", "1.0", "x", "9223372036854775808"});
}

TEST(OptionChecks, a_number_of_parts_may_be_left_to_the_mesh) {
  const CLI::Validator parts = number_of_parts(64);
  expect(parts, "as-meshed or a whole number from 1 to 64", {"as-meshed", "1", "64"},
         {"0", "65", "-1", "as_meshed", "2.5"});
  std::string text = "as-meshed";
  EXPECT_EQ(parts(text), "");
  EXPECT_EQ(text, "0");
  text = "12";
  EXPECT_EQ(parts(text), "");
  EXPECT_EQ(text, "12");
}

TEST(OptionChecks, no_path_of_any_command_may_be_empty) {
  CLI::App app;
  std::string input;
  std::string output;
  std::string name;
  CLI::App& sub = *app.add_subcommand("a");
  CLI::App& below = *sub.add_subcommand("b");
  below.add_option("INPUT", input);
  below.add_option("-o,--output", output);
  below.add_option("--name", name);
  refuse_empty_paths(app);
  const auto complaint_of = [&app](std::vector<const char*> words) -> std::string {
    words.insert(words.begin(), {"tetfarm", "a", "b"});
    try {
      app.parse(static_cast<int>(words.size()), words.data());
      return "";
    } catch (const CLI::ParseError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(complaint_of({"--name", ""}), "");
  EXPECT_EQ(complaint_of({"x", "-o", "y"}), "");
  EXPECT_EQ(complaint_of({"-o", ""}), "--output: must not be empty");
  EXPECT_EQ(complaint_of({"-o="}), "--output: must not be empty");
  EXPECT_EQ(complaint_of({""}), "INPUT: must not be empty");
}

TEST(OptionChecks, an_output_after_an_equals_sign_is_the_output_without_it) {
  for (const std::vector<const char*>& words : {std::vector<const char*>{"x", "-o", "out"},
                                                {"x", "-o=out"},
                                                {"x", "-oout"},
                                                {"x", "--output=out"},
                                                {"x", "--output", "out"}}) {
    CLI::App app;
    std::string output;
    app.add_option("-o,--output", output, "");
    refuse_empty_paths(app);
    app.parse(static_cast<int>(words.size()), words.data());
    EXPECT_EQ(output, "out") << words[1];
  }
}

}  // namespace
}  // namespace tetfarm
