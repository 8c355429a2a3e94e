#include "coordinator/decisions/job_status.h"

#include <gmock/gmock.h>

#include "coordinator/decisions/message_translation.h"
#include "coordinator/decisions/task_rows.h"
#include "tasks/ratio_histogram.h"
#include "tasks/solve_contract.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::Pair;

/// A job of which tasks and sub-domains are added, and what is seen of it.
class JobStatusTest : public testing::Test {
 protected:
  JobStatusTest() {
    JobRow& job = rows_.jobs[JobId{1}];
    job.id = JobId{1};
    job.name = "wing";
    job.created_ms = 2000;
  }
  JobRow& job() { return rows_.jobs.at(JobId{1}); }
  TaskRow& add(TaskKind kind, std::uint64_t path, TaskState state) {
    const TaskId id{rows_.tasks.size() + 1};
    TaskRow& task = rows_.tasks[id];
    task.id = id;
    task.job = JobId{1};
    task.kind = kind;
    task.path = path;
    task.state = state;
    return task;
  }
  SubdomainRow& add_node(std::uint64_t path, SubdomainState state, double work = 0,
                         std::uint64_t tets = 0) {
    SubdomainRow& node = rows_.subdomains[{JobId{1}, path}];
    node.job = JobId{1};
    node.path = path;
    node.state = state;
    node.work = work;
    node.tets = tets;
    node.meshed = tets > 0;
    return node;
  }
  JobSummary summary(const std::string& stuck = "") {
    return summary_of(rows_, job(), stuck, 9500);
  }

  DurableState rows_;
};

TEST_F(JobStatusTest, of_a_loop_tells_its_cycles_from_the_first_task_on) {
  SolveGiven given;
  given.job = given.mesh = {"h", 1};
  given.cycles = 7;
  TaskRow& solve = add(TaskKind::solve, 1, TaskState::ready);
  solve.parameters = new_task(JobId{1}, 1, given).parameters;
  EXPECT_EQ(summary().numbers["cycles"], 7);
}

TEST_F(JobStatusTest, has_the_time_from_its_submission_to_its_end_or_to_now) {
  EXPECT_EQ(summary().seconds, 7.5);
  EXPECT_EQ(summary().created_ms, 2000);
  EXPECT_EQ(summary().finished_ms, 0);
  job().finished_ms = 3250;
  job().phase = JobPhase::done;
  EXPECT_EQ(summary().seconds, 1.25);
  EXPECT_EQ(summary().finished_ms, 3250);
}

TEST_F(JobStatusTest, is_stuck_only_while_it_runs) {
  job().message = "its own";
  EXPECT_EQ(summary("no room").state, "stuck");
  EXPECT_EQ(summary("no room").message, "no room");
  EXPECT_EQ(summary().state, "running");
  EXPECT_EQ(summary().message, "its own");
  for (const JobPhase phase : {JobPhase::done, JobPhase::failed, JobPhase::cancelled}) {
    job().phase = phase;
    EXPECT_EQ(summary("no room").state, name_of(phase));
    EXPECT_EQ(summary("no room").message, "its own");
  }
}

TEST_F(JobStatusTest, counts_its_leaves_and_how_even_they_are) {
  EXPECT_FALSE(summary().numbers.contains("balance_estimated"));
  add_node(1, SubdomainState::cut, 900, 0).tets = 77;
  add_node(2, SubdomainState::leaf, 100, 120);
  add_node(6, SubdomainState::leaf, 300);
  add_node(7, SubdomainState::joined, 500);
  add_node(12, SubdomainState::open, 500);
  rows_.subdomains[{JobId{2}, 1}] = rows_.subdomains.at({JobId{1}, 2});
  JobSummary told = summary();
  EXPECT_EQ(told.leaves_made, 2U);
  EXPECT_EQ(told.leaves_meshed, 1U);
  EXPECT_EQ(told.elements, 120U);
  EXPECT_EQ(told.numbers.at("balance_estimated"), 1.5) << "300 of 200 on the mean";
  EXPECT_FALSE(told.numbers.contains("balance_elements")) << "not all are meshed";
  add_node(6, SubdomainState::leaf, 300, 480);
  told = summary();
  EXPECT_EQ(told.elements, 600U);
  EXPECT_EQ(told.numbers.at("balance_elements"), 1.6);
  add_node(2, SubdomainState::leaf, 0, 120);
  add_node(6, SubdomainState::leaf, 0, 480);
  EXPECT_EQ(summary().numbers.at("balance_estimated"), 1) << "nothing is even";
}

TEST_F(JobStatusTest, counts_its_tasks_and_what_went_wrong_with_them) {
  add(TaskKind::inspect, 0, TaskState::done).peak_rss_bytes = 700;
  add(TaskKind::decompose, 1, TaskState::done).crashes = 2;
  add(TaskKind::mesh, 2, TaskState::leased).losses = 3;
  add(TaskKind::mesh, 3, TaskState::ready).oom_count = 4;
  add(TaskKind::mesh, 4, TaskState::waiting).losses = 1;
  add(TaskKind::mesh, 5, TaskState::failed).peak_rss_bytes = 900;
  add(TaskKind::order, 0, TaskState::replaced).crashes = 1;
  const JobSummary told = summary();
  EXPECT_EQ(told.tasks_done, 2U);
  EXPECT_EQ(told.tasks_running, 1U);
  EXPECT_EQ(told.tasks_ready, 2U) << "what waits is still to come";
  ASSERT_EQ(told.quarantine.size(), 1U);
  EXPECT_EQ(told.quarantine[0].path, 5U);
  EXPECT_EQ(told.attempts_lost, 4U);
  EXPECT_EQ(told.crashes, 3U);
  EXPECT_EQ(told.oom_count, 4U);
  EXPECT_EQ(told.peak_rss_bytes_worker, 900U);
}

TEST_F(JobStatusTest, of_a_loop_is_at_its_solver_and_ends_with_its_results) {
  add(TaskKind::solve, 1, TaskState::done);
  EXPECT_EQ(summary().stage, "collect");
  add(TaskKind::adapt, 2, TaskState::ready);
  EXPECT_EQ(summary().stage, "adapt");
}

TEST_F(JobStatusTest, is_at_the_first_kind_of_task_that_is_not_done) {
  EXPECT_EQ(summary().stage, "assemble");
  add(TaskKind::inspect, 0, TaskState::done);
  add(TaskKind::decompose, 9, TaskState::replaced);
  add(TaskKind::cosmetic, 2, TaskState::done);
  add(TaskKind::cosmetic, 3, TaskState::done);
  EXPECT_EQ(summary().stage, "assemble");
  EXPECT_EQ(summary().leaves_mended, 2U);
  add(TaskKind::write, 2, TaskState::ready);
  EXPECT_EQ(summary().stage, "write");
  add(TaskKind::cosmetic, 4, TaskState::failed);
  EXPECT_EQ(summary().stage, "cosmetic");
  EXPECT_EQ(summary().leaves_mended, 2U);
  add(TaskKind::mesh, 4, TaskState::waiting);
  EXPECT_EQ(summary().stage, "mesh");
}

TEST_F(JobStatusTest, tells_what_the_inspection_expects) {
  TaskRow& inspect = add(TaskKind::inspect, 0, TaskState::done);
  inspect.numbers = {{"total_work", 1000},
                     {"parts", 8},
                     {"forecast_bytes", 5},
                     {"forecast_disk_bytes", 6},
                     {"forecast_seconds", 7}};
  JobSummary told = summary();
  EXPECT_EQ(told.estimated_elements, 1000);
  EXPECT_EQ(told.numbers.at("parts"), 8);
  EXPECT_EQ(told.numbers.at("forecast_bytes"), 5);
  EXPECT_EQ(told.numbers.at("forecast_disk_bytes"), 6);
  EXPECT_EQ(told.numbers.at("forecast_seconds"), 7);
  inspect.numbers = {{"total_work", 1000}, {"estimated_elements", 1100}};
  told = summary();
  EXPECT_EQ(told.estimated_elements, 1100);
  EXPECT_FALSE(told.numbers.contains("parts"));
  EXPECT_FALSE(told.numbers.contains("forecast_bytes"));
}

TEST_F(JobStatusTest, adds_up_what_tasks_of_a_kind_took_and_has_the_largest_memory) {
  const auto cost = [this](std::uint64_t path, TaskState state, double seconds, std::uint64_t bytes,
                           double expected_bytes) {
    TaskRow& task = add(TaskKind::mesh, path, state);
    task.seconds = seconds;
    task.peak_rss_bytes = bytes;
    task.numbers = {{"cpu_seconds", seconds / 2},
                    {"expected_seconds", 2 * seconds},
                    {"expected_bytes", expected_bytes}};
  };
  cost(2, TaskState::done, 3, 600, 1000);
  cost(3, TaskState::done, 5, 500, 625);
  cost(4, TaskState::leased, 100, 10'000, 1);
  add(TaskKind::write, 2, TaskState::done).seconds = 1;
  std::map<std::string, double> of_mesh;
  for (const auto& [name, number] : summary().numbers) {
    if (name.starts_with("task_mesh")) of_mesh[name] = number;
  }
  EXPECT_THAT(of_mesh,
              ElementsAre(Pair("task_mesh_bytes", 600), Pair("task_mesh_count", 2),
                          Pair("task_mesh_cpu_seconds", 4), Pair("task_mesh_expected_bytes", 1000),
                          Pair("task_mesh_expected_seconds", 16),
                          Pair("task_mesh_of_expected_bytes", 0.8), Pair("task_mesh_seconds", 8)));
  EXPECT_EQ(summary().numbers.at("task_write_count"), 1);
  EXPECT_FALSE(summary().numbers.contains("task_write_of_expected_bytes"))
      << "nothing was expected";
}

TEST_F(JobStatusTest, has_the_worst_unforced_angle_of_all_leaves_and_where_it_is) {
  const auto write = [this](std::uint64_t path, double elements, double angle) {
    TaskRow& task = add(TaskKind::write, path, TaskState::done);
    task.numbers = {{"unforced_elements", elements},
                    {"unforced_worst_x", 10 * angle},
                    {"unforced_worst_y", 11 * angle},
                    {"unforced_worst_z", 12 * angle}};
    if (angle > 0) task.numbers["unforced_min_dihedral_deg"] = angle;
  };
  write(2, 100, 20);
  write(3, 50, 5);
  write(4, 30, 9);
  write(5, 0, 0);
  add(TaskKind::write, 6, TaskState::leased).numbers = {{"unforced_elements", 1000}};
  const auto numbers = summary().numbers;
  EXPECT_EQ(numbers.at("unforced_elements"), 180);
  EXPECT_EQ(numbers.at("unforced_min_dihedral_deg"), 5);
  EXPECT_EQ(numbers.at("unforced_worst_x"), 50);
  EXPECT_EQ(numbers.at("unforced_worst_y"), 55);
  EXPECT_EQ(numbers.at("unforced_worst_z"), 60);
}

TEST_F(JobStatusTest, has_the_least_jacobian_of_all_chunks_of_layers) {
  const auto grow = [this](std::uint64_t path, TaskState state, double jacobian) {
    add(TaskKind::grow, path, state).numbers = {{"prisms", 10}, {"min_scaled_jacobian", jacobian}};
  };
  EXPECT_FALSE(summary().numbers.contains("layers_min_scaled_jacobian"));
  grow(12, TaskState::done, 0.75);
  grow(13, TaskState::done, 0.25);
  grow(14, TaskState::done, 0.5);
  grow(15, TaskState::leased, 0.125);
  add(TaskKind::grow, 16, TaskState::done).numbers = {{"tets", 10}};
  EXPECT_EQ(summary().numbers.at("layers_min_scaled_jacobian"), 0.25);
}

TEST_F(JobStatusTest, has_quantiles_of_the_shapes_that_all_tasks_of_layers_have_told) {
  RatioHistogram jumps;
  for (const double jump : {0.5, 1.0, 2.0, 4.0}) jumps.add(jump);
  RatioHistogram more;
  for (int i = 0; i < 6; ++i) more.add(8);
  EXPECT_FALSE(summary().numbers.contains("layers_top_jump_median"));
  add(TaskKind::write, 4, TaskState::done).texts = {{"top_jumps", jumps.text()}};
  EXPECT_NEAR(summary().numbers.at("layers_top_jump_median"), 1, 0.01);
  add(TaskKind::write, 5, TaskState::done).texts = {{"top_jumps", more.text()}};
  add(TaskKind::write, 6, TaskState::leased).texts = {{"top_jumps", "-1385 1000"}};
  add(TaskKind::write, 7, TaskState::done).texts = {{"top_jumps", "of an older version"}};
  EXPECT_NEAR(summary().numbers.at("layers_top_jump_median"), 8, 0.05);
  EXPECT_FALSE(summary().numbers.contains("layers_scaled_jacobian_median"));
  RatioHistogram jacobians;
  for (int i = 0; i < 99; ++i) jacobians.add(1);
  jacobians.add(0.5);
  add(TaskKind::grow, 12, TaskState::done).texts = {{"scaled_jacobians", jacobians.text()}};
  EXPECT_EQ(summary().numbers.at("layers_scaled_jacobian_median"), 1) << "and no more";
  EXPECT_NEAR(summary().numbers.at("layers_scaled_jacobian_1_percent"), 0.5, 0.002);
}

TEST_F(JobStatusTest, has_the_figures_of_assimilation_and_of_the_mesh_once_they_are_there) {
  TaskRow& assimilate = add(TaskKind::assimilate, 0, TaskState::ready);
  assimilate.numbers = {{"groups", 4}};
  TaskRow& assemble = add(TaskKind::assemble, 0, TaskState::ready);
  assemble.numbers = {{"elements", 640}, {"volume", 2}};
  assemble.texts = {{"digest", "abc"}};
  assemble.outputs = {{"wing.vtkhdf", "hash", 9}};
  add_node(1, SubdomainState::leaf, 1, 600);
  JobSummary told = summary();
  EXPECT_FALSE(told.numbers.contains("assimilated_groups"));
  EXPECT_FALSE(told.numbers.contains("volume"));
  EXPECT_TRUE(told.files.empty());
  assimilate.state = TaskState::done;
  assemble.state = TaskState::done;
  told = summary();
  EXPECT_EQ(told.numbers.at("assimilated_groups"), 4);
  EXPECT_EQ(told.numbers.at("volume"), 2);
  EXPECT_EQ(told.texts.at("digest"), "abc");
  EXPECT_EQ(told.elements, 600U) << "the job is not done yet";
  EXPECT_TRUE(told.files.empty());
  job().phase = JobPhase::done;
  told = summary();
  EXPECT_EQ(told.elements, 640U);
  ASSERT_EQ(told.files.size(), 1U);
  EXPECT_EQ(told.files[0].name, "wing.vtkhdf");
}

TEST_F(JobStatusTest, of_a_failed_job_has_the_evidence_and_no_other_files) {
  add(TaskKind::inspect, 0, TaskState::done).outputs = {{"surface", "s", 1}};
  add(TaskKind::mesh, 2, TaskState::failed).outputs = {{"a.vtp", "a", 1}, {"a.off", "b", 2}};
  add(TaskKind::mesh, 3, TaskState::failed).outputs = {{"c.vtp", "c", 3}};
  job().phase = JobPhase::failed;
  job().exit_code = 3;
  const JobSummary told = summary();
  EXPECT_EQ(told.exit_code, 3);
  std::vector<std::string> names;
  for (const ArtifactRef& file : told.files) names.push_back(file.name);
  EXPECT_THAT(names, ElementsAre("a.vtp", "a.off", "c.vtp"));
}

TEST_F(JobStatusTest, says_why_sub_domains_stayed_whole_or_were_cut_further) {
  TaskRow& whole = add(TaskKind::decompose, 5, TaskState::done);
  whole.texts = {{"reason", "no valid plane"}};
  TaskRow& cut = add(TaskKind::decompose, 2, TaskState::done);
  cut.texts = {{"reason", "not asked for"}};
  cut.outputs = {{"left", "l", 1}, {"right", "r", 1}};
  add(TaskKind::decompose, 3, TaskState::ready).texts = {{"reason", "of before"}};
  add_node(6, SubdomainState::cut);
  add(TaskKind::mesh, 6, TaskState::replaced).message = "out of memory";
  add_node(7, SubdomainState::leaf);
  add(TaskKind::mesh, 7, TaskState::replaced).message = "not cut after all";
  add(TaskKind::order, 0, TaskState::replaced).message = "6 was cut";
  const JobSummary told = summary();
  EXPECT_THAT(told.texts, ElementsAre(Pair("cut_further:6", "out of memory"),
                                      Pair("uncut:5", "no valid plane")));
  EXPECT_EQ(told.numbers.at("uncut"), 1);
  EXPECT_EQ(told.numbers.at("cut_further"), 1);
}

TEST_F(JobStatusTest, names_no_more_than_people_read) {
  for (std::uint64_t i = 0; i < 1001; ++i) {
    add(TaskKind::decompose, i + 1, TaskState::done).texts = {{"reason", "none"}};
    add(TaskKind::mesh, i + 1, TaskState::failed);
  }
  const JobSummary told = summary();
  EXPECT_EQ(told.numbers.at("uncut"), 1001);
  EXPECT_EQ(told.texts.size(), 1000U);
  EXPECT_EQ(told.quarantine.size(), 100U);
  EXPECT_EQ(told.quarantine.back().path, 100U) << "the first ones";
}

TEST_F(JobStatusTest, has_its_own_tasks_alone) {
  add(TaskKind::inspect, 0, TaskState::done);
  TaskRow& other = add(TaskKind::inspect, 0, TaskState::done);
  other.job = JobId{2};
  EXPECT_EQ(summary().tasks_done, 1U);
  const TasksOfJobs tasks = tasks_of_jobs(rows_);
  ASSERT_EQ(tasks.size(), 2U);
  EXPECT_EQ(tasks.at(JobId{2}), std::vector<const TaskRow*>{&other});
}

}  // namespace
}  // namespace tetfarm
