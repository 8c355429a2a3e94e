/// The coordinates of all nodes as an array of records in a file, filled part by part.
#pragma once

#include "mesh/assemble/node_runs.h"
#include "mesh/assemble/output_file.h"
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

/// The faces of a part by patch: list i has the numbers of those of patch i.
std::vector<std::vector<std::size_t>> faces_by_patch(const NumberedPart& part, std::size_t patches);

}  // namespace tetfarm
