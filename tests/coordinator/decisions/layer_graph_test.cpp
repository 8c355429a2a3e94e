#include "coordinator/decisions/layer_graph.h"

#include <gmock/gmock.h>

#include "coordinator/decisions/task_graph.h"
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

TaskRow inspected_with(const std::vector<std::string>& more) {
  TaskRow inspect = inspected(2);
  for (const std::string& name : more) inspect.outputs.push_back(fake_file(name, name));
  return inspect;
}

std::optional<std::string> problem_of(const std::vector<std::string>& more) {
  const TaskRow task = inspected_with(more);
  TaskResult result;
  result.outputs = task.outputs;
  result.numbers = {{"parts", 2},      {"groups", 0},  {"total_work", 9},
                    {"most_bytes", 0}, {"needles", 0}, {"across_cuts", 0}};
  return problem_with(task, result);
}

TEST(LayerGraph, the_tree_begins_left_of_the_root_where_there_are_layers) {
  EXPECT_EQ(after_inspect(inspected(2)).subdomains.at(0).path, 1U);
  const GraphStep step = after_inspect(inspected_with({"layers:6", "layers:7", "layer_table"}));
  ASSERT_THAT(step.subdomains, SizeIs(1));
  EXPECT_EQ(step.subdomains[0].path, 2U);
  ASSERT_THAT(step.tasks, SizeIs(1));
  EXPECT_EQ(step.tasks[0].path, 2U);
}

TEST(LayerGraph, layers_have_a_table_and_places_right_of_the_root) {
  EXPECT_EQ(problem_of({}), std::nullopt);
  EXPECT_EQ(problem_of({"layers:3", "layer_table"}), std::nullopt);
  EXPECT_EQ(problem_of({"layers:12", "layers:13", "layers:7", "layer_table"}), std::nullopt);
  const char* no_table = "there are layers without a table, or a table without layers";
  EXPECT_EQ(problem_of({"layers:3"}), no_table);
  EXPECT_EQ(problem_of({"layer_table"}), no_table);
  const char* no_place = "a chunk of layers has a place that is no chunk's";
  for (const char* place : {"layers:1", "layers:2", "layers:5", "layers:11", "layers:16"}) {
    EXPECT_EQ(problem_of({"layers:6", place, "layer_table"}), no_place) << place;
  }
}

TEST(LayerGraph, the_numbering_is_given_the_table_of_the_layers) {
  const TaskRow inspect = inspected_with({"layers:3", "layer_table"});
  const NumberGiven given = given_to_number(inspect, nullptr, {});
  ASSERT_TRUE(given.layer_table.has_value());
  EXPECT_EQ(given.layer_table->hash, fake_file("layer_table", "layer_table").hash);
  EXPECT_FALSE(given_to_number(inspected(2), nullptr, {}).layer_table.has_value());
}

using LayeredJob = JobStateTest;

TEST_F(LayeredJob, grows_each_chunk_once_and_puts_all_together) {
  const JobId id = run_job(3, 0, 3);
  EXPECT_EQ(state_->durable().jobs.at(id).phase, JobPhase::done);
  EXPECT_EQ(worked_on(id, TaskKind::grow), 3U);
  std::vector<std::string> portions;
  for (const auto& [number, row] : state_->durable().tasks) {
    if (row.kind == TaskKind::grow) {
      EXPECT_THAT(names_of(row.inputs), ElementsAre("job", "surface", "numbering", "layers"));
    }
    if (row.kind != TaskKind::assemble) continue;
    for (const std::string& name : names_of(row.inputs)) {
      if (name.starts_with("portion:")) portions.push_back(name);
    }
  }
  EXPECT_THAT(portions, testing::IsSupersetOf({"portion:6", "portion:14", "portion:15"}));
  EXPECT_THAT(portions, SizeIs(3 + summary().leaves_made));
}

TEST_F(LayeredJob, ends_alike_when_the_coordinator_restarts_after_every_task) {
  const std::string expected = outcome_of(run_job(3, 0, 2));
  record_ = {};
  files_ = {job_file_.hash, surface_.hash};
  restart();
  worker_ = new_worker();
  const ArtifactRef file = fake_job(3, 0, 2);
  files_.insert(file.hash);
  const JobId id =
      state_->submit({file.hash, "wing", "toml", to_inspect(file, surface_), true}, now_).job;
  commit();
  for (SendAssign assign = next(worker_); assign.attempt; assign = next(worker_)) {
    ASSERT_TRUE(finish(worker_, assign));
    restart();
    worker_ = new_worker();
  }
  EXPECT_EQ(state_->durable().jobs.at(id).phase, JobPhase::done);
  EXPECT_EQ(outcome_of(id), expected);
}

TEST_F(LayeredJob, is_done_again_from_what_an_earlier_job_has_grown) {
  run_job(3, 0, 2);
  const ArtifactRef file = fake_job(3, 0, 2);
  const SubmitAnswer again =
      state_->submit({"again", "duct", "toml", to_inspect(file, surface_)}, now_);
  commit();
  run_all();
  EXPECT_EQ(state_->durable().jobs.at(again.job).phase, JobPhase::done);
  EXPECT_EQ(worked_on(again.job, TaskKind::grow), 0U);
}

}  // namespace
}  // namespace tetfarm
