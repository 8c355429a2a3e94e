#include "tasks/grow_contract.h"

#include "tasks/kind_contracts.h"
#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits grow_traits = {
    .name = "grow",
    .on_wire = 11,
    .colour = "#b8860b",
    .trace_colour = "rail_animation",
    .outputs = {"portion", "cells"},
    .seconds = {.of = {0.006, 0.8e-6, 0, 0}},
    .memory = {.fixed = 4e6, .of_element = 200},
};

constinit const KindContracts grow_contracts = contracts_between<GrowGiven, GrowMade>;

void GrowGiven::describe(ContractFields& fields) {
  fields.file("job", job);
  fields.file("surface", surface);
  fields.file("numbering", numbering);
  fields.file("layers", layers);
}

void GrowMade::describe(ContractFields& fields) {
  fields.file("portion", portion);
  fields.file("cells", cells);
}

}  // namespace tetfarm
