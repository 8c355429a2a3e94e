#include "json/running_json.h"

#include <gtest/gtest.h>

#include "proto/doing.h"

namespace tetfarm {
namespace {

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

TEST(RunningJson, tells_programs_stage_and_counts) {
  const nlohmann::ordered_json json = running_json(job_with(2));
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[1]["task"], 12);
  EXPECT_EQ(json[1]["doing"], "recovery pass 3: 312 of 1,204 edges");
  EXPECT_EQ(json[1]["doing_stage"], "edges");
  EXPECT_EQ(json[1]["doing_pass"], 3);
  EXPECT_EQ(json[1]["doing_done"], 312);
  EXPECT_EQ(json[1]["doing_total"], 1204);
  EXPECT_EQ(json[1]["share"], 0.21);
}

TEST(RunningJson, of_a_task_of_which_nothing_is_known_says_nothing) {
  wire::JobStatus status;
  status.add_running()->set_kind("mesh");
  EXPECT_EQ(running_json(status)[0]["doing"], "");
}

TEST(RunningJson, has_all_that_is_known_of_a_task) {
  wire::JobStatus status = job_with(1);
  status.mutable_running(0)->set_attempt(40);
  EXPECT_EQ(running_json(status).dump(),
            R"([{"task":11,"kind":"mesh","path":5,"attempt":40,"seconds":72.0,)"
            R"("doing":"recovery pass 3: 312 of 1,204 edges","doing_stage":"edges",)"
            R"("doing_pass":3,"doing_done":312,"doing_total":1204,"share":0.21}])");
}

}  // namespace
}  // namespace tetfarm
