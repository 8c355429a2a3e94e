/// Which nodes of a mesh lie on cuts: those that several sub-domains of one region have.
///
/// Source: thesis 4.3.4.1 judges a decomposition by the elements near its interfaces. Interfaces
/// between regions are part of the input, and no cuts.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// Consecutive tets of a part that are of one region.
struct TetRange {
  std::size_t first = 0;
  std::size_t last = 0;
  std::int32_t region = 1;
};
std::vector<TetRange> ranges_of(const NumberedPart& part);

class CutNodes {
 public:
  /// Reads each part twice. Of a source that does not know its sub-domains no node is on a cut.
  /// Memory: one part, two bits a node, 16 bytes a node of a cut. @throws as outline_of.
  explicit CutNodes(const MeshSource& source);

  /// Of each node of the part whether it is on a cut of that region. @pre a part of `source`.
  std::vector<bool> of(const NumberedPart& part, std::int32_t region) const;

 private:
  using Use = std::pair<std::int64_t, std::int32_t>;  // node, region
  std::vector<Use> on_cuts_;                          // sorted
};

}  // namespace tetfarm
