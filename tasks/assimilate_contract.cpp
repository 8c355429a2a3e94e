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

}  // namespace tetfarm
