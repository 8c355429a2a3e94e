// What is told of a task while it runs, by the program itself.
#include <gmock/gmock.h>

#include "base/sanitizers.h"
#include "tests/system/watched_run.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::Program;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Progress, of_a_leaf_that_is_meshed_is_seen_in_status_explain_and_plain_lines) {
  const TemporaryFolder folder;
  const std::string input = test::sphere_in_box(folder.path(), 24, 4);
  // The leaf takes some seconds: lines of a task come a second apart.
  const std::string size = is_sanitized ? "0.085" : "0.062";
  const auto words = [&](const std::string& output, const std::string& progress) {
    return std::vector<std::string>{"run",    input,          "-o",    output,   "-j",
                                    "1",      "--subdomains", "1",     "--size", size,
                                    "--json", "--progress",   progress};
  };
  Program run(words("out", "plain"), folder.path());
  test::WatchedTasks tasks;
  tasks.watch(run, folder.path(), "out");
  const Ended ended = run.wait();
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(tasks.stages("mesh"), Not(testing::IsEmpty()));
  EXPECT_GT(tasks.most_under_way(), 0);
  EXPECT_GT(tasks.steps(), 0);
  EXPECT_THAT(tasks.explained(), HasSubstr("  doing: "));
  EXPECT_THAT(tasks.text(), HasSubstr("         task "));
  EXPECT_THAT(ended.err,
              testing::ContainsRegex("mesh  *0/1 sub-domains.*(recovery|points|cosmetics)"));
  const Ended alone = test::run_program(words("alone", "none"), folder.path());
  ASSERT_EQ(alone.code, 0) << alone.err;
  EXPECT_EQ(test::digest_of(ended), test::digest_of(alone)) << "looking changes nothing";
}

}  // namespace
}  // namespace tetfarm
