#include "tasks/write_contract.h"

#include "tasks/kind_contracts.h"
#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits write_traits = {
    .name = "write",
    .on_wire = 10,
    .colour = "#e7a8c9",
    .trace_colour = "rail_load",
    .outputs = {"portion", "tets"},
    .seconds = {.of = {0.006, 0.3e-6, 0, 0}},
    .memory = {.fixed = 4e6, .of_element = 150},
};

constinit const KindContracts write_contracts = contracts_between<WriteGiven, WriteMade>;

void WriteGiven::describe(ContractFields& fields) {
  fields.file("job", job);
  fields.file("surface", surface);
  fields.file("numbering", numbering);
  fields.file("subdomain", subdomain);
  fields.file("mesh", mesh);
  // The leaf itself comes before its neighbours.
  const std::uint64_t own = cores.empty() ? 0 : cores.begin()->first;
  fields.files_by_leaf({{"core:", &cores}, {"elements:", &elements}}, {.first = own});
  fields.text("colours", colours);
  fields.file("top_heights", top_heights);
}

void WriteMade::describe(ContractFields& fields) {
  fields.file("portion", portion);
  fields.file("tets", tets);
}

}  // namespace tetfarm
