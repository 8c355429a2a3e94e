#include "tasks/extract_contract.h"

#include "tasks/kind_contracts.h"
#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits extract_traits = {
    .name = "extract",
    .on_wire = 8,
    .rank = 0,
    .colour = "#66c2a5",
    .trace_colour = "generic_work",
    .outputs = {"elements"},
    .seconds = {.of = {0.006, 0.1e-6, 0, 0}},
    .memory = {.of_element = 190, .of_triangle = 200},
    .shrinks_with_leaf = true,
    .needs_whole_tree = true,
};

constinit const KindContracts extract_contracts = contracts_between<ExtractGiven, ExtractMade>;

void ExtractGiven::describe(ContractFields& fields) {
  fields.file("subdomain", subdomain);
  fields.file("mesh", mesh);
  fields.file("shared", shared);
}

void ExtractMade::describe(ContractFields& fields) { fields.file("elements", elements); }

}  // namespace tetfarm
