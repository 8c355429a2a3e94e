#include "tasks/adapt_contract.h"

#include "tasks/kind_contracts.h"
#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits adapt_traits = {
    .name = "adapt",
    .on_wire = 13,
    .colour = "#33a02c",
    .trace_colour = "thread_state_runnable",
    .outputs = {"mesh", "start", "figures"},
    .seconds = {.of = {0.5, 0, 0, 0}},
    .memory = {.fixed = 32e6, .of_input_byte = 20},
    .is_of_cycle = true,
};

constinit const KindContracts adapt_contracts = contracts_between<AdaptGiven, AdaptMade>;

void AdaptGiven::describe(ContractFields& fields) {
  fields.file("job", job);
  fields.file("mesh", mesh);
  fields.file("solution", solution);
  fields.files("spline:", splines);
  fields.count("cycle", cycle, most_parts);
}

void AdaptMade::describe(ContractFields& fields) {
  fields.file("mesh", mesh);
  fields.file("start", start);
  fields.file("figures", figures);
}

}  // namespace tetfarm
