#include "cli/exit_codes.h"

#include <gtest/gtest.h>

#include <string_view>

#include "tests/cli/other_programs.h"

namespace tetfarm {
namespace {

/// How many codes there are up to this one: a new one does not compile before it is here.
std::size_t place_of(ExitCode code) {
  switch (code) {
    case ExitCode::ok:
      return 0;
    case ExitCode::failed:
      return 1;
    case ExitCode::usage:
      return 2;
    case ExitCode::bad_geometry:
      return 3;
    case ExitCode::gate:
      return 4;
    case ExitCode::not_found:
      return 5;
    case ExitCode::out_of_resources:
      return 6;
    case ExitCode::stopped_at_checkpoint:
      return 7;
  }
  return 8;
}

TEST(ExitCodes, all_have_a_meaning) {
  ASSERT_EQ(exit_codes().size(), 8U);
  for (std::size_t i = 0; i < exit_codes().size(); ++i) {
    EXPECT_EQ(place_of(exit_codes()[i].code), i);
    EXPECT_NE(std::string_view(exit_codes()[i].meaning), "");
  }
}

TEST(ExitCodes, are_told_in_lines_for_a_terminal) {
  const std::string text = exit_codes_text();
  EXPECT_TRUE(text.starts_with("Exit codes: 0 done; 1 failed; 2 ")) << text;
  EXPECT_TRUE(text.ends_with("75 stopped at a checkpoint: run the same command again to continue."))
      << text;
  for (const std::string& line : lines_of(text)) EXPECT_LE(line.size(), 80U) << line;
}

}  // namespace
}  // namespace tetfarm
