#include "cli/bash_completion.h"

#include <gmock/gmock.h>

#include "cli/command_line.h"
#include "tests/cli/other_programs.h"

namespace tetfarm {
namespace {

using test::TemporaryFolder;
using test::write_contents;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

/// The words of a line as bash has divided it, to be completed at its end; how `complete` would go
/// on with files and folders is printed too.
std::string completed_in_bash(const std::string& words) {
  return "COMP_WORDS=(tetfarm " + words + "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _tetfarm\n" +
         "[ ${#COMPREPLY[@]} = 0 ] || printf '%s\\n' \"${COMPREPLY[@]}\"\n";
}

std::vector<std::string> printed_by_bash(const std::string& commands) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "tetfarm", bash_completion(declared_commands()));
  write_contents(folder.path() / "asked",
                 "set -eu\nsource ./tetfarm\ncompopt() { echo \"$2 names\"; }\n" + commands);
  return lines_of(printed_by({"bash", "--norc", "asked"}, folder.path()));
}

/// What bash offers at the end of the line.
std::vector<std::string> offered_by_bash(const std::string& words) {
  return printed_by_bash(completed_in_bash(words));
}

TEST(BashCompletion, of_commands) {
  EXPECT_THAT(offered_by_bash("ru"), ElementsAre("run"));
  EXPECT_THAT(offered_by_bash("re"), UnorderedElementsAre("render", "report", "retry", "restore"));
  EXPECT_THAT(offered_by_bash("ta"), ElementsAre("tasks")) << "task is not for people";
  EXPECT_THAT(offered_by_bash("keys ''"),
              UnorderedElementsAre("new", "authorize", "revoke", "list"));
  EXPECT_THAT(offered_by_bash("keys r"), ElementsAre("revoke"));
  EXPECT_THAT(offered_by_bash("man co"),
              UnorderedElementsAre("convert", "coordinator", "completion"));
}

TEST(BashCompletion, of_options) {
  EXPECT_THAT(offered_by_bash("run --for"), UnorderedElementsAre("--force", "--format"));
  EXPECT_THAT(offered_by_bash("run wing.stl --out"),
              UnorderedElementsAre("--output", "--outer", "--outer-size"));
  EXPECT_THAT(offered_by_bash("--v"), ElementsAre("--version"));
  EXPECT_THAT(offered_by_bash("keys list --j"), ElementsAre("--json"));
  EXPECT_THAT(offered_by_bash("drain --all ''"), IsEmpty()) << "the name of a worker";
  EXPECT_THAT(offered_by_bash("spacing ''"), Contains("--y-plus")) << "there are no arguments";
}

TEST(BashCompletion, of_values) {
  EXPECT_THAT(offered_by_bash("run --progress ''"), ElementsAre("text", "plain", "none", "json"));
  EXPECT_THAT(offered_by_bash("run --progress = pl"), ElementsAre("plain"));
  EXPECT_THAT(offered_by_bash("run --progress ="), ElementsAre("text", "plain", "none", "json"));
  EXPECT_THAT(offered_by_bash("run --outer s"), ElementsAre("sphere"));
  EXPECT_THAT(offered_by_bash("shape du"), ElementsAre("duct"));
  EXPECT_THAT(offered_by_bash("pool --max 3 ss"), ElementsAre("ssh"));
  EXPECT_THAT(offered_by_bash("keys authorize a.pub --role v"), ElementsAre("viewer"));
  EXPECT_THAT(offered_by_bash("tasks --kind me"), ElementsAre("mesh"));
  EXPECT_THAT(offered_by_bash("run --size ''"), IsEmpty());
}

TEST(BashCompletion, of_lists) {
  EXPECT_THAT(offered_by_bash("run --format vt"), ElementsAre("vtkhdf"));
  EXPECT_THAT(offered_by_bash("run --format su2,vt"), ElementsAre("su2,vtkhdf"));
  EXPECT_THAT(offered_by_bash("run --format su2,x"), IsEmpty());
}

TEST(BashCompletion, of_files_and_folders) {
  EXPECT_THAT(offered_by_bash("run ''"), ElementsAre("default names"));
  EXPECT_THAT(offered_by_bash("run wi"), ElementsAre("default names"));
  EXPECT_THAT(offered_by_bash("run wing.stl -o ''"), ElementsAre("dirnames names"));
  EXPECT_THAT(offered_by_bash("run -o out ''"), ElementsAre("default names"));
  EXPECT_THAT(offered_by_bash("plane a.xy b.xy ''"), ElementsAre("default names"));
  EXPECT_THAT(offered_by_bash("restore ''"), ElementsAre("default names"));
  EXPECT_THAT(offered_by_bash("restore farm.backup ''"), ElementsAre("dirnames names"));
  EXPECT_THAT(offered_by_bash("restore farm.backup /farm --da"), ElementsAre("--database"));
}

// bash divides words at : and =.
TEST(BashCompletion, after_values_that_bash_divides) {
  EXPECT_THAT(offered_by_bash("status --connect tcp : //head : 5555 --js"), ElementsAre("--json"));
  EXPECT_THAT(offered_by_bash("status --connect tcp : //he"), IsEmpty());
  EXPECT_THAT(offered_by_bash("status --connect tcp :"), IsEmpty());
  EXPECT_THAT(offered_by_bash("run --outer = box : 3 --for"),
              UnorderedElementsAre("--force", "--format"));
  EXPECT_THAT(offered_by_bash("adapt a.mesh --curve wing = naca"), IsEmpty());
  EXPECT_THAT(offered_by_bash("restore --database = d ''"), ElementsAre("default names"));
}

TEST(BashCompletion, knows_every_option_of_every_command) {
  const std::vector<DeclaredCommand> commands = with_all_below(declared_commands());
  std::string asked;
  for (const DeclaredCommand& command : commands) {
    asked += "echo '" + command.name + ":'\n" + completed_in_bash(command.name + " -");
  }
  std::vector<std::string> expected;
  for (const DeclaredCommand& command : commands) {
    expected.push_back(command.name + ":");
    for (const DeclaredOption& option : command.options) {
      expected.insert(expected.end(), option.names.begin(), option.names.end());
    }
  }
  EXPECT_EQ(printed_by_bash(asked), expected);
}

TEST(BashCompletion, offers_after_every_option_what_its_value_may_be) {
  std::string asked;
  std::vector<std::string> expected;
  for (const DeclaredCommand& command : with_all_below(declared_commands())) {
    for (const DeclaredOption& option : command.options) {
      if (option.value.empty()) continue;
      asked += completed_in_bash(command.name + " " + option.names.front() + " ''");
      expected.insert(expected.end(), option.choices.begin(), option.choices.end());
      if (!option.choices.empty()) continue;
      if (option.completion == ValueCompletion::file) expected.emplace_back("default names");
      if (option.completion == ValueCompletion::folder) expected.emplace_back("dirnames names");
    }
  }
  EXPECT_EQ(printed_by_bash(asked), expected);
}

}  // namespace
}  // namespace tetfarm
