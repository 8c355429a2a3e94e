#include "cli/fetch_files.h"

#include <gmock/gmock.h>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

TEST(FetchFiles, leaves_out_what_has_no_checksum_or_no_name) {
  const TempFolder folder;
  wire::JobStatus status;
  status.set_job("job-1");
  const auto add = [&](const char* name, const std::string& hash) {
    wire::Artifact& file = *status.add_files();
    file.set_name(name);
    file.set_hash(hash);
    file.set_size(1);
  };
  add("wing.vtkhdf", "../../escaped");
  add("wing.stl", "");
  add("..", std::string(32, 'a'));
  add("folder/", std::string(32, 'a'));
  // Nobody is there: whoever asked for one of them would hear nothing.
  CoordinatorConnection nobody("ipc://" + (folder.path() / "nobody").string());
  EXPECT_THAT(fetch_files(nobody, status, folder.path() / "out", {100, ProgressStyle::none}),
              testing::IsEmpty());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "out"));
}

}  // namespace
}  // namespace tetfarm
