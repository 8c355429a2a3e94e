#include "cli/node_field.h"

#include <utility>

#include "base/error.h"
#include "mesh/formats/plane/plane_medit.h"

namespace tetfarm {

void require_value_for_each_node(std::size_t values, std::size_t nodes, const std::string& mesh,
                                 const std::string& file) {
  if (values == nodes) return;
  throw InvalidInput("gives values at " + std::to_string(values) + " nodes; " + mesh + " has " +
                         std::to_string(nodes),
                     file);
}

std::vector<double> node_field(const std::string& file, std::int64_t number, std::size_t nodes,
                               const std::string& mesh) {
  NodeFields fields = read_plane_sol(file);
  const auto count = static_cast<std::int64_t>(fields.scalars.size());
  if (count == 0) {
    throw InvalidInput("has no numbers at the nodes: a scalar field has kind 1", file);
  }
  if (number > count) {
    throw UsageError(file + " has " + std::to_string(count) +
                         (count == 1 ? " number at a node" : " numbers at a node"),
                     "--field-number " + std::to_string(number));
  }
  std::vector<double>& values = fields.scalars[static_cast<std::size_t>(number - 1)];
  require_value_for_each_node(values.size(), nodes, mesh, file);
  return std::move(values);
}

}  // namespace tetfarm
