#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits inspect_traits = {
    .name = "inspect",
    .on_wire = 1,
    .colour = "#8c6bb1",
    .trace_colour = "grey",
    .outputs = {"surface", "spacing", "root", "settings"},
    .seconds = {.of = {0.006, 0.15e-6, 7e-6, 0}},
    .memory = {.fixed = 8e6, .of_input_byte = 1.2, .of_spacing_byte = 2.5, .of_triangle = 220},
};

}  // namespace tetfarm
