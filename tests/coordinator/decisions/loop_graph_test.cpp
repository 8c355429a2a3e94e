#include "coordinator/decisions/loop_graph.h"

#include <gmock/gmock.h>

#include "coordinator/decisions/task_rows.h"
#include "tasks/adapt_contract.h"
#include "tasks/collect_contract.h"
#include "tests/coordinator/decisions/job_state_fixture.h"

namespace tetfarm {
namespace {

TaskFile named(const std::string& name) { return {name, name.size()}; }

ArtifactRef made(const std::string& name, const std::string& hash) {
  return {name, hash, hash.size()};
}

TaskRow solved(std::uint64_t cycle, std::uint64_t cycles) {
  SolveGiven given;
  given.job = named("job");
  given.mesh = named("mesh" + std::to_string(cycle));
  given.file_names = named("names");
  given.files = {{1, named("run.sh")}};
  given.splines = {{1, named("profile")}};
  given.cycle = cycle;
  given.cycles = cycles;
  TaskRow task = new_task(JobId{1}, cycle, given);
  task.memory_bytes = 77;
  task.outputs = {made("solution", "u" + std::to_string(cycle)),
                  made("log", "log" + std::to_string(cycle)), made("kept:2", "cp")};
  return task;
}

TaskRow adapted(std::uint64_t cycle) {
  AdaptGiven given;
  given.cycle = cycle;
  given.job = given.mesh = given.solution = named("x");
  TaskRow task = new_task(JobId{1}, cycle, given);
  task.outputs = {made("mesh", "mesh" + std::to_string(cycle)), made("start", "start"),
                  made("figures", "figures" + std::to_string(cycle))};
  return task;
}

const TaskRow* nobody(TaskKind, std::uint64_t) { return nullptr; }

TEST(LoopGraph, a_solution_is_adapted_to_until_the_last_cycle) {
  const TaskRow adapt = after_solve(solved(1, 2), nobody);
  EXPECT_EQ(adapt.path, 2U) << "the cycle whose mesh it makes";
  const auto given = given_to<AdaptGiven>(adapt);
  EXPECT_EQ(given.cycle, 2U);
  EXPECT_EQ(given.mesh, named("mesh1"));
  EXPECT_EQ(given.solution, named("u1"));
  EXPECT_EQ(given.job, named("job"));
  EXPECT_EQ(given.splines, (LeafFiles{{1, named("profile")}}));
}

TEST(LoopGraph, the_solver_goes_on_from_the_solution_on_the_new_mesh_with_the_same_files) {
  const TaskRow solve = after_adapt(adapted(2), solved(1, 3));
  EXPECT_EQ(solve.path, 2U);
  EXPECT_EQ(solve.memory_bytes, 77U) << "the room that its job asks for";
  const auto given = given_to<SolveGiven>(solve);
  EXPECT_EQ(given.cycle, 2U);
  EXPECT_EQ(given.cycles, 3U);
  EXPECT_EQ(given.mesh, named("mesh2"));
  EXPECT_EQ(given.start, named("start"));
  EXPECT_EQ(given.file_names, named("names"));
  EXPECT_EQ(given.files, (LeafFiles{{1, named("run.sh")}}));
  EXPECT_EQ(given.splines, (LeafFiles{{1, named("profile")}}));
}

TEST(LoopGraph, the_end_has_the_files_of_all_cycles) {
  const TaskRow first = solved(1, 2);
  const TaskRow last = solved(2, 2);
  const TaskRow between = adapted(2);
  const TaskRow collect = after_solve(last, [&](TaskKind kind, std::uint64_t cycle) {
    return kind == TaskKind::adapt ? &between : cycle == 1 ? &first : &last;
  });
  EXPECT_EQ(collect.path, 0U);
  const auto given = given_to<CollectGiven>(collect);
  EXPECT_EQ(given.meshes, (LeafFiles{{1, named("mesh1")}, {2, named("mesh2")}}));
  EXPECT_EQ(given.solutions, (LeafFiles{{1, named("u1")}, {2, named("u2")}}));
  EXPECT_EQ(given.logs, (LeafFiles{{1, named("log1")}, {2, named("log2")}}));
  EXPECT_EQ(given.figures, (LeafFiles{{2, named("figures2")}}));
  EXPECT_EQ(given.kept, (LeafFiles{{1002, named("cp")}, {2002, named("cp")}}));
}

}  // namespace
}  // namespace tetfarm
