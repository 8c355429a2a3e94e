#include "tasks/number_contract.h"

#include "tasks/kind_contracts.h"
#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits number_traits = {
    .name = "number",
    .on_wire = 4,
    .colour = "#777777",
    .trace_colour = "grey",
    .outputs = {"numbering"},
    .seconds = {.of = {0.003, 0, 0.45e-6, 0}},
    .memory = {.of_triangle = 110},
};

constinit const KindContracts number_contracts = contracts_between<NumberGiven, NumberMade>;

void NumberGiven::describe(ContractFields& fields) {
  fields.file("surface", surface);
  fields.file("layer_table", layer_table);
  fields.file("dropped", dropped);
  fields.files_by_leaf({{"core:", &cores}, {"elements:", &elements}});
  fields.text("table", table);
  fields.text("order", order);
}

void NumberMade::describe(ContractFields& fields) { fields.file("numbering", numbering); }

}  // namespace tetfarm
