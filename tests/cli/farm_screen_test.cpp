#include "cli/farm_screen.h"

#include <gmock/gmock.h>

#include "proto/doing.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

wire::JobStatus& add_job(SeenFarm& seen, const std::string& job, const std::string& state) {
  wire::JobStatus& status = *seen.status.add_jobs();
  status.set_job(job);
  status.set_name("wing");
  status.set_state(state);
  return status;
}

wire::JobStatus& add_meshing(SeenFarm& seen, double under_way) {
  wire::JobStatus& job = add_job(seen, "job-7", "running");
  job.set_stage("mesh");
  job.set_leaves_made(8);
  job.set_leaves_meshed(3);
  job.set_tasks_running(2);
  job.set_tasks_ready(4);
  job.set_estimated_elements(1e6);
  job.set_elements_under_way(under_way);
  job.set_seconds(83);
  return job;
}

TEST(FarmScreen, shows_what_waits_the_jobs_and_what_workers_do) {
  SeenFarm seen;
  add_job(seen, "job-6", "done").set_elements(1'234'567);
  wire::JobStatus& job = add_meshing(seen, 5e5);
  wire::RunningTask& task = *job.add_running();
  task.set_task(31);
  task.set_kind("mesh");
  task.set_path(5);
  task.set_seconds(42);
  seen.status.set_workers(2);
  wire::WorkerLine idle;
  idle.set_worker(1);
  idle.set_host("node-1");
  idle.set_state("idle");
  wire::WorkerLine busy;
  busy.set_worker(2);
  busy.set_host("node-2");
  busy.set_state("busy");
  busy.set_task(31);
  busy.set_memory_bytes(std::uint64_t{4} << 30U);
  *busy.mutable_doing() = doing_message({WorkStage::edges, 3, 312, 1204});
  seen.workers = {idle, busy};
  FarmScreen screen;
  EXPECT_EQ(screen.text(seen, 1'000),
            "1 job runs; 4 tasks wait, 2 run; 2 workers\n"
            "\n"
            "JOB    NAME  STATE    STAGE  DONE   SUB-DOMAINS  ELEMENTS  TASKS  TIME   ETA\n"
            "job-7  wing  running  mesh   40 %   3/8                    2+4    01:23\n"
            "job-6  wing  done            100 %               1.2M      0+0    00:00\n"
            "\n"
            "WORKER    HOST    STATE  MEMORY    TASK        SINCE  DOES\n"
            "worker-2  node-2  busy   4096 MiB  31 mesh LR  00:42  recovery pass 3: 312 of 1,204 "
            "edges\n"
            "worker-1  node-1  idle   0 MiB\n");
}

TEST(FarmScreen, knows_a_time_left_from_the_second_look_on_and_lets_no_share_fall) {
  SeenFarm first;
  add_meshing(first, 2e5);
  SeenFarm second;
  add_meshing(second, 4e5);
  SeenFarm third;
  add_meshing(third, 1e5).set_stage("decompose");
  FarmScreen screen;
  EXPECT_THAT(screen.text(first, 10'000), Not(HasSubstr("00:06")));
  EXPECT_THAT(screen.text(second, 12'000), HasSubstr("01:23  00:06\n"));
  EXPECT_THAT(screen.text(second, 12'000), HasSubstr("36 %"));
  EXPECT_THAT(screen.text(third, 13'000), HasSubstr("36 %"));
}

TEST(FarmScreen, of_a_farm_at_rest_is_one_line) {
  EXPECT_EQ(FarmScreen().text({}, 0), "0 jobs run; 0 tasks wait, 0 run; 0 workers\n");
}

TEST(FarmScreen, tells_trouble_and_quarantine_and_is_not_steered_by_names) {
  SeenFarm seen;
  seen.status.set_trouble("the disk is full");
  wire::JobStatus& job = add_job(seen, "job-1", "running");
  job.set_name("a\033[2Jb");
  job.add_quarantine();
  const std::string text = FarmScreen().text(seen, 0);
  EXPECT_THAT(text, HasSubstr("\nthe disk is full\n"));
  EXPECT_THAT(text, HasSubstr(", 1 in quarantine"));
  EXPECT_EQ(text.find('\033'), std::string::npos);
}

TEST(FarmScreen, is_cut_to_what_there_is_room_for) {
  const std::string text = "one\ntwo\nthree\nfour\n";
  EXPECT_EQ(cut_to_screen(text, 4, 0), "one\ntwo\nthree\nfour");
  EXPECT_EQ(cut_to_screen(text, 3, 0), "one\ntwo\n... 2 lines more");
  EXPECT_EQ(cut_to_screen(text, 10, 3), "one\ntwo\nthr\nfou");
}

}  // namespace
}  // namespace tetfarm
