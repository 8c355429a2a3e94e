/// forced_dihedral (mesh/assemble/forced_dihedral.h) of the boundary of a mesh that passes by in
/// parts, whose boundary need not fit in memory.
#pragma once

#include <cstdint>
#include <filesystem>

#include "mesh/assemble/forced_dihedral.h"
#include "mesh/assemble/portion.h"
#include "mesh/formats/external_sort.h"

namespace tetfarm {

/// Regions by themselves, in each the edges that two of its triangles have.
class ForcedAngles {
 public:
  ForcedAngles(const std::filesystem::path& folder, std::size_t memory_bytes);

  void add(const NumberedPart& part);
  /// The smallest, the first of equals by region and nodes. Called once, after the last part.
  ForcedDihedral finish();

 private:
  /// An edge of a triangle as it runs there, and the triangle's third node.
  struct HalfEdge {
    std::int32_t region = 1;
    bool is_rising = false;
    std::array<std::int64_t, 2> nodes{};  ///< ascending
    std::array<Vec3, 2> at{};             ///< of these
    Vec3 third;

    bool same_edge(const HalfEdge& other) const {
      return region == other.region && nodes == other.nodes;
    }
    bool operator<(const HalfEdge& other) const {
      if (region != other.region) return region < other.region;
      if (nodes != other.nodes) return nodes < other.nodes;
      return is_rising < other.is_rising;
    }
  };

  ExternalSort<HalfEdge> edges_;
};

}  // namespace tetfarm
