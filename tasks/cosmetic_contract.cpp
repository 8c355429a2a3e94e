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

}  // namespace tetfarm
