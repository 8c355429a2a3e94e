#include "cli/about_command_line.h"

#include <gmock/gmock.h>

#include "tests/cli/parsed.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

TEST(AboutCommandLine, takes_a_page_or_a_folder_for_all) {
  EXPECT_EQ(parsed_as<ManCommand>({"man"}).command, "");
  EXPECT_EQ(parsed_as<ManCommand>({"man"}).output, "");
  EXPECT_EQ(parsed_as<ManCommand>({"man", "run"}).command, "run");
  EXPECT_EQ(parsed_as<ManCommand>({"man", "-o", "d"}).output, "d");
  EXPECT_EQ(refusal_of({"man", "run", "-o", "d"}), "COMMAND excludes --output");
}

TEST(AboutCommandLine, takes_a_shell) {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    EXPECT_EQ(parsed_as<CompletionCommand>({"completion", shell}).shell, shell);
  }
  EXPECT_THAT(refusal_of({"completion", "csh"}), HasSubstr("csh not in {bash,"));
  EXPECT_EQ(refusal_of({"completion"}), "SHELL is required");
}

TEST(AboutCommandLine, takes_a_form_of_the_version) {
  EXPECT_FALSE(parsed_as<VersionCommand>({"version"}).json);
  EXPECT_TRUE(parsed_as<VersionCommand>({"version", "--json"}).json);
}

}  // namespace
}  // namespace tetfarm
