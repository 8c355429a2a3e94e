#include "tasks/decompose_contract.h"

#include "tasks/kind_contracts.h"
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

constinit const KindContracts decompose_contracts =
    contracts_between<DecomposeGiven, DecomposeMade>;

void DecomposeGiven::describe(ContractFields& fields) {
  fields.file("job", job);
  fields.file("subdomain", subdomain);
  fields.file("spacing", spacing);
  fields.count("left_parts", left_parts, most_parts);
  fields.count("right_parts", right_parts, most_parts);
  fields.count("work", work);
  fields.count("most_bytes", most_bytes);
  fields.count("needles", needles);
}

void DecomposeMade::describe(ContractFields& fields) {
  fields.text("reason", reason);
  std::optional<TaskFile> left;
  if (halves) left = halves->left.file;
  fields.file("left", left);
  if (!left) return;
  if (!halves) halves.emplace();
  halves->left.file = *left;
  fields.file("right", halves->right.file);
  fields.count("interdomain_nodes", halves->interdomain_nodes);
  fields.amount("left_work", halves->left.work);
  fields.amount("right_work", halves->right.work);
  fields.count("left_parts", halves->left.parts, most_parts);
  fields.count("right_parts", halves->right.parts, most_parts);
  fields.count("left_needles", halves->left.needles);
  fields.count("right_needles", halves->right.needles);
}

}  // namespace tetfarm
