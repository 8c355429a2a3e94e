#include "coordinator/decisions/loop_graph.h"

#include "base/check.h"
#include "coordinator/decisions/task_rows.h"
#include "tasks/adapt_contract.h"
#include "tasks/collect_contract.h"

namespace tetfarm {
namespace {

TaskRow adapt_task(const TaskRow& solve, const SolveGiven& given) {
  AdaptGiven adapt;
  adapt.job = given.job;
  adapt.mesh = given.mesh;
  adapt.solution = made_by<SolveMade>(solve).solution;
  adapt.splines = given.splines;
  adapt.cycle = given.cycle + 1;
  return new_task(solve.job, adapt.cycle, adapt);
}

void add_cycle(std::uint64_t cycle, const TaskRow& solve, CollectGiven& collect) {
  const auto made = made_by<SolveMade>(solve);
  collect.meshes[cycle] = given_to<SolveGiven>(solve).mesh;
  collect.solutions[cycle] = made.solution;
  collect.logs[cycle] = made.log;
  for (const auto& [place, file] : made.kept) {
    collect.kept[cycle * kept_of_cycle + place] = file;
  }
}

TaskRow collect_task(const TaskRow& last, const FindOfCycle& find) {
  const auto given = given_to<SolveGiven>(last);
  CollectGiven collect;
  collect.job = given.job;
  for (std::uint64_t cycle = 1; cycle <= given.cycles; ++cycle) {
    const TaskRow* solve = find(TaskKind::solve, cycle);
    TF_CHECK(solve != nullptr);
    add_cycle(cycle, *solve, collect);
    if (cycle == 1) continue;
    const TaskRow* adapt = find(TaskKind::adapt, cycle);
    TF_CHECK(adapt != nullptr);
    collect.figures[cycle] = made_by<AdaptMade>(*adapt).figures;
  }
  return new_task(last.job, 0, collect);
}

}  // namespace

TaskRow after_solve(const TaskRow& solve, const FindOfCycle& find) {
  const auto given = given_to<SolveGiven>(solve);
  return given.cycle < given.cycles ? adapt_task(solve, given) : collect_task(solve, find);
}

TaskRow after_adapt(const TaskRow& adapt, const TaskRow& solve) {
  const auto made = made_by<AdaptMade>(adapt);
  SolveGiven next = given_to<SolveGiven>(solve);
  next.cycle = given_to<AdaptGiven>(adapt).cycle;
  TF_CHECK(next.cycle <= next.cycles);
  next.mesh = made.mesh;
  next.start = made.start;
  TaskRow task = new_task(adapt.job, next.cycle, next);
  task.memory_bytes = solve.memory_bytes;
  return task;
}

}  // namespace tetfarm
