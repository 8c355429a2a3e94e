#include "mesh/filling/lattice_filling.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/filling/core_graft.h"
#include "mesh/filling/core_nodes.h"
#include "mesh/filling/lattice_boundary.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/point_location.h"

namespace tetfarm {
namespace {

/// Each round takes a layer off the core where it did not fit; after these all nodes are inserted.
constexpr int most_rounds = 4;

std::vector<std::uint8_t> core_nodes_inside(const std::vector<std::uint8_t>& is_inside,
                                            std::vector<std::uint8_t> kinds) {
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    kinds[i] = kinds[i] != not_core && is_inside[i] != 0 ? 1 : 0;
  }
  return kinds;
}

/// Tells boxes that lie outside the domain, with all that is within half their size.
class OutsideBoxes {
 public:
  OutsideBoxes(const TetComplex& complex, const std::vector<std::uint8_t>& inside,
               const BoxTree& boundary)
      : complex_(complex), inside_(inside), boundary_(boundary) {
    while (!complex.is_live(last_)) {
      ++last_;
      TF_CHECK(at(last_) < complex.nodes.size());
    }
  }

  bool holds(const Box3& box) {
    const Vec3 margin = 0.5 * box.size();
    const Box3 with_margin{box.low - margin, box.high + margin};
    if (boundary_.any(with_margin, [](std::int32_t) { return true; })) return false;
    const Location location = locate(complex_, 0.5 * (box.low + box.high), last_);
    if (location.tet < 0) return true;
    last_ = location.tet;
    return inside_[at(last_)] == 0;
  }

 private:
  const TetComplex& complex_;
  const std::vector<std::uint8_t>& inside_;
  const BoxTree& boundary_;
  std::int32_t last_ = 0;
};

/// All lattice nodes of the domain, with those round it that tell which cells are even.
std::vector<LatticeNode> nodes_near_domain(const TetComplex& complex,
                                           const std::vector<std::uint8_t>& inside,
                                           const Subdomain& subdomain, const BoxTree& boundary,
                                           const SpacingField& spacing, LatticeVisits& visits) {
  OutsideBoxes outside(complex, inside, boundary);
  return spacing.lattice_nodes(
      bounding_box(subdomain.vertices), [&](const Box3& box) { return outside.holds(box); },
      &visits);
}

/// Inserts the nodes that are listed, and notes their numbers.
void insert_listed(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                   std::int32_t boundary_nodes, const std::vector<LatticeNode>& nodes,
                   const std::vector<std::int32_t>& listed, std::vector<std::int32_t>& numbers,
                   const PointInsertionOptions& options) {
  std::vector<LatticeNode> chosen;
  chosen.reserve(listed.size());
  auto number = static_cast<std::int32_t>(complex.points.size());
  for (const std::int32_t i : listed) {
    chosen.push_back(nodes[at(i)]);
    numbers[at(i)] = number++;
  }
  insert_lattice(complex, constrained, boundary_nodes, chosen, options);
}

/// Core nodes of tets at hull faces that the complex does not hold; all, when none are, or there
/// shall be `no_more` rounds.
std::vector<std::int32_t> misfits(const LatticeCore& core, const CoreSeat& seat, bool no_more) {
  std::vector<std::int32_t> found;
  for (std::size_t i = 0; i < core.hull().size() && !no_more; ++i) {
    if (seat.faces[i] != FaceOfSeat::missing) continue;
    for (const std::int32_t v : core.hull()[i].tet) {
      if (core.is_core(v)) found.push_back(v);
    }
  }
  if (found.empty()) return core.core_nodes();
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

PendingCore insert_shell(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                         const std::vector<std::uint8_t>& inside, const Subdomain& subdomain,
                         const SpacingField& spacing, const PointInsertionOptions& options) {
  const BoxTree tree(triangle_boxes(subdomain.vertices, subdomain.triangles));
  PendingCore pending;
  const std::vector<LatticeNode> nodes =
      nodes_near_domain(complex, inside, subdomain, tree, spacing, pending.cost.visits);
  LatticeGrid grid(nodes);
  LatticeBoundary boundary = find_lattice_boundary(nodes, subdomain);
  std::vector<std::uint8_t> kinds = find_core_nodes(nodes, grid, subdomain, tree, boundary);
  const std::vector<std::uint8_t> is_inside = find_inside_nodes(complex, inside, nodes, kinds);
  std::vector<std::uint8_t> is_core = core_nodes_inside(is_inside, std::move(kinds));

  const auto boundary_nodes = static_cast<std::int32_t>(complex.points.size());
  pending.cost.listed = static_cast<std::int64_t>(nodes.size());
  pending.cost.inside = std::count(is_inside.begin(), is_inside.end(), 1);
  std::vector<std::int32_t> listed;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (is_inside[i] != 0 && is_core[i] == 0 && !boundary.has_vertex_at(i))
      listed.push_back(static_cast<std::int32_t>(i));
  }
  pending.node_numbers = std::move(boundary.node2vertex);
  pending.node_numbers.resize(nodes.size(), -1);
  pending.core = LatticeCore(std::move(grid), std::move(is_core));
  TF_CHECK(pending.node_numbers.size() == nodes.size());
  for (int round = 0;; ++round) {
    insert_listed(complex, constrained, boundary_nodes, nodes, listed, pending.node_numbers,
                  options);
    const CoreSeat seat = find_core_seat(complex, constrained, pending.core, pending.node_numbers);
    if (seat.fits) break;
    listed = misfits(pending.core, seat, round >= most_rounds);
    pending.core.leave_out(listed);
  }
  pending.smallest_cell_edge = HUGE_VAL;
  for (const std::int32_t v : pending.core.core_nodes()) {
    pending.places.push_back(nodes[at(v)].place());
    pending.smallest_cell_edge = std::min(pending.smallest_cell_edge, nodes[at(v)].cell_edge);
  }
  return pending;
}

GraftedCore graft_pending_core(TetComplex& complex, std::vector<std::uint8_t>& constrained,
                               PendingCore pending, std::int32_t first_moved, std::int32_t moved) {
  if (pending.core.tet_count() == 0) return {};
  for (std::int32_t& v : pending.node_numbers) {
    if (v >= first_moved) v -= moved;
  }
  const CoreSeat seat = find_core_seat(complex, constrained, pending.core, pending.node_numbers);
  auto number = static_cast<std::int32_t>(complex.points.size());
  TF_CHECK(seat.fits);  // it did, with the same hull
  for (const std::int32_t v : pending.core.core_nodes()) pending.node_numbers[at(v)] = number++;
  complex.points.insert(complex.points.end(), pending.places.begin(), pending.places.end());
  TF_CHECK(at(number) == complex.points.size());
  complex.node2tet.resize(complex.points.size(), -1);
  graft_core(complex, constrained, pending.core, pending.node_numbers, seat);
  // Edges and faces of a lattice tet give it one height, the root of a half of the cell's edge.
  constexpr double height_in_edges = 0.7071;
  const auto last = static_cast<std::int32_t>(complex.nodes.size());
  return {last - pending.core.tet_count(), last, height_in_edges * pending.smallest_cell_edge};
}

}  // namespace tetfarm
