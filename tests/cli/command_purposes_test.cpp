#include "cli/command_purposes.h"

#include <gmock/gmock.h>

#include <iterator>
#include <set>
#include <sstream>

#include "cli/command_line.h"
#include "tests/cli/other_programs.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(CommandPurposes, every_command_has_one_and_is_listed_once) {
  const DeclaredCommand program = declared_commands();
  const std::string text = commands_by_purpose(program);
  std::string names;
  for (const std::string& line : lines_of(text)) names += line.substr(22);
  std::istringstream words(names);
  const std::multiset<std::string> listed{std::istream_iterator<std::string>(words), {}};
  EXPECT_EQ(listed.size(), program.commands.size());
  for (const DeclaredCommand& command : program.commands) {
    EXPECT_THAT(text, HasSubstr(command.purpose));
    EXPECT_EQ(listed.count(command.name), 1U) << command.name;
  }
  for (const std::string& line : lines_of(text)) EXPECT_LE(line.size(), 80U) << line;
}

TEST(CommandPurposes, are_shown_where_no_command_is_given) {
  const char* words[] = {"tetfarm"};
  const Said said = said_by([&] {
    parse_command_line(1, words);
    return ExitCode::ok;
  });
  EXPECT_EQ(said.error, "no command given");
  EXPECT_EQ(said.out, "");
  EXPECT_THAT(said.err, StartsWith("  Mesh a surface       run check plan"));
  EXPECT_THAT(said.err, HasSubstr("\n  Watch a farm         top dashboard jobs"));
}

}  // namespace
}  // namespace tetfarm
