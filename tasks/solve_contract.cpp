#include "tasks/solve_contract.h"

#include "tasks/kind_contracts.h"
#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits solve_traits = {
    .name = "solve",
    .on_wire = 12,
    .colour = "#1f78b4",
    .trace_colour = "thread_state_running",
    .outputs = {"solution", "log"},
    .seconds = {.of = {60, 0, 0, 0}},
    .memory = {.fixed = 256e6},
    .is_of_others = true,
    .is_of_cycle = true,
    .begins_job = true,
};

constinit const KindContracts solve_contracts = contracts_between<SolveGiven, SolveMade>;

void SolveGiven::describe(ContractFields& fields) {
  fields.file("job", job);
  fields.file("mesh", mesh);
  fields.file("start", start);
  fields.file("file_names", file_names);
  fields.files("file:", files);
  fields.files("spline:", splines);
  fields.count("cycle", cycle, most_parts);
  fields.count("cycles", cycles, most_parts);
}

void SolveMade::describe(ContractFields& fields) {
  fields.file("solution", solution);
  fields.file("log", log);
  fields.files("kept:", kept);
}

}  // namespace tetfarm
