#include "cli/query_text.h"

#include <gmock/gmock.h>

#include "proto/doing.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

wire::Explanation waiting_task() {
  wire::Explanation explanation;
  explanation.mutable_task()->set_task(31);
  explanation.mutable_task()->set_job("job-7");
  explanation.mutable_task()->set_kind("mesh");
  explanation.mutable_task()->set_path(6);
  explanation.mutable_task()->set_state("ready");
  explanation.set_expected_seconds(0.2);
  explanation.set_limit_seconds(3600);
  return explanation;
}

TEST(QueryText, of_a_task_whose_memory_is_not_known_tells_its_time_alone) {
  EXPECT_THAT(explanation_text(waiting_task()),
              HasSubstr("  expected to take 0.2 s; it is stopped after 3600.0 s\n"));
}

TEST(QueryText, tells_what_a_task_is_expected_to_take) {
  wire::Explanation explanation = waiting_task();
  explanation.set_room_bytes(std::uint64_t{30} << 20U);
  EXPECT_THAT(explanation_text(explanation),
              HasSubstr("expected to take 0.2 s and 30 MiB; it is stopped after"));
}

TEST(QueryText, says_that_a_task_runs_where_programs_read_that_it_is_leased) {
  wire::TaskLine task;
  task.set_task(3);
  task.set_state("leased");
  EXPECT_THAT(tasks_text({task}), HasSubstr("running"));
  EXPECT_THAT(tasks_text({task}), Not(HasSubstr("leased")));
}

TEST(QueryText, tells_what_a_task_that_runs_does) {
  wire::Explanation explanation = waiting_task();
  wire::TaskLine& task = *explanation.mutable_task();
  task.set_state("leased");
  *task.mutable_doing() = doing_message({WorkStage::edges, 3, 312, 1204});
  task.set_share(0.2);
  EXPECT_THAT(explanation_text(explanation),
              HasSubstr("  doing: recovery pass 3: 312 of 1,204 edges, about 20 % of the task\n"));
  EXPECT_THAT(tasks_text({task}), HasSubstr("recovery pass 3: 312 of 1,204 edges"));
}

TEST(QueryText, counts_the_failed_attempts_of_a_worker) {
  wire::WorkerLine worker;
  worker.set_worker(1);
  worker.set_not_done(2);
  EXPECT_THAT(workers_table({worker}), HasSubstr("FAILED ATTEMPTS"));
}

}  // namespace
}  // namespace tetfarm
