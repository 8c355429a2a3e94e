// A coordinator's decisions, one event at a time, with a record in place of the database.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <string>

#include "coordinator/decisions/job_state.h"
#include "coordinator/decisions/job_status.h"
#include "tasks/failure_cause.h"
#include "tests/coordinator/durable_record.h"
#include "tests/coordinator/fake_task.h"

namespace tetfarm {

/// A coordinator's decisions with files in a set; runs one task at a time.
class JobStateTest : public testing::Test {
 protected:
  JobStateTest() {
    files_ = {job_file_.hash, surface_.hash};
    restart();
  }

  void restart() {
    state_ = std::make_unique<JobState>(
        record_.state(), rules_,
        [this](const ArtifactRef& file) { return files_.contains(file.hash); }, now_);
  }
  void commit() {
    state_->tick(now_);
    EXPECT_THAT(state_->validate(), testing::IsEmpty());
    record_.apply(state_->take_changes());
  }
  void wait(std::int64_t ms) {
    now_.steady_ms += ms;
    for (const WorkerId worker : {worker_}) {
      if (state_->knows_worker(worker)) state_->heartbeat(worker, {}, {}, now_);
    }
  }
  SubmitAnswer submit(const std::string& key = "key") {
    return state_->submit({key, "wing", "toml", to_inspect(job_file_, surface_)}, now_);
  }
  WorkerId new_worker() { return add_worker({}); }
  WorkerId add_worker(WorkerInfo info) {
    if (info.host.empty()) info.host = "host";
    return state_->add_worker(info, {}, {}, now_);
  }
  /// Brings the job to where its leaves can be meshed: no cut is left, and no order is found yet.
  void run_until_meshes() {
    for (SendAssign assign = next(worker_); assign.attempt; assign = next(worker_)) {
      if (task(assign.task).kind == TaskKind::mesh) {
        held_ = assign;
        return;
      }
      ASSERT_TRUE(finish(worker_, assign));
      now_.steady_ms += 100;
    }
    FAIL() << "there is no mesh task";
  }

  /// What is handed to the worker when it says Ready now; attempt 0: nothing.
  SendAssign next(WorkerId worker) {
    state_->worker_is_ready(worker, now_);
    state_->tick(now_);
    SendAssign assign;
    for (const Command& command : state_->take_commands()) {
      if (const auto* found = std::get_if<SendAssign>(&command)) assign = *found;
    }
    commit();
    return assign;
  }
  bool finish(WorkerId worker, const SendAssign& assign) {
    const TaskResult result = run_fake_task(task(assign.task));
    for (const ArtifactRef& file : result.outputs) files_.insert(file.hash);
    state_->done(worker, assign.task, assign.attempt, result, now_);
    return answer();
  }
  /// Submits the job of so many parts, groups and chunks of layers, as `run` does, and brings it to
  /// its end.
  JobId run_job(std::uint64_t parts, std::uint64_t groups, std::uint64_t chunks = 0) {
    const ArtifactRef file = fake_job(parts, groups, chunks);
    files_.insert(file.hash);
    const SubmitAnswer submitted =
        state_->submit({file.hash, "wing", "toml", to_inspect(file, surface_), true}, now_);
    commit();
    if (!worker_) worker_ = new_worker();
    run_all();
    return submitted.job;
  }
  /// How many tasks of a kind were handed to a worker for this job.
  std::size_t worked_on(JobId job, TaskKind kind) const {
    std::size_t count = 0;
    for (const auto& [id, attempt] : record_.attempts()) {
      const TaskRow& row = record_.state().tasks.at(attempt.task);
      if (row.job == job && row.kind == kind) ++count;
    }
    return count;
  }
  std::size_t tasks(JobId job, TaskKind kind) const {
    std::size_t count = 0;
    for (const auto& [id, row] : state_->durable().tasks) {
      if (row.job == job && row.kind == kind) ++count;
    }
    return count;
  }
  /// Every file and number of a job, for comparison with another run of it.
  std::string outcome_of(JobId job) const {
    std::set<std::string> lines;
    for (const auto& [id, row] : state_->durable().tasks) {
      if (row.job != job) continue;
      std::string line = std::string(name_of(row.kind)) + " " + std::to_string(row.path);
      for (const ArtifactRef& file : row.outputs) line += " " + file.name + "=" + file.hash;
      lines.insert(line);
    }
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
  }
  bool fail(WorkerId worker, const SendAssign& assign, const TaskFailure& failure) {
    state_->failed(worker, assign.task, assign.attempt, failure, now_);
    return answer();
  }
  bool answer() {
    bool taken = false;
    for (const Command& command : state_->take_commands()) {
      if (const auto* found = std::get_if<SendAccepted>(&command)) taken |= found->taken;
    }
    commit();
    return taken;
  }
  void run_all() {
    for (SendAssign assign = next(worker_); assign.attempt; assign = next(worker_)) {
      ASSERT_TRUE(finish(worker_, assign));
      now_.steady_ms += 100;
    }
  }
  const TaskRow& task(TaskId id) const { return state_->durable().tasks.at(id); }
  const JobRow& job() const { return state_->durable().jobs.at(JobId{1}); }
  JobSummary summary() const {
    return summary_of(state_->durable(), job(), state_->stuck_message(), now_.wall_ms);
  }

  FarmRules rules_;
  Moment now_{1000000, 5};
  DurableRecord record_;
  ArtifactRef job_file_ = fake_file("job", "toml");
  ArtifactRef surface_ = fake_file("input_surface", "flange");
  std::set<std::string> files_;
  std::unique_ptr<JobState> state_;
  WorkerId worker_;
  SendAssign held_;
};

inline TaskFailure crash() {
  TaskFailure failure;
  failure.message = "signal 11";
  failure.cause = FailureCause::error;
  return failure;
}

}  // namespace tetfarm
