#include "mesh/quality/forced_angles.h"

#include <algorithm>

namespace tetfarm {

ForcedAngles::ForcedAngles(const std::filesystem::path& folder, std::size_t memory_bytes)
    : edges_(folder, std::max<std::size_t>(memory_bytes / sizeof(HalfEdge), 1024)) {}

void ForcedAngles::add(const NumberedPart& part) {
  for (std::size_t i = 0; i < part.faces.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = [&](std::size_t n) {
        return static_cast<std::size_t>(part.faces[i][(k + n) % 3]);
      };
      HalfEdge edge;
      edge.region = part.region_of_boundary(i);
      edge.nodes = {part.local2global[corner(0)], part.local2global[corner(1)]};
      edge.at = {part.nodes[corner(0)], part.nodes[corner(1)]};
      edge.third = part.nodes[corner(2)];
      edge.is_rising = edge.nodes[0] < edge.nodes[1];
      if (!edge.is_rising) {
        std::swap(edge.nodes[0], edge.nodes[1]);
        std::swap(edge.at[0], edge.at[1]);
      }
      edges_.push(edge);
    }
  }
}

ForcedDihedral ForcedAngles::finish() {
  ForcedDihedral forced;
  HalfEdge next;
  bool has_next = edges_.next(next);
  while (has_next) {
    const HalfEdge falling = next;
    HalfEdge rising = next;
    int count = 1;
    while ((has_next = edges_.next(next)) && next.same_edge(falling)) {
      rising = next;
      ++count;
    }
    if (count != 2 || falling.is_rising || !rising.is_rising) continue;
    const auto& [u, v] = rising.at;
    const double bound = forced_dihedral_at_edge(u, v, rising.third, falling.third);
    if (bound < forced.at_most_deg) forced = {bound, 0.5 * (u + v)};
  }
  return forced;
}

}  // namespace tetfarm
