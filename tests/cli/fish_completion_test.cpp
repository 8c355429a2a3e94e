#include "cli/fish_completion.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>

#include "cli/command_line.h"
#include "tests/cli/other_programs.h"

namespace tetfarm {
namespace {

using test::TemporaryFolder;
using test::write_contents;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsSupersetOf;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

/// Fish itself completes lines, in a folder with a file and a folder.
class FishCompletion : public ::testing::Test {
 protected:
  FishCompletion() {
    write_contents(here() / "tetfarm.fish", fish_completion(declared_commands()));
    write_contents(here() / "wing.stl", "");
    std::filesystem::create_directory(here() / "out");
  }

  const std::filesystem::path& here() const { return folder_.path(); }

  std::vector<std::string> printed_by_fish(const std::string& commands) const {
    write_contents(here() / "asked", "source ./tetfarm.fish\n" + commands);
    return lines_of(
        printed_by({"env", "HOME=" + here().string(), "fish", "--no-config", "asked"}, here()));
  }

  /// Without what fish says of them.
  std::vector<std::string> offered(const std::string& line) const {
    std::vector<std::string> words;
    for (const std::string& one : printed_by_fish("complete -C 'tetfarm " + line + "'\n")) {
      words.push_back(one.substr(0, one.find('\t')));
    }
    return words;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(FishCompletion, is_what_fish_can_read) {
  printed_by({"fish", "--no-execute", "tetfarm.fish"}, here());
}

TEST_F(FishCompletion, of_commands) {
  EXPECT_THAT(offered("ru"), Contains("run"));
  EXPECT_THAT(offered("keys "), AllOf(IsSupersetOf({"new", "authorize", "revoke", "list"}),
                                      Not(Contains("run")), Not(Contains("wing.stl"))));
  EXPECT_THAT(offered("keys list "), Not(Contains("new")));
  EXPECT_THAT(printed_by_fish("complete -C 'tetfarm ru'\n"),
              Contains("run\tMesh a surface with worker processes on this machine"));
}

TEST_F(FishCompletion, of_options) {
  EXPECT_THAT(offered("run --for"), UnorderedElementsAre("--force", "--format"));
  EXPECT_THAT(offered("keys list --j"), ElementsAre("--json"));
}

TEST_F(FishCompletion, of_values) {
  EXPECT_THAT(offered("run --progress "), UnorderedElementsAre("text", "plain", "none", "json"));
  EXPECT_THAT(offered("run --progress=pl"), ElementsAre("--progress=plain"));
  EXPECT_THAT(offered("shape du"), ElementsAre("duct"));
  EXPECT_THAT(offered("run --format vt"), ElementsAre("vtkhdf"));
  EXPECT_THAT(offered("run --format su2,vt"), ElementsAre("su2,vtkhdf"));
}

TEST_F(FishCompletion, of_files_and_folders) {
  EXPECT_THAT(offered("run w"), ElementsAre("wing.stl"));
  EXPECT_THAT(offered("run wing.stl -o "), ElementsAre("out/"));
  EXPECT_THAT(offered("status w"), Not(Contains("wing.stl"))) << "the name of a job";
  EXPECT_THAT(offered("render out --field w"), ElementsAre("wing.stl"));
}

TEST_F(FishCompletion, knows_every_option_of_every_command) {
  const std::vector<DeclaredCommand> commands = with_all_below(declared_commands());
  std::string asked;
  for (const DeclaredCommand& command : commands) {
    asked +=
        "complete -C 'tetfarm " + command.name + " -' | string replace -r '\\t.*' ''\necho =\n";
  }
  const std::vector<std::string> lines = printed_by_fish(asked);
  auto begin = lines.begin();
  for (const DeclaredCommand& command : commands) {
    const auto end = std::find(begin, lines.end(), "=");
    ASSERT_NE(end, lines.end());
    const std::vector<std::string> offers(begin, end);
    for (const DeclaredOption& option : command.options) {
      EXPECT_THAT(offers, IsSupersetOf(option.names)) << command.name;
    }
    begin = std::next(end);
  }
}

}  // namespace
}  // namespace tetfarm
