#include "tasks/failure_cause.h"
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

TEST_F(JobStateTest, runs_a_job_from_inspect_to_assemble) {
  submit();
  worker_ = new_worker();
  run_all();
  EXPECT_EQ(job().phase, JobPhase::done);
  const JobSummary result = summary();
  EXPECT_EQ(result.state, "done");
  EXPECT_EQ(result.leaves_made, result.leaves_meshed);
  EXPECT_GE(result.leaves_made, 2U);
  ASSERT_THAT(result.files, SizeIs(1));
  EXPECT_EQ(result.files.front().name, "mesh.vtu");
  EXPECT_EQ(result.tasks_ready + result.tasks_running, 0U);
}

TEST_F(JobStateTest, the_summary_says_why_a_subdomain_was_not_cut) {
  submit();
  worker_ = new_worker();
  run_all();
  std::size_t uncut = 0;
  for (const auto& [id, task] : state_->durable().tasks) {
    if (task.kind != TaskKind::decompose || !task.outputs.empty()) continue;
    ++uncut;
    EXPECT_EQ(summary().texts.at("uncut:" + std::to_string(task.path)), "no valid plane");
  }
  EXPECT_GE(uncut, 1U);
  EXPECT_EQ(summary().texts.size(), uncut);
}

TEST_F(JobStateTest, the_same_key_is_the_same_job) {
  const SubmitAnswer first = submit();
  const SubmitAnswer second = submit();
  EXPECT_FALSE(first.existed);
  EXPECT_TRUE(second.existed);
  EXPECT_EQ(first.job, second.job);
  EXPECT_NE(submit("other").job, first.job);
}

TEST_F(JobStateTest, a_key_with_other_contents_is_refused_and_changes_nothing) {
  const SubmitAnswer first = submit();
  commit();
  const ArtifactRef other{"surface", std::string(32, 'f'), 4};
  files_.insert(other.hash);
  const Submission changed{"key", "wing", "toml", to_inspect(job_file_, other), true};
  EXPECT_TRUE(state_->submit(changed, now_).differs);
  EXPECT_TRUE(state_->take_changes().empty()) << "also where it was to replace the others";
  EXPECT_FALSE(submit().differs);
  Submission of_another = changed;
  of_another.owner = "another";
  of_another.replaces_others = false;
  const SubmitAnswer second = state_->submit(of_another, now_);
  EXPECT_FALSE(second.existed) << "a key is its submitter's own";
  EXPECT_NE(second.job, first.job);
  commit();
  restart();
  EXPECT_EQ(state_->submit(of_another, now_).job, second.job);
  EXPECT_EQ(submit().job, first.job);
}

TEST_F(JobStateTest, hands_out_the_tasks_of_the_job_with_the_higher_priority_first) {
  const JobId first = submit("first").job;
  const JobId second = submit("second").job;
  commit();
  EXPECT_TRUE(state_->set_priority(second, 7, now_));
  commit();
  restart();
  worker_ = new_worker();
  EXPECT_EQ(task(next(worker_).task).job, second) << "also after a restart";
  EXPECT_TRUE(state_->set_priority(first, 8, now_));
  const WorkerId other = new_worker();
  EXPECT_EQ(task(next(other).task).job, first);
  EXPECT_TRUE(state_->validate().empty());
}

TEST_F(JobStateTest, a_priority_of_no_job_or_of_one_that_has_ended_changes_nothing) {
  const JobId job = submit("first").job;
  EXPECT_FALSE(state_->set_priority(JobId{99}, 1, now_));
  state_->cancel(job, now_);
  commit();
  EXPECT_TRUE(state_->set_priority(job, 1, now_));
  EXPECT_TRUE(state_->take_changes().empty());
}

TEST_F(JobStateTest, a_submission_has_its_priority_from_the_beginning) {
  Submission submission{"key", "wing", "toml", to_inspect(job_file_, surface_)};
  submission.priority = -3;
  const JobId id = state_->submit(submission, now_).job;
  commit();
  EXPECT_EQ(state_->durable().jobs.at(id).priority, -3);
  submission.priority = 4;
  EXPECT_TRUE(state_->submit(submission, now_).existed);
  EXPECT_EQ(state_->durable().jobs.at(id).priority, -3) << "that of a job that is there stays";
}

TEST_F(JobStateTest, each_end_of_a_job_is_untold_until_it_is_told_also_after_a_restart) {
  rules_.tells_ends = true;
  restart();
  const JobId job = submit().job;
  commit();
  EXPECT_THAT(state_->untold_ends(), testing::IsEmpty());
  now_.wall_ms = 77;
  state_->cancel(job, now_);
  commit();
  restart();
  EXPECT_THAT(state_->untold_ends(), testing::ElementsAre(job));
  state_->end_was_told(job, 76, "", now_);
  EXPECT_THAT(state_->untold_ends(), SizeIs(1)) << "that was another end";
  state_->end_was_told(job, 77, "", now_);
  commit();
  restart();
  EXPECT_THAT(state_->untold_ends(), testing::IsEmpty());
  EXPECT_EQ(record_.events().back().what, "end told");
  EXPECT_EQ(state_->retry(job, {}, now_), 1U);
  now_.wall_ms = 99;
  state_->cancel(job, now_);
  EXPECT_THAT(state_->untold_ends(), SizeIs(1)) << "it has ended again";
  EXPECT_EQ(state_->retry(job, {}, now_), 1U);
  state_->end_was_told(job, 99, "too late", now_);
  EXPECT_THAT(state_->untold_ends(), testing::IsEmpty()) << "it goes on, and that is not told";
  commit();
}

TEST_F(JobStateTest, where_nobody_is_to_be_told_no_end_is_untold) {
  state_->cancel(submit().job, now_);
  commit();
  EXPECT_THAT(state_->untold_ends(), testing::IsEmpty());
  EXPECT_FALSE(job().end_untold);
}

TEST_F(JobStateTest, jobs_without_a_key_are_all_different) {
  EXPECT_NE(submit("").job, submit("").job);
}

TEST_F(JobStateTest, refuses_a_late_result_after_the_lease_ran_out) {
  submit();
  worker_ = new_worker();
  const SendAssign first = next(worker_);
  wait(rules_.lease_ms + 1);
  commit();
  now_.steady_ms += rules_.elsewhere_ms;
  EXPECT_FALSE(finish(worker_, first));
  const SendAssign second = next(worker_);
  EXPECT_EQ(second.task, first.task);
  EXPECT_NE(second.attempt, first.attempt);
  EXPECT_FALSE(finish(worker_, first));
  EXPECT_TRUE(finish(worker_, second));
  EXPECT_EQ(task(first.task).losses, 1U);
}

TEST_F(JobStateTest, heartbeats_renew_the_lease_of_their_attempt_only) {
  submit();
  worker_ = new_worker();
  const SendAssign assign = next(worker_);
  for (int i = 0; i < 10; ++i) {
    now_.steady_ms += rules_.lease_ms - 1;
    state_->heartbeat(worker_, assign.task, assign.attempt, now_);
    commit();
    EXPECT_EQ(task(assign.task).state, TaskState::leased);
  }
  wait(rules_.lease_ms - 1);
  commit();
  wait(2);
  commit();
  EXPECT_TRUE(state_->knows_worker(worker_));
  EXPECT_EQ(task(assign.task).state, TaskState::ready);
}

TEST_F(JobStateTest, a_worker_without_a_task_that_says_nothing_for_a_lease_is_gone) {
  worker_ = new_worker();
  const WorkerId silent = new_worker();
  commit();
  wait(rules_.lease_ms);
  commit();
  EXPECT_TRUE(state_->knows_worker(silent));
  wait(1);
  commit();
  EXPECT_FALSE(state_->knows_worker(silent));
  EXPECT_TRUE(state_->knows_worker(worker_)) << "its heartbeats are heard";
}

TEST_F(JobStateTest, a_silent_worker_is_gone_a_lease_after_it_was_heard_whenever_that_was) {
  commit();
  now_.steady_ms += rules_.lease_ms / 2;
  const WorkerId silent = new_worker();
  commit();
  now_.steady_ms += rules_.lease_ms / 2 + 1;
  commit();
  now_.steady_ms += rules_.lease_ms / 2 - 1;
  commit();
  EXPECT_TRUE(state_->knows_worker(silent));
  now_.steady_ms += 1;
  commit();
  EXPECT_FALSE(state_->knows_worker(silent));
}

TEST_F(JobStateTest, answers_a_repeated_done_alike) {
  submit();
  worker_ = new_worker();
  const SendAssign assign = next(worker_);
  EXPECT_TRUE(finish(worker_, assign));
  EXPECT_TRUE(finish(worker_, assign));
}

TEST_F(JobStateTest, an_attempt_goes_on_when_its_worker_comes_back_after_a_restart) {
  submit();
  worker_ = new_worker();
  const SendAssign assign = next(worker_);
  restart();
  const WorkerId again = state_->add_worker({}, assign.task, assign.attempt, now_);
  const std::vector<Command> commands = state_->take_commands();
  ASSERT_THAT(commands, SizeIs(1));
  EXPECT_TRUE(std::get<SendWelcome>(commands.front()).keep_running);
  EXPECT_TRUE(finish(again, assign));
}

TEST_F(JobStateTest, a_stale_attempt_is_told_to_end_by_its_next_heartbeat) {
  submit();
  worker_ = new_worker();
  const SendAssign assign = next(worker_);
  state_->cancel(JobId{1}, now_);
  commit();
  state_->take_commands();
  state_->heartbeat(worker_, assign.task, assign.attempt, now_);
  const std::vector<Command> commands = state_->take_commands();
  ASSERT_THAT(commands, SizeIs(1));
  EXPECT_FALSE(std::get<SendAccepted>(commands.front()).taken);
}

TEST_F(JobStateTest, sends_a_lost_assignment_again) {
  submit();
  worker_ = new_worker();
  const SendAssign first = next(worker_);
  const SendAssign second = next(worker_);
  EXPECT_EQ(first.attempt, second.attempt);
}

TEST_F(JobStateTest, bad_input_fails_the_job_at_once_with_its_evidence) {
  submit();
  worker_ = new_worker();
  const SendAssign assign = next(worker_);
  TaskFailure failure;
  failure.exit_code = 3;
  failure.message = "wing.stl: the surface is open";
  failure.evidence = {fake_file("open_edges.vtp", "x")};
  files_.insert(failure.evidence.front().hash);
  EXPECT_TRUE(fail(worker_, assign, failure));
  const JobSummary result = summary();
  EXPECT_EQ(result.state, "failed");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.message, HasSubstr("the surface is open"));
  ASSERT_THAT(result.files, SizeIs(1));
  EXPECT_EQ(result.files.front().name, "open_edges.vtp");
  EXPECT_FALSE(next(worker_).attempt);
}

TEST_F(JobStateTest, poisons_a_task_after_three_crashes_and_names_its_inputs) {
  submit();
  worker_ = new_worker();
  for (std::uint32_t i = 0; i < rules_.max_crashes; ++i) {
    EXPECT_EQ(job().phase, JobPhase::running);
    wait(60000);
    fail(worker_, next(worker_), crash());
  }
  EXPECT_EQ(job().phase, JobPhase::failed);
  EXPECT_EQ(job().exit_code, 1);
  EXPECT_THAT(job().message, HasSubstr("signal 11"));
  EXPECT_THAT(job().message, HasSubstr(surface_.hash));
}

TEST_F(JobStateTest, waits_longer_after_each_crash) {
  submit();
  worker_ = new_worker();
  fail(worker_, next(worker_), crash());
  wait(rules_.crash_delay_ms - 1);
  EXPECT_FALSE(next(worker_).attempt);
  wait(1);
  fail(worker_, next(worker_), crash());
  wait(rules_.crash_delay_ms + 1);
  EXPECT_FALSE(next(worker_).attempt);
  wait(rules_.crash_delay_ms);
  EXPECT_TRUE(next(worker_).attempt);
}

TEST_F(JobStateTest, prefers_another_worker_after_a_crash) {
  submit();
  worker_ = new_worker();
  const WorkerId other = new_worker();
  const SendAssign first = next(worker_);
  fail(worker_, first, crash());
  wait(rules_.crash_delay_ms);
  EXPECT_FALSE(next(worker_).attempt);
  EXPECT_EQ(next(other).task, first.task);
}

TEST_F(JobStateTest, kills_from_outside_are_not_counted_as_crashes) {
  submit();
  worker_ = new_worker();
  TaskFailure killed = crash();
  killed.cause = FailureCause::killed;
  for (int i = 0; i < 10; ++i) {
    wait(60000);
    fail(worker_, next(worker_), killed);
  }
  EXPECT_EQ(job().phase, JobPhase::running);
  wait(60000);
  run_all();
  EXPECT_EQ(job().phase, JobPhase::done);
}

TEST_F(JobStateTest, a_task_that_is_lost_again_and_again_fails_in_the_end) {
  submit();
  worker_ = new_worker();
  TaskFailure killed;
  killed.cause = FailureCause::killed;
  for (std::uint32_t i = 0; i < rules_.max_losses; ++i) {
    wait(60000);
    fail(worker_, next(worker_), killed);
  }
  EXPECT_EQ(job().phase, JobPhase::failed);
}

TEST_F(JobStateTest, a_task_handed_back_is_nobodys_fault) {
  submit();
  worker_ = new_worker();
  const SendAssign assign = next(worker_);
  state_->worker_left(worker_, false, now_);
  commit();
  EXPECT_EQ(task(assign.task).losses, 0U);
  EXPECT_EQ(next(new_worker()).task, assign.task);
}

TEST_F(JobStateTest, a_full_disk_stops_the_handing_out_for_a_growing_while) {
  submit();
  worker_ = new_worker();
  TaskFailure full;
  full.message = "No space left on device";
  full.cause = FailureCause::disk_full;
  full.exit_code = 6;
  fail(worker_, next(worker_), full);
  EXPECT_EQ(summary().state, "stuck");
  EXPECT_THAT(summary().message, HasSubstr("No space left"));
  wait(999);
  EXPECT_FALSE(next(worker_).attempt);
  wait(1);
  fail(worker_, next(worker_), full);
  wait(1999);
  EXPECT_FALSE(next(worker_).attempt);
  wait(1);
  run_all();
  EXPECT_EQ(summary().state, "done");
  EXPECT_EQ(summary().crashes, 0U);
}

TEST_F(JobStateTest, a_failed_job_submitted_again_tries_what_failed) {
  submit();
  worker_ = new_worker();
  ASSERT_TRUE(finish(worker_, next(worker_)));
  fail(worker_, next(worker_), {});
  ASSERT_EQ(job().phase, JobPhase::failed);
  restart();
  worker_ = new_worker();
  EXPECT_TRUE(submit().existed);
  EXPECT_EQ(job().phase, JobPhase::running);
  EXPECT_NE(task(next(worker_).task).kind, TaskKind::inspect);
  run_all();
  EXPECT_EQ(job().phase, JobPhase::done);
}

TEST_F(JobStateTest, a_cancelled_job_hands_out_nothing_and_may_be_resumed) {
  submit();
  worker_ = new_worker();
  const SendAssign assign = next(worker_);
  EXPECT_TRUE(state_->cancel(JobId{1}, now_));
  EXPECT_FALSE(state_->cancel(JobId{77}, now_));
  commit();
  EXPECT_FALSE(finish(worker_, assign));
  EXPECT_FALSE(next(worker_).attempt);
  EXPECT_EQ(summary().state, "cancelled");
  submit();
  run_all();
  EXPECT_EQ(summary().state, "done");
}

TEST_F(JobStateTest, a_result_whose_files_are_not_in_the_store_is_refused) {
  submit();
  worker_ = new_worker();
  const SendAssign assign = next(worker_);
  state_->done(worker_, assign.task, assign.attempt, run_fake_task(task(assign.task)), now_);
  EXPECT_FALSE(answer());
  EXPECT_EQ(task(assign.task).state, TaskState::ready);
}

TEST_F(JobStateTest, a_vanished_input_is_made_again_before_it_is_used) {
  submit();
  worker_ = new_worker();
  const SendAssign inspect = next(worker_);
  ASSERT_TRUE(finish(worker_, inspect));
  files_.erase(find_file(task(inspect.task).outputs, "root")->hash);
  const SendAssign nothing = next(worker_);
  const SendAssign again = nothing.attempt ? nothing : next(worker_);
  EXPECT_EQ(again.task, inspect.task);
  ASSERT_TRUE(finish(worker_, again));
  run_all();
  EXPECT_EQ(job().phase, JobPhase::done);
}

TEST_F(JobStateTest, other_bytes_the_second_time_fail_the_job) {
  submit();
  worker_ = new_worker();
  const SendAssign inspect = next(worker_);
  ASSERT_TRUE(finish(worker_, inspect));
  files_.erase(find_file(task(inspect.task).outputs, "root")->hash);
  next(worker_);
  const SendAssign again = next(worker_);
  ASSERT_EQ(again.task, inspect.task);
  TaskResult other = run_fake_task(task(again.task));
  other.outputs.front() = fake_file("surface", "other");
  files_.insert(other.outputs.front().hash);
  files_.insert(find_file(other.outputs, "root")->hash);
  state_->done(worker_, again.task, again.attempt, other, now_);
  commit();
  EXPECT_EQ(job().phase, JobPhase::failed);
  EXPECT_THAT(job().message, HasSubstr("different bytes"));
}

TEST_F(JobStateTest, a_lost_job_input_fails_the_job_until_it_is_submitted_again) {
  submit();
  worker_ = new_worker();
  files_.erase(surface_.hash);
  EXPECT_FALSE(next(worker_).attempt);
  EXPECT_EQ(job().phase, JobPhase::failed);
  EXPECT_THAT(job().message, HasSubstr("input_surface"));
  files_.insert(surface_.hash);
  submit();
  run_all();
  EXPECT_EQ(job().phase, JobPhase::done);
}

TEST_F(JobStateTest, a_done_job_whose_result_is_gone_is_assembled_again) {
  submit();
  worker_ = new_worker();
  run_all();
  files_.erase(summary().files.front().hash);
  EXPECT_TRUE(submit().existed);
  EXPECT_EQ(job().phase, JobPhase::running);
  run_all();
  EXPECT_EQ(job().phase, JobPhase::done);
  EXPECT_TRUE(files_.contains(summary().files.front().hash));
}

TEST_F(JobStateTest, an_unusable_result_fails_the_job) {
  submit();
  worker_ = new_worker();
  const SendAssign assign = next(worker_);
  state_->done(worker_, assign.task, assign.attempt, {}, now_);
  commit();
  EXPECT_EQ(job().phase, JobPhase::failed);
  EXPECT_THAT(job().message, HasSubstr("surface"));
}

class RestartWithAnotherCount : public JobStateTest {
 protected:
  /// What a store that knows nothing makes of it.
  std::string fresh_outcome(std::uint64_t parts, std::uint64_t groups) {
    record_ = {};
    files_ = {surface_.hash};
    worker_ = {};
    restart();
    return outcome_of(run_job(parts, groups));
  }
};

TEST_F(RestartWithAnotherCount, cuts_that_were_made_are_not_made_again) {
  run_job(4, 0);
  const JobId sixteen = run_job(16, 0);
  EXPECT_EQ(state_->durable().jobs.at(sixteen).phase, JobPhase::done);
  EXPECT_EQ(tasks(sixteen, TaskKind::decompose) - worked_on(sixteen, TaskKind::decompose), 3U)
      << "the root and its children were cut for the job of 4";
  const JobId eight = run_job(8, 0);
  EXPECT_EQ(worked_on(eight, TaskKind::decompose), 0U) << "the job of 16 has all of them";
}

TEST_F(RestartWithAnotherCount, the_outcome_is_that_of_a_fresh_run) {
  run_job(4, 0);
  const std::string sixteen = outcome_of(run_job(16, 0));
  const std::string eight = outcome_of(run_job(8, 0));
  const std::string assimilated = outcome_of(run_job(16, 2));
  EXPECT_EQ(fresh_outcome(16, 0), sixteen);
  EXPECT_EQ(fresh_outcome(8, 0), eight);
  EXPECT_EQ(fresh_outcome(16, 2), assimilated);
}

TEST_F(RestartWithAnotherCount, other_groups_cut_nothing) {
  run_job(16, 2);
  const JobId four = run_job(16, 4);
  EXPECT_EQ(worked_on(four, TaskKind::decompose), 0U);
  EXPECT_EQ(worked_on(four, TaskKind::assimilate), 1U);
}

TEST_F(RestartWithAnotherCount, a_result_whose_file_is_gone_does_not_serve) {
  const JobId first = run_job(4, 0);
  for (const auto& [id, row] : state_->durable().tasks) {
    if (row.job == first && row.kind == TaskKind::decompose && row.path == 1) {
      files_.erase(row.outputs.front().hash);
    }
  }
  const JobId second = run_job(16, 0);
  EXPECT_EQ(state_->durable().jobs.at(second).phase, JobPhase::done);
  EXPECT_EQ(tasks(second, TaskKind::decompose) - worked_on(second, TaskKind::decompose), 2U);
}

TEST_F(RestartWithAnotherCount, results_of_another_program_do_not_serve) {
  rules_.program = "old";
  restart();
  run_job(4, 0);
  rules_.program = "new";
  worker_ = {};
  restart();
  const JobId second = run_job(16, 0);
  EXPECT_EQ(tasks(second, TaskKind::decompose), worked_on(second, TaskKind::decompose));
}

TEST_F(RestartWithAnotherCount, the_job_that_is_replaced_stops) {
  const ArtifactRef file = fake_job(4, 0);
  files_.insert(file.hash);
  worker_ = new_worker();
  state_->submit({"four", "wing", "toml", to_inspect(file, surface_), true}, now_);
  const SendAssign inspect = next(worker_);
  const JobId sixteen = run_job(16, 0);
  EXPECT_EQ(job().phase, JobPhase::cancelled);
  EXPECT_EQ(state_->durable().jobs.at(sixteen).phase, JobPhase::done);
  EXPECT_FALSE(finish(worker_, inspect)) << "its attempt is stale";
  state_->submit({"four", "wing", "toml", to_inspect(file, surface_), true}, now_);
  commit();
  run_all();
  EXPECT_EQ(job().phase, JobPhase::done);
}

TEST_F(JobStateTest, a_job_that_remeshes_begins_with_that_and_is_the_same_job_when_asked_again) {
  Submission submission{"key", "wing", "toml", to_inspect(job_file_, surface_)};
  submission.remeshes = true;
  const SubmitAnswer first = state_->submit(submission, now_);
  commit();
  worker_ = new_worker();
  const SendAssign remesh = next(worker_);
  EXPECT_EQ(task(remesh.task).kind, TaskKind::remesh);
  EXPECT_THAT(names_of(task(remesh.task).inputs), testing::ElementsAre("job", "input_surface"));
  EXPECT_EQ(tasks(first.job, TaskKind::inspect), 0U);
  ASSERT_TRUE(finish(worker_, remesh));
  restart();
  worker_ = new_worker();
  const SendAssign inspect = next(worker_);
  EXPECT_EQ(task(inspect.task).kind, TaskKind::inspect);
  EXPECT_THAT(names_of(task(inspect.task).inputs), testing::ElementsAre("job", "remeshed_surface"));
  EXPECT_TRUE(state_->submit(submission, now_).existed);
  ASSERT_TRUE(finish(worker_, inspect));
  run_all();
  EXPECT_EQ(job().phase, JobPhase::done);
  EXPECT_EQ(worked_on(first.job, TaskKind::remesh), 1U);
}

}  // namespace
}  // namespace tetfarm
