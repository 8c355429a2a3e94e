#include "mesh/partition/renumbered_mesh.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/assemble/part_cells.h"
#include "mesh/geometry/hilbert_order.h"
#include "mesh/partition/reordered_marks.h"

namespace tetfarm {
namespace {

std::vector<bool> nodes_on_surface(const NumberedPart& part) {
  std::vector<bool> is_on_surface(part.nodes.size(), false);
  for_each_boundary_face(part,
                         [&](std::int32_t, const FaceNodes<std::int32_t>& face, std::int32_t) {
                           for (const std::int32_t v : face) is_on_surface[at(v)] = true;
                         });
  return is_on_surface;
}

/// The nodes of a cell, ascending; behind them as many -1 as make the length the same for all.
using SortedNodes = std::array<std::int32_t, most_element_nodes>;

SortedNodes sorted_nodes(std::span<const std::int32_t> cell) {
  SortedNodes nodes;
  nodes.fill(-1);
  std::copy(cell.begin(), cell.end(), nodes.begin());
  std::sort(nodes.begin(), nodes.begin() + std::ssize(cell));
  return nodes;
}

/// By region first, as parts have to be, then by their nodes, the lowest first. `nodes(i)` are
/// those of the i-th.
template <class Nodes>
std::vector<std::size_t> order_of_cells(const std::vector<std::int32_t>& regions,
                                        const Nodes& nodes) {
  std::vector<SortedNodes> sorted;
  sorted.reserve(regions.size());
  for (std::size_t i = 0; i < regions.size(); ++i) sorted.push_back(sorted_nodes(nodes(i)));
  std::vector<std::size_t> order(regions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (regions[a] != regions[b]) return regions[a] < regions[b];
    return sorted[a] != sorted[b] ? sorted[a] < sorted[b] : a < b;
  });
  return order;
}

/// @return which was the first before, which the second, and so on.
std::vector<std::size_t> sort_tets(NumberedPart& part) {
  std::vector<std::int32_t> region_of_tet = part.region_of_tet;
  region_of_tet.resize(part.tets.size(), part.region);
  std::vector<Tet> tets;
  std::vector<std::int32_t> regions;
  std::vector<std::size_t> order =
      order_of_cells(region_of_tet, [&](std::size_t i) { return std::span(part.tets[i]); });
  for (const std::size_t t : order) {
    tets.push_back(part.tets[t]);
    if (!part.region_of_tet.empty()) regions.push_back(part.region_of_tet[t]);
  }
  part.tets = std::move(tets);
  part.region_of_tet = std::move(regions);
  return order;
}

std::vector<std::size_t> sort_block(ElementType type, ElementBlock& cells) {
  std::vector<std::size_t> order =
      order_of_cells(cells.regions, [&](std::size_t i) { return cells.element(type, i); });
  cells = reordered(type, cells, order);
  return order;
}

/// The cells of each type, and their marks with them.
void sort_cells(NumberedPart& part) {
  std::vector<std::size_t> order = sort_tets(part);
  for (const ElementType type : cell_block_types) {
    const std::size_t first = order.size();
    for (const std::size_t i : sort_block(type, part.blocks[type])) order.push_back(first + i);
  }
  part.marks = reordered_marks(part.marks, order);
}

/// The nodes by rising new number; elements follow.
void put_in_order(NumberedPart& part) {
  std::vector<std::int32_t> order(part.nodes.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return part.local2global[at(a)] < part.local2global[at(b)];
  });
  const NumberedPart before = part;
  std::vector<std::int32_t> old2new(order.size());
  for (std::size_t v = 0; v < order.size(); ++v) {
    old2new[at(order[v])] = static_cast<std::int32_t>(v);
    part.nodes[v] = before.nodes[at(order[v])];
    part.local2global[v] = before.local2global[at(order[v])];
    if (part.feet.empty()) continue;
    part.feet.foot[v] = before.feet.foot[at(order[v])];
    part.feet.depth[v] = before.feet.depth[at(order[v])];
  }
  for (Tet& tet : part.tets) {
    for (std::int32_t& v : tet) v = old2new[at(v)];
  }
  for (Triangle& face : part.faces) {
    for (std::int32_t& v : face) v = old2new[at(v)];
  }
  for_each_block(part.blocks, [&](ElementType, ElementBlock& block) {
    for (std::int32_t& v : block.nodes) v = old2new[at(v)];
  });
}

/// Ascending, each once.
std::vector<std::int64_t> feet_of(const NumberedPart& part) {
  std::vector<std::int64_t> feet = part.feet.foot;
  std::sort(feet.begin(), feet.end());
  feet.erase(std::unique(feet.begin(), feet.end()), feet.end());
  return feet;
}

}  // namespace

RenumberedMesh::RenumberedMesh(std::unique_ptr<MeshSource> source, NodeNumbering numbering)
    : source_(std::move(source)), numbering_(numbering) {
  find_shared_nodes();
  number_nodes();
}

void RenumberedMesh::find_shared_nodes() {
  std::vector<bool> is_met;
  std::vector<bool> has_several;
  std::vector<std::int64_t> feet;
  for (std::size_t i = 0; i < size(); ++i) {
    const CountedPart counted = source_->counted_part(i);
    for (const std::int64_t number : counted.part.local2global) {
      const auto node = static_cast<std::size_t>(number);
      if (node >= is_met.size()) {
        is_met.resize(std::max(node + 1, 2 * is_met.size()), false);
        has_several.resize(is_met.size(), false);
      }
      if (is_met[node]) has_several[node] = true;
      is_met[node] = true;
    }
    const std::vector<std::int64_t> of_part = feet_of(counted.part);
    feet.insert(feet.end(), of_part.begin(), of_part.end());
  }
  std::sort(feet.begin(), feet.end());
  auto foot = std::lower_bound(feet.begin(), feet.end(), 0);
  for (std::size_t node = 0; node < has_several.size(); ++node) {
    const auto number = static_cast<std::int64_t>(node);
    const bool is_foot = foot != feet.end() && *foot == number && is_met[node];
    while (foot != feet.end() && *foot == number) ++foot;
    if (!has_several[node] && !is_foot) continue;
    shared_.push_back({number, -1, UINT32_MAX, has_several[node] ? border : inside});
  }
}

/// First all parts say which of the shared nodes are on the surface, then each numbers its own.
void RenumberedMesh::number_nodes() {
  std::vector<std::array<std::int64_t, kinds>> counts(size());
  for (std::size_t i = 0; i < size(); ++i) {
    const NumberedPart part = source_->part(i);
    const std::vector<bool> is_on_surface = nodes_on_surface(part);
    for (std::size_t v = 0; v < part.nodes.size(); ++v) {
      const std::optional<std::size_t> known = shared(part.local2global[v]);
      if (!known) continue;
      SharedNode& node = shared_[*known];
      node.owner = std::min(node.owner, static_cast<std::uint32_t>(i));
      if (is_on_surface[v]) node.kind = surface;
    }
  }
  // Numbers within the part and kind; where they begin is known when all parts are counted.
  for (std::size_t i = 0; i < size(); ++i) {
    const NumberedPart part = source_->part(i);
    const OwnNodes own = own_nodes(part, i);
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      counts[i][kind] = std::ssize(own[kind]);
      for (std::size_t k = 0; k < own[kind].size(); ++k) {
        const std::optional<std::size_t> known = shared(part.local2global[at(own[kind][k])]);
        if (!known) continue;
        shared_[*known].number = static_cast<std::int64_t>(k);
        shared_[*known].kind = static_cast<Kind>(kind);
      }
    }
  }
  first_.resize(size());
  std::int64_t next = 0;
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    for (std::size_t i = 0; i < size(); ++i) {
      first_[i][kind] = next;
      next += counts[i][kind];
    }
  }
  for (SharedNode& node : shared_) node.number += first_[node.owner][node.kind];
}

std::optional<std::size_t> RenumberedMesh::shared(std::int64_t old_number) const {
  const auto found =
      std::lower_bound(shared_.begin(), shared_.end(), old_number,
                       [](const SharedNode& node, std::int64_t n) { return node.old_number < n; });
  if (found == shared_.end() || found->old_number != old_number) return std::nullopt;
  return static_cast<std::size_t>(found - shared_.begin());
}

std::vector<std::int32_t> RenumberedMesh::order_of(const NumberedPart& part) const {
  if (numbering_ == NodeNumbering::hilbert) return hilbert_order(part.nodes);
  return reverse_cuthill_mckee(part);
}

RenumberedMesh::OwnNodes RenumberedMesh::own_nodes(const NumberedPart& part,
                                                   std::size_t index) const {
  const std::vector<bool> is_on_surface = nodes_on_surface(part);
  OwnNodes own;
  for (const std::int32_t v : order_of(part)) {
    const std::optional<std::size_t> known = shared(part.local2global[at(v)]);
    if (known && shared_[*known].owner != index) continue;
    Kind kind = known ? shared_[*known].kind : is_on_surface[at(v)] ? surface : inside;
    if (numbering_ == NodeNumbering::reverse_cuthill_mckee) kind = inside;
    own[kind].push_back(v);
  }
  return own;
}

NodeFeet RenumberedMesh::with_new_numbers(NodeFeet feet, std::size_t part) const {
  for (std::int64_t& foot : feet.foot) {
    if (foot == no_foot) continue;
    const std::optional<std::size_t> known = shared(foot);
    if (!known) {
      throw InvalidInput("a node has a foot that is no node of the mesh",
                         "sub-domain " + std::to_string(part));
    }
    foot = shared_[*known].number;
  }
  return feet;
}

NumberedPart RenumberedMesh::part(std::size_t i) const {
  NumberedPart part = source_->part(i);
  const OwnNodes own = own_nodes(part, i);
  std::vector<std::int64_t> numbers(part.nodes.size(), -1);
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    std::int64_t number = first_[i][kind];
    for (const std::int32_t v : own[kind]) numbers[at(v)] = number++;
  }
  for (std::size_t v = 0; v < numbers.size(); ++v) {
    if (numbers[v] < 0) numbers[v] = shared_[shared(part.local2global[v]).value()].number;
  }
  part.local2global = std::move(numbers);
  part.feet = with_new_numbers(std::move(part.feet), i);
  put_in_order(part);
  sort_cells(part);
  return part;
}

NumberSpans spans_of(const MeshSource& source) {
  NumberSpans spans;
  for (std::size_t i = 0; i < source.size(); ++i) spans.add(number_spans(source.part(i)));
  return spans;
}

}  // namespace tetfarm
