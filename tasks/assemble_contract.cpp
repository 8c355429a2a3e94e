#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits assemble_traits = {
    .name = "assemble",
    .on_wire = 5,
    .colour = "#c0392b",
    .trace_colour = "rail_load",
    .seconds = {.of = {0.006, 0.02e-6, 0.4e-6, 0}},
    .memory = {.fixed = 4e6, .of_element = 130, .of_triangle = 250},
    .reads_file_by_file = true,
};

}  // namespace tetfarm
