#include "cli/folder_probes.h"

#include <gmock/gmock.h>

#include "base/error_with_help.h"
#include "tests/cli/said.h"
#include "tests/support/program.h"

namespace tetfarm {
namespace {

using test::TemporaryFolder;
using test::write_contents;
using ::testing::HasSubstr;

TEST(FolderProbes, leave_nothing_in_a_folder_that_is_sound) {
  const TemporaryFolder folder;
  const Finding files = look_at_files(folder.path());
  EXPECT_NE(files.verdict, Verdict::problem) << files.found;
  EXPECT_THAT(files.found, HasSubstr("written, synced, renamed, locked"));
  EXPECT_NE(look_at_times_of_files(folder.path()).verdict, Verdict::problem);
  EXPECT_EQ(look_at_database(folder.path()).check, "database");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(FolderProbes, refuse_a_folder_that_is_not_there_or_is_a_file) {
  const TemporaryFolder folder;
  write_contents(folder.path() / "file", "x");
  for (const auto& [name, wrong] :
       {std::pair{"none", "is not there"}, {"file", "is not a folder"}}) {
    const std::filesystem::path path = folder.path() / name;
    const Said said = said_by([&] {
      look_at_files(path);
      return ExitCode::ok;
    });
    EXPECT_THAT(said.error, HasSubstr(path.string() + ": " + wrong));
    EXPECT_NE(said.help, "") << name;
  }
}

TEST(FolderProbes, warn_of_databases_on_network_file_systems) {
  EXPECT_EQ(finding_of_database("/farm", "").verdict, Verdict::ok);
  const Finding on_nfs = finding_of_database("/farm", "nfs");
  EXPECT_EQ(on_nfs.verdict, Verdict::problem);
  EXPECT_THAT(on_nfs.found, HasSubstr("/farm: on nfs"));
  EXPECT_THAT(on_nfs.remedy, HasSubstr("--database DIR"));
}

TEST(FolderProbes, find_clocks_that_are_apart) {
  EXPECT_EQ(finding_of_clock("files", 1'900).verdict, Verdict::ok);
  EXPECT_EQ(finding_of_clock("files", -1'900).verdict, Verdict::ok);
  const Finding ahead = finding_of_clock("files", 37'000);
  EXPECT_EQ(ahead.verdict, Verdict::warning);
  EXPECT_THAT(ahead.found, HasSubstr("37 s ahead of"));
  EXPECT_THAT(finding_of_clock("files", -37'000).found, HasSubstr("37 s behind"));
}

}  // namespace
}  // namespace tetfarm
