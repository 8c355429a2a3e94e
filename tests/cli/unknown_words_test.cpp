#include "cli/unknown_words.h"

#include <gtest/gtest.h>

#include "base/error_with_help.h"
#include "tests/cli/parsed.h"

namespace tetfarm {
namespace {

/// What is wrong, and what to do about it.
std::pair<std::string, std::string> told(const std::vector<std::string>& words) {
  try {
    parsed(words);
  } catch (const ErrorWithHelp& error) {
    EXPECT_EQ(error.code(), ExitCode::usage);
    return {error.what(), error.help()};
  }
  return {};
}

TEST(UnknownWords, a_command_is_wanted) {
  EXPECT_EQ(told({}), std::pair(std::string("no command given"),
                                std::string("`tetfarm run wing.stl -o out` meshes a surface; "
                                            "`tetfarm --help` lists the commands")));
  EXPECT_EQ(told({"keys"}), std::pair(std::string("no command given after `keys`"),
                                      std::string("`tetfarm keys --help` lists the commands")));
}

TEST(UnknownWords, a_command_that_is_none_is_told_with_the_nearest) {
  const std::string list = "`tetfarm --help` lists the commands";
  EXPECT_EQ(told({"runn"}),
            std::pair(std::string("unknown command `runn`; did you mean `run`?"), list));
  EXPECT_EQ(told({"generate"}), std::pair(std::string("unknown command `generate`"), list));
  EXPECT_EQ(told({"keys", "lisst"}),
            std::pair(std::string("unknown command `keys lisst`; did you mean `list`?"),
                      std::string("`tetfarm keys --help` lists the commands")));
  EXPECT_EQ(told({"/"}).first, "unknown command `/`; did you mean `tetfarm run /`?")
      << "there is such a file";
  EXPECT_EQ(told({"keys", "/"}).first, "unknown command `keys /`");
}

TEST(UnknownWords, a_command_that_only_processes_call_is_not_proposed) {
  EXPECT_EQ(told({"task-hosst"}).first, "unknown command `task-hosst`");
}

TEST(UnknownWords, an_option_that_is_none_is_told_with_the_nearest_of_its_command) {
  expect_refused({
      {{"run", "a.stl", "--outter", "box"}, "unknown option `--outter`; did you mean `--outer`?"},
      {{"run", "a.stl", "--outter=box"}, "unknown option `--outter`; did you mean `--outer`?"},
      {{"run", "a.stl", "--xyzzy"}, "unknown option `--xyzzy`"},
      {{"keys", "list", "--jsn"}, "unknown option `--jsn`; did you mean `--json`?"},
      {{"gc", "s", "--grace", "5"}, "unknown option `--grace`"},
  });
}

}  // namespace
}  // namespace tetfarm
