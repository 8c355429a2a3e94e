// A run's coordinator and workers when they cannot work.
#include <gmock/gmock.h>

#include "tests/support/program.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using test::write_contents;
using ::testing::HasSubstr;

TEST(LocalFarm, whose_coordinator_cannot_start_ends_with_the_coordinators_words) {
  const TemporaryFolder folder;
  const Ended made =
      run_program({"shape", "duct", "-o", "a.stl", "--spacing", "0.5"}, folder.path());
  ASSERT_EQ(made.code, 0) << made.err;
  std::filesystem::create_directories(folder.path() / "out" / ".tetfarm");
  write_contents(folder.path() / "out" / ".tetfarm" / "tetfarm.db", std::string(5000, 'x'));
  const Ended ended =
      run_program({"run", "a.stl", "-o", "out", "--progress", "none"}, folder.path(), 40);
  EXPECT_EQ(ended.code, 1);
  EXPECT_THAT(ended.err, HasSubstr("the coordinator ended unexpectedly: "));
  EXPECT_THAT(ended.err, HasSubstr("file is not a database"));
}

}  // namespace
}  // namespace tetfarm
