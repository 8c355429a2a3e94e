// What is told of a leaf whose boundary takes long to recover.
#include <gmock/gmock.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

#include "tests/system/watched_run.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::Program;
using test::TemporaryFolder;
using ::testing::HasSubstr;

TEST(Progress, of_a_boundary_that_is_recovered_is_told_until_its_end) {
  const char* data = std::getenv("TETFARM_DATA");
  if (data == nullptr) GTEST_SKIP() << "TETFARM_DATA is not set";
  const TemporaryFolder folder;
  const std::string input = std::string(data) + "/printer_cable_holder/printer_cable_holder.stl";
  std::vector<std::string> words = test::run_words(input, "out", 1, 1);
  *(std::find(words.begin(), words.end(), "none")) = "plain";
  Program run(words, folder.path());
  test::WatchedTasks tasks;
  tasks.watch(run, folder.path(), "out", "mesh", "cosmetics");
  run.signal(SIGTERM);
  const Ended ended = run.wait();
  EXPECT_THAT(tasks.stages("mesh"), testing::IsSupersetOf({"edges", "cosmetics"}));
  EXPECT_GT(tasks.steps(), 3);
  EXPECT_THAT(ended.err, HasSubstr("  recovery pass "));
  EXPECT_THAT(ended.err, HasSubstr(" edges\n"));
  EXPECT_THAT(ended.err, HasSubstr("  eta "));
}

}  // namespace
}  // namespace tetfarm
