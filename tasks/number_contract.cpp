#include "tasks/task_traits.h"

namespace tetfarm {

constinit const TaskKindTraits number_traits = {
    .name = "number",
    .on_wire = 4,
    .colour = "#777777",
    .trace_colour = "grey",
    .outputs = {"numbering"},
    .seconds = {.of = {0.003, 0, 0.1e-6, 0}},
    .memory = {.of_triangle = 60},
};

}  // namespace tetfarm
