#include "tasks/assimilate_contract.h"

#include "tasks/kind_contracts.h"
#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits assimilate_traits = {
    .name = "assimilate",
    .on_wire = 6,
    .colour = "#a65628",
    .trace_colour = "rail_idle",
    .outputs = {"dropped"},
    .seconds = {.of = {0.01, 0, 1.5e-6, 0}},
    .memory = {.of_triangle = 8, .of_triangle_of_largest = 500},
};

constinit const KindContracts assimilate_contracts =
    contracts_between<AssimilateGiven, AssimilateMade>;

void AssimilateGiven::describe(ContractFields& fields) {
  fields.file("job", job);
  fields.files("subdomain:", subdomains);
  fields.text("table", table);
}

void AssimilateMade::describe(ContractFields& fields) {
  fields.files_by_leaf({{"group:", &group_files}}, {.of_tree = true});
  fields.file("dropped", dropped);
  fields.text("groups", groups);
}

}  // namespace tetfarm
