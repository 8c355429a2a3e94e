// Leaves that are out of memory on every worker are cut once more.
#include "tasks/failure_cause.h"
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::Contains;
using testing::HasSubstr;

class FurtherCuts : public JobStateTest {
 protected:
  static constexpr std::uint64_t gib = std::uint64_t{1} << 30U;

  /// All that the worker has was not enough.
  void starve(const SendAssign& assign) {
    TaskFailure failure;
    failure.message = "out of memory";
    failure.cause = FailureCause::out_of_memory;
    failure.peak_rss_bytes = 2 * gib;
    fail(worker_, assign, failure);
  }
  JobId begin(std::uint64_t parts, std::uint64_t groups = 0) {
    const ArtifactRef file = fake_job(parts, groups);
    files_.insert(file.hash);
    const SubmitAnswer submitted =
        state_->submit({file.hash, "wing", "toml", to_inspect(file, surface_)}, now_);
    commit();
    worker_ = add_worker({.memory_bytes = 2 * gib, .shares_memory = false});
    return submitted.job;
  }
  /// Everything is done but for what `is_too_large`, which is out of memory each time.
  template <class Condition>
  void run_but(const Condition& is_too_large) {
    for (int idle = 0; idle < 20;) {
      now_.steady_ms += 1000;
      if (!state_->knows_worker(worker_)) {
        worker_ = add_worker({.memory_bytes = 2 * gib, .shares_memory = false});
      }
      const SendAssign assign = next(worker_);
      if (!assign.attempt) {
        ++idle;
        continue;
      }
      idle = 0;
      if (is_too_large(task(assign.task))) {
        starve(assign);
      } else {
        ASSERT_TRUE(finish(worker_, assign));
      }
      if (!restarts_) continue;
      restart();
      now_.steady_ms += rules_.lease_ms;  // in which all workers have come back
    }
  }
  SubdomainState node(JobId job, std::uint64_t path) const {
    return state_->durable().subdomains.at({job, path}).state;
  }
  const TaskRow* in_place(JobId job, TaskKind kind, std::uint64_t path) const {
    for (const auto& [id, row] : state_->durable().tasks) {
      const bool is_it = row.job == job && row.kind == kind && row.path == path &&
                         row.state != TaskState::replaced;
      if (is_it) return &row;
    }
    return nullptr;
  }
  /// What is left of a job, replaced tasks left out.
  std::string rest_of(JobId job) const {
    std::set<std::string> lines;
    for (const auto& [id, row] : state_->durable().tasks) {
      if (row.job != job || row.state == TaskState::replaced) continue;
      std::string line = std::string(name_of(row.kind)) + " " + std::to_string(row.path);
      for (const ArtifactRef& file : row.outputs) line += " " + file.name + "=" + file.hash;
      lines.insert(line);
    }
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
  }
  bool restarts_ = false;  ///< after every step
  JobSummary summary_of_job(JobId id) const {
    return summary_of(state_->durable(), state_->durable().jobs.at(id), "", now_.wall_ms);
  }
};

/// A leaf of a job of 6 parts that can be cut twice, in the make-believe world.
constexpr std::uint64_t giant = 4;

bool is_mesh_of(const TaskRow& task, std::uint64_t path) {
  return task.kind == TaskKind::mesh && task.path == path;
}

TEST_F(FurtherCuts, a_leaf_that_no_worker_can_mesh_is_cut_once_more_and_the_job_goes_on) {
  const JobId job = begin(6);
  run_but([](const TaskRow& row) { return is_mesh_of(row, giant); });
  EXPECT_EQ(state_->durable().jobs.at(job).phase, JobPhase::done);
  EXPECT_EQ(node(job, giant), SubdomainState::cut);
  EXPECT_EQ(node(job, 2 * giant), SubdomainState::leaf);
  EXPECT_EQ(in_place(job, TaskKind::mesh, giant), nullptr);
  ASSERT_NE(in_place(job, TaskKind::number, 0), nullptr);
  EXPECT_THAT(in_place(job, TaskKind::number, 0)->parameters.at("table"), HasSubstr("\ncut 4 "));
  const JobSummary summary = summary_of_job(job);
  EXPECT_EQ(summary.numbers.at("cut_further"), 1);
  EXPECT_EQ(
      summary.texts.at("cut_further:4"),
      "mesh of sub-domain LL ran out of memory with 2048 MiB, all that the largest worker has");
}

TEST_F(FurtherCuts, the_same_tree_ends_in_the_same_files_however_it_came_about) {
  const JobId late = begin(6);
  run_but([](const TaskRow& row) { return row.kind == TaskKind::cosmetic && row.path == giant; });
  const std::string of_late = rest_of(late);
  ASSERT_EQ(node(late, giant), SubdomainState::cut);
  record_ = {};
  restart();
  const JobId early = begin(6);
  run_but([](const TaskRow& row) { return is_mesh_of(row, giant); });
  EXPECT_EQ(rest_of(early), of_late);
}

TEST_F(FurtherCuts, the_order_of_turns_is_found_anew_when_the_tree_has_grown) {
  const JobId job = begin(6);
  run_but([](const TaskRow& row) { return row.kind == TaskKind::extract && row.path == giant; });
  std::vector<std::string> leaves;
  for (const ArtifactRef& input : in_place(job, TaskKind::order, 0)->inputs) {
    leaves.push_back(input.name);
  }
  EXPECT_THAT(leaves, Contains("subdomain:8"));
  EXPECT_THAT(leaves, testing::Not(Contains("subdomain:4")));
  EXPECT_EQ(tasks(job, TaskKind::order), 2U) << "the one that was replaced stays for people";
}

TEST_F(FurtherCuts, restarts_after_every_step_change_nothing) {
  const auto is_too_large = [](const TaskRow& row) {
    return row.path == 10 && (row.kind == TaskKind::mesh || row.kind == TaskKind::extract);
  };
  const JobId whole = begin(6, 3);
  run_but(is_too_large);
  const std::string expected = rest_of(whole);
  ASSERT_EQ(node(whole, 10), SubdomainState::cut);
  ASSERT_EQ(node(whole, 11), SubdomainState::joined) << "others were assimilated";
  record_ = {};
  restart();
  restarts_ = true;
  const JobId interrupted = begin(6, 3);
  run_but(is_too_large);
  EXPECT_EQ(rest_of(interrupted), expected);
}

TEST_F(FurtherCuts, a_leaf_is_cut_so_often_and_then_in_quarantine_with_the_reason) {
  rules_.max_further_cuts = 1;
  restart();
  const JobId job = begin(6);
  run_but([](const TaskRow& row) {
    return row.kind == TaskKind::mesh && (row.path == giant || row.path == 2 * giant);
  });
  EXPECT_EQ(state_->durable().jobs.at(job).phase, JobPhase::failed);
  EXPECT_EQ(state_->durable().jobs.at(job).exit_code, 6);
  EXPECT_THAT(state_->durable().jobs.at(job).message,
              HasSubstr("it was already cut further 1 time"));
  EXPECT_EQ(node(job, 2 * giant), SubdomainState::leaf);
}

TEST_F(FurtherCuts, what_cannot_be_cut_is_tried_once_more_and_then_in_quarantine) {
  const JobId job = begin(6);
  int meshes = 0;
  for (int idle = 0; idle < 20; ++idle) {
    now_.steady_ms += 1000;
    if (!state_->knows_worker(worker_)) {
      worker_ = add_worker({.memory_bytes = 2 * gib, .shares_memory = false});
    }
    const SendAssign assign = next(worker_);
    if (!assign.attempt) continue;
    idle = 0;
    const TaskRow& row = task(assign.task);
    if (is_mesh_of(row, giant)) {
      ++meshes;
      starve(assign);
    } else if (row.kind == TaskKind::decompose && row.path == giant) {
      TaskResult whole;
      whole.texts["reason"] = "no valid plane";
      state_->done(worker_, assign.task, assign.attempt, whole, now_);
      EXPECT_TRUE(answer());
    } else {
      ASSERT_TRUE(finish(worker_, assign));
    }
  }
  EXPECT_EQ(meshes, 2);
  EXPECT_THAT(state_->durable().jobs.at(job).message, HasSubstr("its sub-domain cannot be cut"));
  EXPECT_EQ(node(job, giant), SubdomainState::leaf);
  EXPECT_FALSE(summary_of_job(job).numbers.contains("cut_further")) << "it was not";
}

TEST_F(FurtherCuts, the_first_worker_after_a_restart_does_not_count_as_the_largest) {
  const JobId job = begin(6);
  run_until_meshes();
  TaskFailure handed_back;
  handed_back.cause = FailureCause::killed;
  fail(worker_, held_, handed_back);
  restart();
  const std::int64_t restarted_ms = now_.steady_ms;
  worker_ = add_worker({.memory_bytes = gib, .shares_memory = false});
  SendAssign assign = next(worker_);
  while (assign.attempt && !is_mesh_of(task(assign.task), giant)) {
    ASSERT_TRUE(finish(worker_, assign));
    assign = next(worker_);
  }
  ASSERT_TRUE(assign.attempt);
  const TaskId mesh = assign.task;
  starve(assign);
  EXPECT_EQ(in_place(job, TaskKind::decompose, giant), nullptr);
  worker_ = add_worker({.memory_bytes = 2 * gib, .shares_memory = false});
  for (assign = {}; assign.task != mesh; assign = next(worker_)) {
    if (assign.attempt) {
      ASSERT_TRUE(finish(worker_, assign));
    }
    ASSERT_LT(now_.steady_ms, restarted_ms + 2 * rules_.lease_ms) << "it is not tried again";
    wait(1000);
  }
  const AttemptId again = task(mesh).attempt;
  EXPECT_EQ(state_->durable().running_attempts.at(again).memory_bytes, 2 * gib);
}

TEST_F(FurtherCuts, explain_says_why_there_is_a_cut_that_was_not_planned) {
  const JobId job = begin(6);
  run_until_meshes();
  while (held_.attempt && task(held_.task).path != giant) {
    ASSERT_TRUE(finish(worker_, held_));
    held_ = next(worker_);
  }
  const TaskId mesh = held_.task;
  starve(held_);
  const TaskRow* cut = in_place(job, TaskKind::decompose, giant);
  ASSERT_NE(cut, nullptr);
  EXPECT_THAT(state_->outlook(cut->id, now_).reasons.back(),
              HasSubstr("it cuts further than planned: mesh of sub-domain LL ran out of memory"));
  EXPECT_THAT(state_->outlook(mesh, now_).reasons,
              Contains(HasSubstr("no longer part of the job")));
}

}  // namespace
}  // namespace tetfarm
