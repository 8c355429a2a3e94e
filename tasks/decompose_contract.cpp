#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits decompose_traits = {
    .name = "decompose",
    .on_wire = 2,
    .rank = 0,
    .colour = "#d9822b",
    .trace_colour = "rail_response",
    .outputs = {"left", "right"},
    .may_make_nothing = true,
    .seconds = {.of = {0.02, 0.1e-6, 1e-6, 0.15e-3}, .spreads = {0.5, 0.5, 0.5, 0.8}},
    .memory = {.fixed = 13e6, .of_spacing_byte = 1, .of_element = 1, .of_triangle = 260},
};

}  // namespace tetfarm
