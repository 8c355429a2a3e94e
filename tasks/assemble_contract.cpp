#include "tasks/assemble_contract.h"

#include "tasks/kind_contracts.h"
#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits assemble_traits = {
    .name = "assemble",
    .on_wire = 5,
    .colour = "#c0392b",
    .trace_colour = "rail_load",
    .seconds = {.of = {0.006, 0.02e-6, 0.4e-6, 0}},
    .memory = {.fixed = 4e6, .of_element = 130, .of_triangle = 250},
    .reads_file_by_file = true,
    .ends_job = true,
};

constinit const KindContracts assemble_contracts = contracts_between<AssembleGiven, AssembleMade>;

void AssembleGiven::describe(ContractFields& fields) {
  fields.file("job", job);
  fields.file("surface", surface);
  fields.file("numbering", numbering);
  fields.files_by_leaf({{"portion:", &portions}, {"tets:", &tets}});
  fields.file("layer_map", layer_map);
}

void AssembleMade::describe(ContractFields& /*fields*/) {}

}  // namespace tetfarm
