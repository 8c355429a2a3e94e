#include "tasks/cosmetic_contract.h"

#include "tasks/kind_contracts.h"
#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits cosmetic_traits = {
    .name = "cosmetic",
    .on_wire = 9,
    .rank = 0,
    .colour = "#4daf4a",
    .trace_colour = "bad",
    .outputs = {"elements"},
    .seconds = {.of = {0.006, 3e-6, 0, 0}, .spreads = {0.4, 0.9, 0.4, 0.55}},
    .memory = {.fixed = 4e6, .of_spacing_byte = 1, .of_element = 360},
    .shrinks_with_leaf = true,
    .needs_whole_tree = true,
};

constinit const KindContracts cosmetic_contracts = contracts_between<CosmeticGiven, CosmeticMade>;

void CosmeticGiven::describe(ContractFields& fields) {
  fields.file("spacing", spacing);
  fields.file("own", own);
  fields.files_by_leaf({{"waits:", &waiting}, {"had_turn:", &had_turn}});
  fields.text("colours", colours);
}

void CosmeticMade::describe(ContractFields& fields) { fields.file("elements", elements); }

}  // namespace tetfarm
