#include "tasks/collect_contract.h"

#include "tasks/kind_contracts.h"
#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits collect_traits = {
    .name = "collect",
    .on_wire = 14,
    .colour = "#e31a1c",
    .trace_colour = "rail_load",
    .seconds = {.of = {0.05, 0, 0, 0}},
    .memory = {.fixed = 16e6, .of_input_byte = 2},
    .ends_job = true,
};

constinit const KindContracts collect_contracts = contracts_between<CollectGiven, CollectMade>;

void CollectGiven::describe(ContractFields& fields) {
  fields.file("job", job);
  fields.files("mesh:", meshes);
  fields.files("solution:", solutions);
  fields.files("log:", logs);
  fields.files("figures:", figures);
  fields.files("kept:", kept);
}

void CollectMade::describe(ContractFields& /*fields*/) {}

}  // namespace tetfarm
