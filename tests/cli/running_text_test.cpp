#include "cli/running_text.h"

#include <gmock/gmock.h>

#include "proto/doing.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

wire::JobStatus job_with(int tasks) {
  wire::JobStatus status;
  for (int i = 1; i <= tasks; ++i) {
    wire::RunningTask& task = *status.add_running();
    task.set_task(static_cast<std::uint64_t>(10 + i));
    task.set_kind("mesh");
    task.set_path(5);
    task.set_seconds(72);
    *task.mutable_doing() = doing_message({WorkStage::edges, 3, 312, 1204});
    task.set_share(0.21);
  }
  return status;
}

TEST(RunningText, has_a_line_for_each_of_the_few_tasks_that_run_longest) {
  const std::string text = running_tasks_text(job_with(30));
  EXPECT_THAT(text, HasSubstr("task 11, mesh LR, 01:12: recovery pass 3: 312 of 1,204 edges\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
}

TEST(RunningText, has_no_line_for_a_task_of_which_nothing_is_known) {
  wire::JobStatus status;
  status.add_running()->set_kind("mesh");
  EXPECT_EQ(running_tasks_text(status), "");
}

TEST(RunningText, of_a_task_says_how_much_of_it_is_done_where_that_is_known) {
  wire::TaskLine task;
  EXPECT_EQ(doing_with_share(task), "");
  *task.mutable_doing() = doing_message({WorkStage::assemble, 0, 3, 16});
  EXPECT_EQ(doing_with_share(task), "assembling: 3 of 16 sub-domains");
  task.set_share(0.214);
  EXPECT_THAT(doing_with_share(task), HasSubstr(", about 21 % of the task"));
}

}  // namespace
}  // namespace tetfarm
