#include "tasks/mesh_contract.h"

#include "tasks/kind_contracts.h"
#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits mesh_traits = {
    .name = "mesh",
    .on_wire = 3,
    .colour = "#3b7dbd",
    .trace_colour = "good",
    .outputs = {"mesh"},
    .seconds = {.of = {0.006, 1.8e-6, 8e-6, 0.45e-3}},
    .memory = {.fixed = 2e6, .of_spacing_byte = 1, .of_element = 330, .of_triangle = 700},
    .shrinks_with_leaf = true,
};

constinit const KindContracts mesh_contracts = contracts_between<MeshGiven, MeshMade>;

void MeshGiven::describe(ContractFields& fields) {
  fields.file("job", job);
  fields.file("subdomain", subdomain);
  fields.file("spacing", spacing);
  fields.count("work", work);
  fields.count("needles", needles);
}

void MeshMade::describe(ContractFields& fields) {
  fields.file("mesh", mesh);
  fields.count("interior_nodes", interior_nodes);
  fields.count("tets", tets);
}

}  // namespace tetfarm
