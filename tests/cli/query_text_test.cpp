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

constexpr std::int64_t quarter_past_seven_ms = 1'795'331'702'999;  // 2026-11-22 07:15:02.999

TEST(QueryText, of_a_time_is_that_of_greenwich_to_the_second) {
  EXPECT_EQ(time_text(quarter_past_seven_ms), "2026-11-22 07:15:02");
  EXPECT_EQ(time_text(0), "");
}

TEST(QueryText, of_jobs_is_a_table) {
  wire::JobStatus job;
  job.set_job("job-7");
  job.set_name(std::string(31, 'w'));
  job.set_state("running");
  job.set_stage("mesh");
  job.set_tasks_done(1);
  job.set_tasks_ready(20);
  job.set_tasks_running(300);
  job.add_quarantine();
  job.add_quarantine();
  job.set_elements(12'345);
  job.set_created_ms(quarter_past_seven_ms);
  job.set_seconds(72);
  job.set_message("it waits");
  EXPECT_EQ(jobs_text({job}),
            "JOB    NAME                               STATE    STAGE  TASKS  RUNNING  QUARANTINE  "
            "TETS   SUBMITTED (UTC)      TOOK\n"
            "job-7  wwwwwwwwwwwwwwwwwwwwwwwwwwwwww…  running  mesh   1/323  300      2           "
            "12.3k  2026-11-22 07:15:02  01:12  it waits\n");
}

TEST(QueryText, of_tasks_is_a_table) {
  wire::TaskLine done;
  done.set_task(31);
  done.set_job("job-7");
  done.set_kind("mesh");
  done.set_path(5);
  done.set_state("done");
  done.set_seconds(2.26);
  done.set_peak_rss_bytes((std::uint64_t{30} << 20U) + 7);
  done.set_crashes(1);
  done.set_losses(2);
  done.set_oom_count(3);
  done.set_worker(4);
  done.set_host("node1");
  wire::TaskLine waiting;
  waiting.set_task(32);
  waiting.set_job("job-7");
  waiting.set_kind("inspect");
  waiting.set_state("waiting");
  waiting.set_losses(1);
  waiting.set_message("input lost");
  EXPECT_EQ(
      tasks_text({done, waiting}),
      "TASK  JOB    KIND     SUB-DOMAIN  STATE    SECONDS  PEAK    TRIED                       "
      "       WHERE\n"
      "31    job-7  mesh     LR          done     2.3      30 MiB  1 errors, 2 lost, 3 out of "
      "memory  worker-4 node1\n"
      "32    job-7  inspect              waiting                   1 lost                      "
      "                       input lost\n");
}

TEST(QueryText, of_workers_is_a_table) {
  wire::WorkerLine busy;
  busy.set_worker(3);
  busy.set_host("node1");
  busy.set_process(471);
  busy.set_state("busy");
  busy.set_task(31);
  busy.set_done(5);
  busy.set_not_done(2);
  busy.set_busy_seconds(12.34);
  busy.set_memory_bytes(std::uint64_t{2} << 30U);
  busy.set_seen_ms(quarter_past_seven_ms);
  wire::WorkerLine idle = busy;
  idle.set_worker(4);
  idle.set_task(0);
  idle.set_state("idle");
  idle.set_host_in_quarantine(true);
  EXPECT_EQ(workers_table({busy, idle}),
            "WORKER    HOST   PROCESS  STATE  TASK  DONE  FAILED ATTEMPTS  BUSY S  MEMORY    SINCE "
            "(UTC)\n"
            "worker-3  node1  471      busy   31    5     2                12.3    2048 MiB  "
            "2026-11-22 07:15:02\n"
            "worker-4  node1  471      idle         5     2                12.3    2048 MiB  "
            "2026-11-22 07:15:02  host in quarantine\n");
}

TEST(QueryText, of_an_event_is_a_line_with_what_it_is_about) {
  wire::EventLine event;
  event.set_wall_ms(quarter_past_seven_ms);
  event.set_what("started");
  EXPECT_EQ(event_text(event), "2026-11-22 07:15:02  started\n");
  event.set_job("job-7");
  event.set_task(31);
  event.set_attempt(40);
  event.set_worker(3);
  event.set_what("crashed");
  event.set_message("signal 11");
  EXPECT_EQ(event_text(event),
            "2026-11-22 07:15:02  job-7 task 31 attempt 40 worker-3 crashed: signal 11\n");
}

TEST(QueryText, of_a_log_is_the_attempt_and_each_line_of_what_it_said) {
  wire::AttemptLine attempt;
  attempt.set_job("job-7");
  attempt.set_task(31);
  attempt.set_kind("mesh");
  attempt.set_path(5);
  attempt.set_attempt(40);
  attempt.set_worker(3);
  attempt.set_host("node1");
  attempt.set_state("crashed");
  const std::string head = "job-7 task 31, mesh LR: attempt 40 on worker-3 node1, crashed\n";
  EXPECT_EQ(log_text(attempt), head + "  (no output is kept)\n");
  attempt.set_log("one\n\ntwo");
  EXPECT_EQ(log_text(attempt), head + "  one\n  \n  two\n");
  attempt.set_log("one\n");
  EXPECT_EQ(log_text(attempt), head + "  one\n");
  attempt.set_path(0);
  EXPECT_EQ(log_text(attempt),
            "job-7 task 31, mesh: attempt 40 on worker-3 node1, crashed\n  one\n");
}

TEST(QueryText, of_a_task_tells_its_place_its_reasons_its_attempts_and_what_is_missing) {
  wire::Explanation explanation = waiting_task();
  explanation.mutable_task()->set_state("failed");
  explanation.set_subdomain_state("open");
  explanation.add_reasons("it crashed three times");
  explanation.add_reasons("nobody tried again");
  wire::AttemptLine& attempt = *explanation.add_attempts();
  attempt.set_attempt(40);
  attempt.set_worker(3);
  attempt.set_host("node1");
  attempt.set_started_ms(quarter_past_seven_ms);
  attempt.set_ended_ms(quarter_past_seven_ms + 2500);
  attempt.set_peak_rss_bytes(std::uint64_t{30} << 20U);
  attempt.set_state("crashed");
  attempt.set_races(true);
  attempt.set_message("signal 11");
  for (const bool is_there : {true, false}) {
    wire::InputLine& input = *explanation.add_inputs();
    input.set_name(is_there ? "surface" : "spacing");
    input.set_hash("abc");
    input.set_is_there(is_there);
  }
  EXPECT_EQ(explanation_text(explanation),
            "task 31 of job-7: mesh of sub-domain RL (6), failed\n"
            "  in the tree: below R, beside RR; sub-domain open\n"
            "  why: it crashed three times\n"
            "  why: nobody tried again\n"
            "  try again: tetfarm retry job-7 31\n"
            "  expected to take 0.2 s; it is stopped after 3600.0 s\n"
            "  ATTEMPT  WHERE           STARTED (UTC)        SECONDS  PEAK    RESULT\n"
            "  40       worker-3 node1  2026-11-22 07:15:02  2.5      30 MiB  crashed (raced)  "
            "signal 11\n"
            "  missing: spacing abc\n");
}

TEST(QueryText, of_a_task_on_the_right_names_the_sub_domain_on_the_left) {
  wire::Explanation explanation = waiting_task();
  explanation.mutable_task()->set_path(7);
  EXPECT_THAT(explanation_text(explanation), HasSubstr("in the tree: below R, beside RL;"));
}

TEST(QueryText, of_a_task_that_is_done_tells_how_long_it_took) {
  wire::Explanation explanation = waiting_task();
  explanation.mutable_task()->set_state("done");
  explanation.mutable_task()->set_seconds(2.5);
  explanation.mutable_task()->set_path(1);
  EXPECT_EQ(explanation_text(explanation),
            "task 31 of job-7: mesh of sub-domain root (1), done\n  took 2.5 s\n");
  explanation.mutable_task()->set_path(0);
  explanation.mutable_task()->set_state("leased");
  explanation.set_limit_seconds(0);
  EXPECT_EQ(explanation_text(explanation),
            "task 31 of job-7: mesh, running\n  expected to take 0.2 s\n");
  explanation.set_expected_seconds(0);
  EXPECT_EQ(explanation_text(explanation), "task 31 of job-7: mesh, running\n");
}

}  // namespace
}  // namespace tetfarm
