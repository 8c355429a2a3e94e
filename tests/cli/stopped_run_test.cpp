#include "cli/stopped_run.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

TEST(StoppedRun, without_a_task_under_way_loses_nothing) {
  EXPECT_EQ(stopped_text({"job-1", 3, {}}),
            "stopped at a checkpoint: 3 finished tasks are kept, no work is lost\n");
  EXPECT_THAT(stopped_text({"job-1", 0, {}}), HasSubstr("no task had finished yet"));
  EXPECT_THAT(stopped_text({}), HasSubstr("nothing was running"));
}

TEST(StoppedRun, names_the_tasks_whose_work_is_lost) {
  const StoppedRun stopped{"job-1", 1, {{2, "mesh", 1, 12.34}, {9, "cosmetic", 6, 0.5}}};
  EXPECT_EQ(stopped_text(stopped),
            "stopped at a checkpoint: 1 finished task is kept\n"
            "lost, to be done again from the start: mesh of the whole domain, 12.3 s of work; "
            "cosmetic of sub-domain RL, 0.5 s of work\n");
  EXPECT_EQ(stopped_json(stopped),
            R"({"type":"stopped","job":"job-1","tasks_done":1,"tasks_lost":[)"
            R"({"task":2,"kind":"mesh","path":1,"seconds":12.34},)"
            R"({"task":9,"kind":"cosmetic","path":6,"seconds":0.5}],"exit_code":75})");
}

TEST(StoppedRun, of_many_lost_tasks_names_a_few) {
  StoppedRun stopped{"job-1", 0, {}};
  for (std::uint64_t task = 1; task <= 40; ++task) stopped.lost.push_back({task, "write", task, 1});
  EXPECT_THAT(stopped_text(stopped), HasSubstr("; and 35 more\n"));
}

TEST(StoppedRun, knows_the_tasks_under_way_once_each) {
  wire::StatusReply farm;
  for (const std::uint64_t task : {7, 0, 3, 7}) farm.add_at_work()->set_task(task);
  EXPECT_EQ(tasks_under_way(farm), (std::vector<std::uint64_t>{3, 7}));
}

}  // namespace
}  // namespace tetfarm
