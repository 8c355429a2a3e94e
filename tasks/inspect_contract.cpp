#include "tasks/inspect_contract.h"

#include "tasks/kind_contracts.h"
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
    .begins_job = true,
};

constinit const KindContracts inspect_contracts = contracts_between<InspectGiven, InspectMade>;

void InspectGiven::describe(ContractFields& fields) {
  fields.file("job", job);
  fields.file("input_surface", input_surface);
  fields.count("free_bytes", free_bytes);
  fields.file("remeshed_surface", remeshed_surface);
}

void InspectMade::describe(ContractFields& fields) {
  fields.file("surface", surface);
  fields.file("spacing", spacing);
  fields.file("root", root);
  fields.file("settings", settings);
  fields.count("parts", parts, most_parts);
  fields.amount("total_work", total_work);
  fields.count("groups", groups, most_parts);
  fields.count("most_bytes", most_bytes);
  fields.count("needles", needles);
  fields.flag("across_cuts", across_cuts);
  fields.files("layers:", layers);
  fields.file("layer_table", layer_table);
  fields.file("layer_map", layer_map);
  fields.file("top_heights", top_heights);
}

}  // namespace tetfarm
