#include "mesh/assemble/output_file.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"
#include "tests/support/seen_syncs.h"

namespace tetfarm {
namespace {

TEST(OutputFile, has_what_was_written_at_each_place_and_is_on_the_disk_when_it_is_finished) {
  const TempFolder folder;
  const auto path = folder.path() / "mesh";
  const test::SeenSyncs syncs;
  OutputFile file(path, OutputFile::Start::empty);
  file.write(4, "farm");
  file.write(0, "tet ");
  EXPECT_FALSE(syncs.has(path));
  file.finish();
  EXPECT_TRUE(syncs.has(path));
  EXPECT_EQ(read_file(path), "tet farm");
}

TEST(OutputFile, in_a_folder_that_is_not_there_is_an_error_of_the_world) {
  const TempFolder folder;
  EXPECT_THROW(OutputFile(folder.path() / "none" / "mesh", OutputFile::Start::empty), IoError);
}

}  // namespace
}  // namespace tetfarm
