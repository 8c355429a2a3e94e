#include "tasks/remesh_contract.h"

#include "tasks/kind_contracts.h"
#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits remesh_traits = {
    .name = "remesh",
    .on_wire = 15,
    .colour = "#7a9a3a",
    .trace_colour = "olive",
    .outputs = {"surface"},
    .seconds = {.of = {0.006, 0, 150e-6, 0}},
    .memory = {.fixed = 8e6, .of_input_byte = 1.2, .of_triangle = 600},
    .begins_job = true,
};

constinit const KindContracts remesh_contracts = contracts_between<RemeshGiven, RemeshMade>;

void RemeshGiven::describe(ContractFields& fields) {
  fields.file("job", job);
  fields.file("input_surface", input_surface);
}

void RemeshMade::describe(ContractFields& fields) { fields.file("surface", surface); }

}  // namespace tetfarm
