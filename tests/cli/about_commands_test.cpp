// man, completion and version.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "tests/cli/said.h"
#include "tests/support/program.h"

namespace tetfarm {
namespace {

using test::contents;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(AboutCommands, man_prints_a_page) {
  const Said program = said_by([] { return man_command({}); });
  EXPECT_THAT(program.out, StartsWith(".TH TETFARM 1 "));
  const Said run = said_by([] { return man_command({"run", ""}); });
  EXPECT_THAT(run.out, StartsWith(".TH TETFARM\\-RUN 1 "));
  const Said job = said_by([] { return man_command({"job", ""}); });
  EXPECT_THAT(job.out, StartsWith(".TH TETFARM\\-JOB 5 "));
}

TEST(AboutCommands, man_knows_no_page_of_what_is_no_command) {
  const Said near = said_by([] { return man_command({"wrker", ""}); });
  EXPECT_EQ(near.error, "unknown command `wrker`; did you mean `worker`?");
  EXPECT_THAT(near.help, HasSubstr("`tetfarm --help`"));
  EXPECT_EQ(said_by([] {
              return man_command({"task-host", ""});
            }).error,
            "unknown command `task-host`");
}

TEST(AboutCommands, man_writes_all_pages) {
  const TemporaryFolder folder;
  const Said said = said_by([&] { return man_command({"", folder.path() / "man"}); });
  EXPECT_EQ(said.code, ExitCode::ok);
  EXPECT_EQ(said.out, "");
  const auto page_of = [](const std::string& name) {
    return said_by([&name] { return man_command({name, ""}); }).out;
  };
  for (const auto& [name, file] :
       std::vector<std::pair<std::string, std::string>>{{"", "man1/tetfarm.1"},
                                                        {"run", "man1/tetfarm-run.1"},
                                                        {"job", "man5/tetfarm-job.5"},
                                                        {"gc", "man8/tetfarm-gc.8"}}) {
    EXPECT_EQ(contents(folder.path() / "man" / file), page_of(name)) << file;
  }
}

TEST(AboutCommands, completion_is_for_the_shell_that_was_named) {
  const auto script = [](const char* shell) {
    return said_by([&] { return completion_command({shell}); }).out;
  };
  EXPECT_THAT(script("bash"), HasSubstr("complete -F _tetfarm tetfarm\n"));
  EXPECT_THAT(script("zsh"), StartsWith("#compdef tetfarm\n"));
  EXPECT_THAT(script("fish"), HasSubstr("\ncomplete -c tetfarm -f\n"));
}

TEST(AboutCommands, version_tells_program_compiler_and_libraries) {
  const auto json = nlohmann::json::parse(said_by([] { return version_command({true}); }).out);
  EXPECT_EQ(json["type"], "version");
  EXPECT_EQ(json["name"], "tetfarm");
  EXPECT_THAT(json["version"].get<std::string>(),
              ::testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_TRUE(json.contains("commit"));
  EXPECT_GE(json["program"].get<std::string>().size(), 32U);
  EXPECT_THAT(json["compiler"].get<std::string>(), ::testing::ContainsRegex("(GCC|Clang) [0-9]+"));
  for (const char* library : {"ZeroMQ", "Protocol Buffers", "SQLite", "HDF5", "zlib", "spdlog"}) {
    EXPECT_THAT(json["libraries"][library].get<std::string>(),
                ::testing::ContainsRegex("[0-9]+\\.[0-9]+"))
        << library;
  }
  const std::string text = said_by([] { return version_command({}); }).out;
  EXPECT_THAT(text, StartsWith("tetfarm " + json["version"].get<std::string>() + "\n"));
  EXPECT_THAT(text, HasSubstr(json["program"].get<std::string>()));
}

}  // namespace
}  // namespace tetfarm
