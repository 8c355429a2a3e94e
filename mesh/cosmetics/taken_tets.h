/// Which tets of a leaf's mesh are taken out of it for turns, and which set of sharers each goes
/// to.
///
/// Source: thesis 4.3.4.1.2 and figure 81; what is taken of the layers is told in
/// mesh/cosmetics/element_extraction.h.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "mesh/core/element_section.h"
#include "mesh/core/tet_mesh.h"
#include "mesh/cosmetics/element_extraction.h"

namespace tetfarm {

/// Place of a set of sharers in order of preference.
using SetRank = std::uint32_t;
inline constexpr SetRank no_set_rank = std::numeric_limits<SetRank>::max();

struct TakenTet {
  std::uint32_t tet = 0;
  SetRank rank = no_set_rank;
};

/// Ascending by tet. `rank_of_node` has no_set_rank for nodes that are not shared; `preferred` are
/// the sets by rank. Cost: O(n) with some ns for each tet, and what lies near cuts.
std::vector<TakenTet> taken_tets(const TetMesh& mesh, std::vector<SetRank> rank_of_node,
                                 const std::vector<Sharers>& preferred,
                                 const ExtractionOptions& options);

}  // namespace tetfarm
