#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits write_traits = {
    .name = "write",
    .on_wire = 10,
    .colour = "#e7a8c9",
    .trace_colour = "rail_load",
    .outputs = {"portion", "tets"},
    .seconds = {.of = {0.006, 0.3e-6, 0.15e-6, 0}},
    .memory = {.fixed = 4e6, .of_element = 150, .of_triangle = 250},
};

}  // namespace tetfarm
