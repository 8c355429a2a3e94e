/// The mesh as cosmetics changes it: some tets go, others that fill the same cavity come.
///
/// Every change of topology is a Replacement, done by mesh/core/tet_replacement.h.
#pragma once

#include <limits>
#include <optional>

#include "mesh/core/tet_complex.h"
#include "mesh/core/tet_marks.h"
#include "mesh/cosmetics/quality.h"

namespace tetfarm::cosmetics {

/// A complex with what cosmetics keeps about it. Nodes below fixed_nodes never move.
struct WorkMesh {
  TetComplex& complex;
  std::int32_t fixed_nodes = 0;
  /// Number of the change that last touched the tets of a node; 0: none yet.
  std::vector<std::int64_t> node2change;
  std::int64_t changes = 0;
  /// The set of tets that is being gathered.
  TetMarks marks;
  /// Not a number: not known.
  mutable std::vector<double> tet2quality;
  /// The factor that makes a change worth it, see is_worth.
  double gain = usual_gain;

  WorkMesh(TetComplex& complex_, std::int32_t fixed_nodes_);
  void forget_quality_of(std::int32_t t) {
    tet2quality[static_cast<std::size_t>(t)] = std::numeric_limits<double>::quiet_NaN();
  }
  bool may_move(std::int32_t node) const { return node >= fixed_nodes; }
  const Vec3& point(std::int32_t node) const {
    return complex.points[static_cast<std::size_t>(node)];
  }
  const Tet& tet(std::int32_t t) const { return complex.nodes[static_cast<std::size_t>(t)]; }
  FaceHandle across(std::int32_t t, int face) const {
    return complex.neighbours[static_cast<std::size_t>(t)][static_cast<std::size_t>(face)];
  }
  /// @pre the tet holds the node.
  int local_node(std::int32_t t, std::int32_t node) const {
    const Tet& nodes = tet(t);
    return nodes[0] == node ? 0 : nodes[1] == node ? 1 : nodes[2] == node ? 2 : 3;
  }
  /// Whether no tet of its nodes was changed.
  bool is_untouched(std::int32_t t) const {
    const auto& [a, b, c, d] = tet(t);
    return (change_of(a) | change_of(b) | change_of(c) | change_of(d)) == 0;
  }
  std::int64_t change_of(std::int32_t node) const {
    return node2change[static_cast<std::size_t>(node)];
  }
  /// Computed when first asked for, and kept until the tet changes.
  double quality_of(std::int32_t t) const;
};

/// Tets to be replaced by new ones. `new_point`: a node that the new tets name as points.size().
struct Replacement {
  std::vector<std::int32_t> old_tets;
  std::vector<Tet> new_tets;
  double old_worst = 0;
  double new_worst = 0;
  std::optional<Vec3> new_point;
};

/// The smallest quality of the tets.
double worst_of(const WorkMesh& work, const std::vector<std::int32_t>& tets);

/// The tets round a node, in breadth-first order from node2tet.
std::vector<std::int32_t> ball_of_node(WorkMesh& work, std::int32_t node);

/// True when no boundary face holds the node and it is not fixed: it may move or go.
bool is_inner(const WorkMesh& work, const std::vector<std::int32_t>& ball, std::int32_t node);

/// The tets round an edge in order: tets[i] = (from, to, nodes[i], nodes[i + 1]), positive.
struct EdgeRing {
  std::int32_t from = -1;
  std::int32_t to = -1;
  std::vector<std::int32_t> nodes;
  std::vector<std::int32_t> tets;
};

/// The ring of edge (i, j) of tet t; empty when the edge lies on the boundary or has more than
/// `most` tets.
std::optional<EdgeRing> ring_of_edge(const WorkMesh& work, std::int32_t t, int i, int j,
                                     std::size_t most);

/// Replaces the tets and gives the numbers of the new ones. Nothing is done, and nothing returned,
/// when a new tet is not exactly positive or the outer faces differ.
/// Cost: O(n log n) for n tets.
std::vector<std::int32_t> replace_tets(WorkMesh& work, const Replacement& replacement);

}  // namespace tetfarm::cosmetics
