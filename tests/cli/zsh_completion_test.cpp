#include "cli/zsh_completion.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "cli/command_line.h"
#include "tests/cli/other_programs.h"

namespace tetfarm {
namespace {

using test::TemporaryFolder;
using test::write_contents;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// What the function of a command tells zsh's own functions, a line for each of their words.
std::vector<std::string> told_to_zsh(const std::string& functions) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "_tetfarm", zsh_completion(declared_commands()));
  write_contents(folder.path() / "asked",
                 "compdef() { }\nsource ./_tetfarm\n"
                 "_arguments() { print -rl -- \"$@\"; state=command; return 1 }\n"
                 "_describe() { print -rl -- $commands }\n" +
                     functions + "\n:\n");
  return lines_of(printed_by({"zsh", "-f", "asked"}, folder.path()));
}

TEST(ZshCompletion, is_what_zsh_can_read) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "_tetfarm", zsh_completion(declared_commands()));
  printed_by({"zsh", "-f", "-n", "_tetfarm"}, folder.path());
}

TEST(ZshCompletion, tells_values_of_options) {
  const std::vector<std::string> run = told_to_zsh("_tetfarm_run");
  EXPECT_THAT(run, Contains("(--progress)--progress=[text\\: a bar on a terminal, otherwise "
                            "plain]:text|plain|none|json:(text plain none json)"));
  EXPECT_THAT(run, Contains(StartsWith("(-o --output)-o+[Output folder]:DIR:_files -/")));
  EXPECT_THAT(run, Contains(StartsWith("(--force)--force[Start however many")));
  EXPECT_THAT(run, Contains(HasSubstr(":F,...:_sequence compadd - vtkhdf ")));
  EXPECT_THAT(run, Contains(StartsWith("*--layers=[Boundary layers on patches, such as 'wing_*,")))
      << "which may be repeated, with quotes in its text";
  EXPECT_THAT(run, Contains(HasSubstr(":box\\[\\:FACTOR\\]|sphere\\[\\:FACTOR\\]:(box sphere)")));
}

TEST(ZshCompletion, tells_arguments) {
  EXPECT_THAT(told_to_zsh("_tetfarm_run"), Contains(":INPUT:_files"));
  EXPECT_THAT(told_to_zsh("_tetfarm_plane"), Contains("*:BOUNDARY:_files"));
  EXPECT_THAT(told_to_zsh("_tetfarm_status"), Contains("::JOB: ")) << "which is not required";
  EXPECT_THAT(told_to_zsh("_tetfarm_gc"), Contains(":STORE:_files -/"));
  EXPECT_THAT(told_to_zsh("_tetfarm_completion"), Contains(":SHELL:(bash zsh fish)"));
}

TEST(ZshCompletion, tells_commands_and_what_they_do) {
  EXPECT_THAT(told_to_zsh("_tetfarm"), Contains("run:Mesh a surface with worker processes on this "
                                                "machine"));
  EXPECT_THAT(told_to_zsh("_tetfarm_keys"), Contains("list:List the authorised keys"));
}

TEST(ZshCompletion, knows_every_option_of_every_command) {
  for (const DeclaredCommand& command : with_all_below(declared_commands())) {
    std::string function = command.name.empty() ? "_tetfarm" : "_tetfarm_" + command.name;
    std::replace(function.begin(), function.end(), ' ', '_');
    const std::vector<std::string> told = told_to_zsh(function);
    for (const DeclaredOption& option : command.options) {
      for (const std::string& name : option.names) {
        const std::string end = option.value.empty() ? "[" : name.starts_with("--") ? "=[" : "+[";
        EXPECT_THAT(told, Contains(HasSubstr((option.may_repeat ? "*" : ")") + name + end)))
            << command.name;
      }
    }
  }
}

}  // namespace
}  // namespace tetfarm
