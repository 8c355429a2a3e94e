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

}  // namespace tetfarm
