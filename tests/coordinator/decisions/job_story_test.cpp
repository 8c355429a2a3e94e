// What is written into the history of a job, line by line: what people read when something went
// wrong.
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

class JobStory : public JobStateTest {
 protected:
  /// The lines since the last call, "TASK ATTEMPT WORKER WHAT: MESSAGE".
  std::vector<std::string> told() {
    std::vector<std::string> lines;
    const std::vector<EventRow>& events = record_.events();
    for (; next_event_ < events.size(); ++next_event_) {
      const EventRow& event = events[next_event_];
      const auto number = [](std::uint64_t id) { return id == 0 ? "-" : std::to_string(id); };
      lines.push_back(number(event.task.value) + " " + number(event.attempt.value) + " " +
                      number(event.worker.value) + " " + event.what + ": " + event.message);
    }
    return lines;
  }
  /// A job with one worker, of which nothing is told yet.
  void begin(const std::string& key = "key") {
    submit(key);
    commit();
    worker_ = add_worker({.host = "node-1", .process = 7});
    commit();
    told();
  }
  static TaskFailure failure(FailureCause cause, const std::string& message) {
    TaskFailure failure;
    failure.cause = cause;
    failure.message = message;
    return failure;
  }
  std::string inputs() const {
    std::string list;
    for (const ArtifactRef& file : {job_file_, surface_}) {
      list += (list.empty() ? "" : ", ") + file.name + " artifacts/" + file.hash.substr(0, 2) +
              "/" + file.hash;
    }
    return list;
  }

  std::size_t next_event_ = 0;
};

TEST_F(JobStory, begins_with_the_submission_and_the_workers_that_come) {
  submit();
  commit();
  EXPECT_THAT(told(), ElementsAre("- - - submitted: wing", "1 - - ready: inspect"));
  worker_ = add_worker({.host = "node-1", .process = 7});
  commit();
  EXPECT_THAT(told(), ElementsAre("- - 1 worker: node-1 process 7"));
  const SendAssign assign = next(worker_);
  EXPECT_THAT(told(), ElementsAre("1 1 1 assigned: inspect"));
  ASSERT_TRUE(finish(worker_, assign));
  EXPECT_THAT(told(), ElementsAre("1 1 1 done: inspect", "2 - - ready: decompose 1"));
  state_->worker_left(worker_, false, now_);
  commit();
  EXPECT_THAT(told(), ElementsAre("- - 1 worker left: node-1"));
}

TEST_F(JobStory, ends_with_the_mesh) {
  const ArtifactRef file = fake_job(1, 0);
  files_.insert(file.hash);
  state_->submit({"one", "wing", "toml", to_inspect(file, surface_)}, now_);
  worker_ = new_worker();
  run_all();
  EXPECT_EQ(told().back(), "- - - job done: ");
}

TEST_F(JobStory,
       of_a_task_that_crashes_again_and_again_ends_in_quarantine_until_somebody_says_retry) {
  begin();
  for (int i = 0; i < 3; ++i) {
    wait(60'000);
    fail(worker_, next(worker_), failure(FailureCause::error, "signal 11"));
  }
  const std::string reason =
      "quarantined: crashed 3 times; last failure: signal 11; its inputs in the store: " + inputs();
  EXPECT_THAT(told(), ElementsAre("1 1 1 assigned: inspect", "1 1 1 crashed: inspect: signal 11",
                                  "1 2 1 assigned: inspect", "1 2 1 crashed: inspect: signal 11",
                                  "1 3 1 assigned: inspect", "1 3 1 crashed: inspect: signal 11",
                                  "1 - - quarantined: inspect: " + reason,
                                  "- - - job failed: inspect: " + reason));
  EXPECT_EQ(job().message, "inspect: " + reason);
  EXPECT_EQ(task(TaskId{1}).message, reason);
  EXPECT_EQ(state_->retry(JobId{1}, TaskId{2}, now_), 0U) << "there is no such task";
  EXPECT_EQ(state_->retry(JobId{2}, {}, now_), 0U);
  EXPECT_EQ(state_->retry(JobId{1}, TaskId{1}, now_), 1U);
  commit();
  EXPECT_THAT(told(), ElementsAre("1 - - retried: inspect"));
  const TaskRow& again = task(TaskId{1});
  EXPECT_EQ(again.crashes, 0U);
  EXPECT_EQ(again.message, "");
  EXPECT_EQ(again.state, TaskState::ready);
  EXPECT_EQ(job().message, "");
  EXPECT_EQ(job().exit_code, 0);
  EXPECT_EQ(job().finished_ms, 0);
}

TEST_F(JobStory, of_a_task_that_is_lost_too_often_says_so) {
  rules_.max_losses = 2;
  restart();
  begin();
  for (int i = 0; i < 2; ++i) {
    wait(60'000);
    fail(worker_, next(worker_), failure(FailureCause::killed, "signal 9"));
  }
  EXPECT_EQ(told().back(),
            "- - - job failed: inspect: quarantined: lost or killed 2 times; last failure: signal "
            "9; its inputs in the store: " +
                inputs());
  EXPECT_EQ(task(TaskId{1}).exit_code, 1);
}

TEST_F(JobStory, of_bad_input_ends_at_once_with_its_exit_code) {
  begin();
  TaskFailure bad = failure(FailureCause::for_good, "the surface is open");
  bad.exit_code = 3;
  bad.log = "its words";
  bad.peak_rss_bytes = 77;
  fail(worker_, next(worker_), bad);
  EXPECT_THAT(told(),
              ElementsAre("1 1 1 assigned: inspect", "1 1 1 failed: inspect: the surface is open",
                          "1 - - quarantined: inspect: the surface is open",
                          "- - - job failed: inspect: the surface is open"));
  EXPECT_EQ(job().exit_code, 3);
  const AttemptRow& attempt = record_.attempts().at(AttemptId{1});
  EXPECT_EQ(attempt.state, AttemptState::failed);
  EXPECT_EQ(attempt.log, "its words");
  EXPECT_EQ(attempt.peak_rss_bytes, 77U);
  EXPECT_EQ(attempt.message, "the surface is open");
  EXPECT_EQ(attempt.ended_ms, now_.wall_ms);
  EXPECT_EQ(submit().existed, true);
  commit();
  EXPECT_THAT(told(), ElementsAre("- - - resumed: "));
}

TEST_F(JobStory, of_a_task_that_needs_more_memory_than_there_is_says_what_to_do) {
  constexpr std::uint64_t mib = 1U << 20U;
  submit();
  commit();
  worker_ = add_worker({.host = "node-1", .memory_bytes = 100 * mib});
  commit();
  told();
  TaskFailure starved = failure(FailureCause::out_of_memory, "std::bad_alloc");
  starved.peak_rss_bytes = 30 * mib;
  fail(worker_, next(worker_), starved);
  EXPECT_EQ(task(TaskId{1}).memory_bytes, 60 * mib) << "twice what it took";
  wait(60'000);
  fail(worker_, next(worker_), starved);
  EXPECT_EQ(task(TaskId{1}).memory_bytes, 100 * mib) << "at most all that there is";
  wait(60'000);
  fail(worker_, next(worker_), starved);
  EXPECT_EQ(told().back(),
            "- - - job failed: inspect: quarantined: out of memory 3 times; last failure: "
            "std::bad_alloc; its inputs in the store: " +
                inputs() +
                "; it had 100 MiB, the largest worker has 100 MiB, and more cuts do not make it "
                "smaller: cut finer (--max-memory, --subdomains), or start a larger worker and "
                "retry");
  EXPECT_EQ(job().exit_code, 6);
}

TEST_F(JobStory, has_who_was_lost_and_who_left) {
  begin();
  next(worker_);
  state_->worker_left(worker_, true, now_);
  commit();
  EXPECT_THAT(told(),
              ElementsAre("1 1 1 assigned: inspect", "1 1 1 lost: inspect: the worker was lost",
                          "- - 1 worker lost: node-1"));
  EXPECT_EQ(task(TaskId{1}).losses, 1U);
  EXPECT_EQ(task(TaskId{1}).message, "the worker was lost");
  now_.steady_ms += 60'000;
  worker_ = add_worker({.host = "node-2"});
  next(worker_);
  state_->worker_left(worker_, false, now_);
  commit();
  EXPECT_THAT(told(),
              ElementsAre("- - 2 worker: node-2 process 0", "1 2 2 assigned: inspect",
                          "1 2 2 returned: inspect: handed back", "- - 2 worker left: node-2"));
  EXPECT_EQ(task(TaskId{1}).losses, 1U) << "that is nobody's fault";
}

TEST_F(JobStory, has_leases_that_ran_out_and_processes_that_took_anothers_place) {
  begin();
  next(worker_);
  wait(rules_.lease_ms + 1);
  commit();
  EXPECT_THAT(told(),
              ElementsAre("1 1 1 assigned: inspect", "1 1 1 lost: inspect: its lease ran out"));
  wait(60'000);
  next(worker_);
  state_->greet_again(worker_, {.host = "node-1", .nonce = "another"}, {}, {}, now_);
  commit();
  EXPECT_THAT(told(), ElementsAre("1 2 1 assigned: inspect",
                                  "1 2 1 lost: inspect: another process took its place"));
}

TEST_F(JobStory, of_a_cancelled_job_says_so_and_its_attempts_are_revoked) {
  begin();
  next(worker_);
  EXPECT_TRUE(state_->cancel(JobId{1}, now_));
  EXPECT_TRUE(state_->cancel(JobId{1}, now_)) << "once is enough";
  commit();
  EXPECT_THAT(told(), ElementsAre("1 1 1 assigned: inspect", "- - - cancelled: ",
                                  "1 1 1 revoked: inspect: the job was cancelled"));
  EXPECT_EQ(job().finished_ms, now_.wall_ms);
  EXPECT_EQ(task(TaskId{1}).losses + task(TaskId{1}).crashes, 0U);
}

TEST_F(JobStory, has_full_disks_once_however_often_they_are_met) {
  begin();
  fail(worker_, next(worker_), failure(FailureCause::disk_full, "No space left on device"));
  EXPECT_THAT(told(), ElementsAre("1 1 1 assigned: inspect",
                                  "1 1 1 returned: inspect: No space left on device",
                                  "- - - stuck: No space left on device"));
  state_->out_of_resources("still full", now_);
  commit();
  EXPECT_THAT(told(), testing::IsEmpty());
  EXPECT_EQ(state_->stuck_message(), "still full");
  EXPECT_EQ(task(TaskId{1}).losses + task(TaskId{1}).crashes, 0U);
}

TEST_F(JobStory, of_a_full_disk_is_over_with_the_first_result_that_comes) {
  begin();
  const SendAssign assign = next(worker_);
  state_->out_of_resources("No space left on device", now_);
  EXPECT_TRUE(state_->is_stuck());
  ASSERT_TRUE(finish(worker_, assign));
  EXPECT_FALSE(state_->is_stuck());
  EXPECT_TRUE(next(worker_).attempt);
}

TEST_F(JobStory, has_files_that_were_lost_and_are_made_again) {
  begin();
  ASSERT_TRUE(finish(worker_, next(worker_)));
  told();
  const std::string root = find_file(task(TaskId{1}).outputs, "root")->hash;
  files_.erase(root);
  SendAssign again = next(worker_);
  if (!again.attempt) again = next(worker_);
  const std::vector<std::string> lines = told();
  ASSERT_GE(lines.size(), 2U);
  EXPECT_EQ(lines[0], "2 - - waiting: decompose 1: its input 'subdomain' is missing or damaged");
  EXPECT_EQ(lines.back(), "1 2 1 assigned: inspect");
  ASSERT_TRUE(finish(worker_, again));
  EXPECT_EQ(told().back(), "2 - - ready: decompose 1: its inputs are back");
}

TEST_F(JobStory, of_results_that_are_none_says_what_is_wrong_with_them) {
  begin();
  const SendAssign assign = next(worker_);
  TaskResult result = run_fake_task(task(assign.task));
  for (const ArtifactRef& file : result.outputs) files_.insert(file.hash);
  result.numbers["parts"] = 0;
  state_->done(worker_, assign.task, assign.attempt, result, now_);
  EXPECT_TRUE(answer());
  EXPECT_THAT(
      told(),
      ElementsAre("1 1 1 assigned: inspect", "1 1 1 failed: inspect: the number of parts is 0",
                  "1 - - quarantined: inspect: unusable result: the number of parts is 0",
                  "- - - job failed: inspect: unusable result: the number of parts is 0"));
  EXPECT_EQ(job().exit_code, 1);
}

TEST_F(JobStory, of_results_whose_files_are_missing_goes_on_with_another_try) {
  begin();
  const SendAssign assign = next(worker_);
  state_->done(worker_, assign.task, assign.attempt, run_fake_task(task(assign.task)), now_);
  EXPECT_FALSE(answer());
  EXPECT_THAT(told(), ElementsAre("1 1 1 assigned: inspect",
                                  "1 1 1 lost: inspect: its outputs are not in the store"));
  EXPECT_EQ(task(assign.task).losses, 1U);
}

TEST_F(JobStory, of_work_that_an_earlier_job_has_done_says_that_it_serves) {
  run_job(1, 0);
  told();
  const ArtifactRef file = fake_job(1, 0);
  state_->submit({"again", "wing", "toml", to_inspect(file, surface_)}, now_);
  commit();
  const std::vector<std::string> lines = told();
  ASSERT_GE(lines.size(), 3U);
  EXPECT_EQ(lines[0], "- - - submitted: wing");
  EXPECT_THAT(lines[1], testing::HasSubstr(" - - served: inspect: as an earlier job has done it"));
  EXPECT_EQ(lines.back(), "- - - job done: ");
}

TEST_F(JobStory, of_several_tasks_in_quarantine_names_them) {
  submit();
  worker_ = new_worker();
  run_until_meshes();
  fail(worker_, held_, failure(FailureCause::for_good, "first"));
  for (SendAssign assign = next(worker_); assign.attempt; assign = next(worker_)) {
    if (task(assign.task).kind == TaskKind::mesh) {
      fail(worker_, assign, failure(FailureCause::for_good, "another"));
    } else {
      ASSERT_TRUE(finish(worker_, assign));
    }
  }
  EXPECT_EQ(job().phase, JobPhase::failed);
  EXPECT_THAT(job().message, testing::MatchesRegex("[0-9]+ tasks are in quarantine: mesh of "
                                                   "sub-domain [LR]+ \\(task [0-9]+\\): .*"));
  EXPECT_THAT(job().message, testing::HasSubstr("): first"));
  EXPECT_THAT(job().message, testing::HasSubstr("): another; mesh of sub-domain "));
}

TEST(PlaceOf, says_what_is_done_and_where) {
  TaskRow row;
  EXPECT_EQ(place_of(row), "inspect");
  row.kind = TaskKind::mesh;
  row.path = 1;
  EXPECT_EQ(place_of(row), "mesh of the whole domain");
  row.path = 6;
  EXPECT_EQ(place_of(row), "mesh of sub-domain RL");
}

}  // namespace
}  // namespace tetfarm
