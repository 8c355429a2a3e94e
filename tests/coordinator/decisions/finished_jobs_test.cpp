// Jobs that have ended leave memory, and nothing is lost by it: their rows are read again when
// somebody asks for them.
#include "coordinator/decisions/finished_jobs.h"

#include "coordinator/views/farm_metrics.h"
#include "coordinator/views/query_answers.h"
#include "proto/messages.pb.h"
#include "store/job_database.h"
#include "tests/base/temp_folder.h"
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

/// A coordinator that lets ended jobs go after each commit, as the server does.
class Finished : public JobStateTest {
 protected:
  Finished() { restart(); }

  void restart() {
    finished_ = FinishedJobs({[this](JobId job) {
                                ++times_read_;
                                return record_.rows_of(job);
                              },
                              [this](TaskId task) { return record_.row_of(task); }});
    start_over();
  }
  /// As after a commit that failed: only decisions are made anew.
  void start_over() {
    DurableState rows = record_.unfinished();
    finished_.put_others_than(rows);
    state_ = std::make_unique<JobState>(
        std::move(rows), rules_,
        [this](const ArtifactRef& file) { return files_.contains(file.hash); }, now_, &finished_);
  }
  /// What is finished goes; how many jobs.
  std::size_t let_go() {
    commit();
    const std::vector<DurableState> jobs = state_->take_finished();
    for (const DurableState& job : jobs) finished_.put(job);
    EXPECT_THAT(state_->validate(), testing::IsEmpty());
    return jobs.size();
  }
  wire::JobStatus status(JobId job) const {
    wire::StatusRequest request;
    request.set_job(job_name(job));
    return answer_status(request, *state_, now_).jobs(0);
  }
  /// The job of four parts, of which the mesh of sub-domain 6 crashes until it is in quarantine.
  JobId run_into_quarantine() {
    const ArtifactRef file = fake_job(4, 0);
    files_.insert(file.hash);
    const JobId id =
        state_->submit({file.hash, "wing", "toml", to_inspect(file, surface_)}, now_).job;
    worker_ = add_worker({.nonce = "one"});
    for (int i = 0; i < 200; ++i) {
      now_.steady_ms += 5000;
      state_->heartbeat(worker_, {}, {}, now_);
      const SendAssign assign = next(worker_);
      if (!assign.attempt) continue;
      const TaskRow& row = task(assign.task);
      if (row.kind == TaskKind::mesh && row.path == 6) {
        fail(worker_, assign, crash());
      } else {
        finish(worker_, assign);
      }
    }
    return id;
  }

  FinishedJobs finished_;
  std::size_t times_read_ = 0;  ///< rows of a whole job
};

TEST_F(Finished, a_job_leaves_memory_when_its_end_is_committed_and_its_status_stays_the_same) {
  const JobId job = run_job(4, 0);
  const std::string before = status(job).DebugString();
  ASSERT_THAT(before, HasSubstr("done"));
  EXPECT_EQ(let_go(), 1U);
  EXPECT_TRUE(state_->durable().tasks.empty());
  EXPECT_TRUE(state_->durable().subdomains.empty());
  EXPECT_EQ(status(job).DebugString(), before);
  restart();
  EXPECT_TRUE(state_->durable().tasks.empty());
  EXPECT_EQ(status(job).DebugString(), before);
}

TEST_F(Finished, a_running_job_stays_and_so_does_one_with_an_attempt_that_still_runs) {
  submit();
  worker_ = add_worker({.nonce = "one"});
  run_until_meshes();
  EXPECT_EQ(let_go(), 0U);
  // With everything lost, its input too, the job fails while its first mesh is being made.
  files_.clear();
  const WorkerId other = add_worker({.host = "other", .nonce = "other"});
  for (int i = 0; i < 10; ++i) next(other);
  ASSERT_EQ(job().phase, JobPhase::failed);
  EXPECT_EQ(let_go(), 0U);
  state_->worker_left(worker_, true, now_);
  EXPECT_EQ(let_go(), 1U);
}

TEST_F(Finished, numbers_of_tasks_are_never_given_out_again) {
  run_job(4, 0);
  let_go();
  const std::uint64_t last = state_->durable().last_task;
  restart();
  const SubmitAnswer second = submit("another");
  commit();
  ASSERT_THAT(state_->durable().tasks, SizeIs(1));
  EXPECT_EQ(state_->durable().tasks.begin()->first.value, last + 1);
  EXPECT_EQ(state_->durable().tasks.begin()->second.job, second.job);
}

TEST_F(Finished, a_result_that_is_said_once_more_is_known_to_be_taken) {
  const ArtifactRef file = fake_job(2, 0);
  files_.insert(file.hash);
  state_->submit({"key", "wing", "toml", to_inspect(file, surface_)}, now_);
  worker_ = add_worker({.nonce = "one"});
  SendAssign last = next(worker_);
  for (SendAssign assign = last; assign.attempt; assign = next(worker_)) {
    last = assign;
    ASSERT_TRUE(finish(worker_, assign));
  }
  ASSERT_EQ(let_go(), 1U);
  const TaskResult result = run_fake_task(*record_.row_of(last.task));
  state_->done(worker_, last.task, last.attempt, result, now_);
  EXPECT_TRUE(answer());
  state_->done(worker_, last.task, AttemptId{last.attempt.value - 1}, result, now_);
  EXPECT_FALSE(answer()) << "an earlier attempt of another task";
}

/// The same jobs where nothing ever leaves memory.
class Kept : public JobStateTest {
 public:
  std::size_t cuts_made_of_the_second(std::uint64_t first, std::uint64_t second) {
    run_job(first, 0);
    return worked_on(run_job(second, 0), TaskKind::decompose);
  }

 private:
  void TestBody() override {}
};

TEST_F(Finished, its_results_serve_for_later_jobs_as_if_it_were_still_there) {
  run_job(4, 0);
  ASSERT_EQ(let_go(), 1U);
  const std::size_t cuts = worked_on(run_job(8, 0), TaskKind::decompose);
  EXPECT_EQ(cuts, Kept().cuts_made_of_the_second(4, 8));
  let_go();
  restart();
  worker_ = {};
  const JobId third = run_job(16, 0);
  EXPECT_EQ(worked_on(third, TaskKind::decompose), Kept().cuts_made_of_the_second(8, 16));
  EXPECT_LT(worked_on(third, TaskKind::decompose), tasks(third, TaskKind::decompose));
}

TEST_F(Finished, a_job_that_is_submitted_again_is_read_only_where_a_result_is_lost) {
  const JobId job = run_job(2, 0);
  ASSERT_EQ(let_go(), 1U);
  const std::string key = record_.state().jobs.at(job).key;
  const auto submit_again = [&] {
    return state_->submit({key, "wing", "toml", to_inspect(fake_job(2, 0), surface_)}, now_);
  };
  EXPECT_TRUE(submit_again().existed);
  EXPECT_FALSE(state_->is_at_hand(job));
  const ArtifactRef result = finished_.jobs().at(job).results.front();
  files_.erase(result.hash);
  EXPECT_EQ(submit_again().job, job);
  EXPECT_TRUE(state_->is_at_hand(job));
  run_all();
  EXPECT_TRUE(files_.contains(result.hash)) << "it is assembled again";
  EXPECT_EQ(let_go(), 1U);
  EXPECT_EQ(status(job).state(), "done");
}

TEST_F(Finished, a_failed_job_goes_on_where_it_was_and_is_at_last_as_if_nothing_had_been) {
  const JobId job = run_into_quarantine();
  ASSERT_EQ(let_go(), 1U);
  ASSERT_EQ(status(job).state(), "failed");
  ASSERT_THAT(status(job).quarantine(), SizeIs(1));
  restart();
  const TaskId quarantined{status(job).quarantine(0).task()};
  EXPECT_EQ(state_->retry(job, TaskId{1}, now_), 0U) << "that one is not in quarantine";
  EXPECT_EQ(state_->retry(job, quarantined, now_), 1U);
  commit();
  // A commit that fails finds it at hand again.
  start_over();
  EXPECT_TRUE(state_->is_at_hand(job));
  worker_ = add_worker({.nonce = "two"});
  run_all();
  EXPECT_EQ(let_go(), 1U);
  EXPECT_EQ(status(job).state(), "done");
  EXPECT_EQ(status(job).crashes(), 0U);
}

TEST_F(Finished, what_could_not_be_committed_leaves_a_failed_job_as_it_was) {
  const JobId job = run_into_quarantine();
  ASSERT_EQ(let_go(), 1U);
  const std::string before = status(job).DebugString();
  EXPECT_EQ(state_->retry(job, {}, now_), 1U);
  start_over();
  EXPECT_FALSE(state_->is_at_hand(job));
  EXPECT_EQ(status(job).DebugString(), before);
}

TEST_F(Finished, why_a_task_of_a_failed_job_does_not_run_is_found_in_its_rows) {
  const JobId job = run_into_quarantine();
  const TaskId quarantined{status(job).quarantine(0).task()};
  const std::vector<std::string> before = state_->outlook(quarantined, now_).reasons;
  ASSERT_EQ(let_go(), 1U);
  EXPECT_EQ(state_->past_job(job, now_).outlook(quarantined, now_).reasons, before);
  EXPECT_FALSE(state_->is_at_hand(job)) << "a question changes nothing";
}

TEST_F(Finished, to_explain_a_task_the_rows_of_its_job_are_read_once) {
  const TempFolder folder;
  JobDatabase database(folder.path() / "db");
  const JobId job = run_into_quarantine();
  const TaskId quarantined{status(job).quarantine(0).task()};
  ASSERT_EQ(let_go(), 1U);
  ChangeSet committed;
  committed.jobs.push_back(record_.state().jobs.at(job));
  committed.tasks.push_back(record_.state().tasks.at(quarantined));
  database.apply(committed);
  const JobHistory history = database.history();
  wire::Query query;
  query.set_subject(wire::Query::EXPLAIN);
  query.set_task(quarantined.value);
  const std::size_t before = times_read_;
  const wire::Explanation answer = answer_query(query, {*state_, history, now_}).explanation();
  EXPECT_THAT(answer.reasons(0), HasSubstr("signal 11"));
  EXPECT_EQ(answer.subdomain_state(), "leaf");
  ASSERT_GT(answer.inputs_size(), 0);
  EXPECT_NE(answer.inputs(0).made_by(), 0U) << "found among the other rows of the job";
  EXPECT_EQ(times_read_ - before, 1U);
}

TEST_F(Finished, figures_count_tasks_of_jobs_that_left_memory_once) {
  const JobId job = run_job(4, 0);
  const auto figures = [this] {
    return FarmMetrics(0).text(*state_, Refusals(), FarmSurroundings());
  };
  const std::string before = figures();
  ASSERT_THAT(before, HasSubstr("tetfarm_tasks{kind=\"mesh\",state=\"done\"} 3\n"));
  ASSERT_EQ(let_go(), 1U);
  EXPECT_EQ(figures(), before);
  files_.erase(finished_.jobs().at(job).results.front().hash);
  state_->submit(
      {record_.state().jobs.at(job).key, "wing", "toml", to_inspect(job_file_, surface_)}, now_);
  EXPECT_THAT(figures(), HasSubstr("tetfarm_tasks{kind=\"mesh\",state=\"done\"} 3\n"));
}

TEST_F(Finished, what_tasks_of_a_kind_took_is_known_after_a_restart) {
  submit();
  const SendAssign inspect = next(add_worker({.nonce = "one"}));
  TaskResult result = run_fake_task(task(inspect.task));
  for (const ArtifactRef& file : result.outputs) files_.insert(file.hash);
  result.seconds = 3;
  state_->done(WorkerId{1}, inspect.task, inspect.attempt, result, now_);
  state_->cancel(JobId{1}, now_);
  ASSERT_EQ(let_go(), 1U);
  restart();
  files_.insert(fake_job(2, 0).hash);
  state_->submit({"another", "duct", "toml", to_inspect(fake_job(2, 0), surface_)}, now_);
  commit();
  const TaskId other = state_->durable().tasks.begin()->first;
  EXPECT_EQ(state_->outlook(other, now_).expected_seconds, 3);
}

}  // namespace
}  // namespace tetfarm
