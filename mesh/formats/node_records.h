/// The coordinates of all nodes as an array of records in a file, filled part by part.
#pragma once

#include <span>
#include <vector>

#include "mesh/assemble/node_runs.h"
#include "mesh/assemble/output_file.h"
#include "mesh/core/element_block.h"
#include "mesh/formats/number_text.h"

namespace tetfarm {

/// Writes the part's nodes where they belong: the record of node 0 begins at `place`, each takes
/// `bytes_each`. `put(numbers, number, p)` writes one; `numbers` is the style, empty.
template <class Put>
void write_node_records(OutputFile& file, std::int64_t place, std::int64_t bytes_each,
                        const NumberedPart& part, const NumberText& style, const Put& put) {
  for_each_node_run(part, [&](std::int64_t first, const std::vector<Vec3>& nodes) {
    NumberText numbers = style;
    std::int64_t number = first;
    for (const Vec3& p : nodes) put(numbers, number++, p);
    file.write(place + first * bytes_each, numbers.bytes());
  });
}

/// The number in the whole mesh.
inline std::int64_t global_node(const NumberedPart& part, std::int32_t local) {
  return part.local2global[static_cast<std::size_t>(local)];
}

/// Calls put(number) for the nodes of the i-th element of a block in the order of that numbering,
/// by their numbers in the whole mesh.
template <class Put>
void for_each_global_node(ElementCodes codes, ElementType type, const NumberedPart& part,
                          std::size_t i, const Put& put) {
  const std::span<const std::int32_t> nodes = part.blocks[type].element(type, i);
  const auto& order = node_order(codes, type);
  for (std::size_t k = 0; k < nodes.size(); ++k) put(global_node(part, nodes[order[k]]));
}

/// The faces of a part by patch: list i has the numbers of those of patch i.
std::vector<std::vector<std::size_t>> faces_by_patch(const NumberedPart& part, std::size_t patches);
/// The same of a block of faces.
std::vector<std::vector<std::size_t>> faces_by_patch(const ElementBlock& block,
                                                     std::size_t patches);

}  // namespace tetfarm
