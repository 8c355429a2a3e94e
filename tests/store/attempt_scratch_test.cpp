#include "store/attempt_scratch.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

#include "base/clock.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

class AttemptScratch : public testing::Test {
 protected:
  fs::path make(const std::string& name) const {
    const fs::path path = store_.scratch_folder() / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << "x";
    return path;
  }
  TempFolder folder_;
  ArtifactStore store_{folder_.path()};
};

TEST_F(AttemptScratch, goes_with_all_in_it_and_other_attempts_keep_theirs) {
  const fs::path own = make("attempt-7/a/b");
  const fs::path other = make("attempt-77/a");
  remove_attempt_scratch(store_, AttemptId{7});
  EXPECT_FALSE(fs::exists(attempt_scratch(store_, AttemptId{7})));
  EXPECT_FALSE(fs::exists(own));
  EXPECT_TRUE(fs::exists(other));
  remove_attempt_scratch(store_, AttemptId{7});
}

TEST_F(AttemptScratch, of_attempts_that_do_not_run_is_swept_with_probes_and_old_temporary_files) {
  const std::vector<fs::path> gone = {make("attempt-7/mesh"), make("probe-0123"),
                                      make("frame.vtkhdf.5.abc.tmp")};
  const std::vector<fs::path> kept = {make("attempt-8/mesh"), make("attempt-x/mesh"),
                                      make("mesh.0123.vtkhdf"), make("upload-7-0123.part")};
  sweep_leftovers(store_, {AttemptId{8}}, std::numeric_limits<std::int64_t>::max());
  for (const fs::path& path : gone) EXPECT_FALSE(fs::exists(path)) << path;
  for (const fs::path& path : kept) EXPECT_TRUE(fs::exists(path)) << path;
}

TEST_F(AttemptScratch, temporary_files_that_an_attempt_may_be_writing_are_left) {
  const fs::path young = make("frame.vtkhdf.5.abc.tmp");
  const std::int64_t hour_ms = 3'600'000;
  sweep_leftovers(store_, {}, wall_ms() - hour_ms);
  EXPECT_TRUE(fs::exists(young));
  sweep_leftovers(store_, {}, wall_ms() + hour_ms);
  EXPECT_FALSE(fs::exists(young));
}

}  // namespace
}  // namespace tetfarm
