#include "coordinator/decisions/layer_graph.h"

#include <algorithm>

#include "coordinator/decisions/task_rows.h"
#include "tasks/number_contract.h"

namespace tetfarm {
namespace {

/// The children of the root.
constexpr std::uint64_t unlayered = 2;
constexpr std::uint64_t layers = 3;

bool is_below(std::uint64_t path, std::uint64_t ancestor) {
  while (path > ancestor) path /= 2;
  return path == ancestor;
}

}  // namespace

std::uint64_t root_path(const InspectMade& inspected) {
  return inspected.layers.empty() ? 1 : unlayered;
}

std::optional<std::string> problem_with_layers(const InspectMade& inspected) {
  if (inspected.layers.empty() == inspected.layer_table.has_value()) {
    return "there are layers without a table, or a table without layers";
  }
  const bool all_below =
      std::all_of(inspected.layers.begin(), inspected.layers.end(),
                  [](const auto& chunk) { return is_below(chunk.first, layers); });
  if (!all_below) return "a chunk of layers has a place that is no chunk's";
  return std::nullopt;
}

GrowGiven given_to_grow(const TaskRow& inspect, const TaskRow& number) {
  GrowGiven given;
  given.job = given_to<InspectGiven>(inspect).job;
  given.surface = made_by<InspectMade>(inspect).surface;
  given.numbering = made_by<NumberMade>(number).numbering;
  return given;
}

void add_grown(const TaskRow& grow, AssembleGiven& assemble) {
  const auto made = made_by<GrowMade>(grow);
  assemble.portions[grow.path] = made.portion;
  assemble.tets[grow.path] = made.cells;
}

}  // namespace tetfarm
