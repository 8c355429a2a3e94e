#include "mesh/quality/mesh_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <tuple>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/assemble/congruent_tets.h"
#include "mesh/assemble/part_edges.h"
#include "mesh/core/element_block.h"
#include "mesh/quality/cut_nodes.h"

namespace tetfarm {
namespace {

double degrees_of(double cosine) { return std::acos(cosine) * 180 / std::numbers::pi; }

bool is_worse(const WorstTet& a, const WorstTet& b) {
  return std::tie(a.min_dihedral_deg, a.tet) < std::tie(b.min_dihedral_deg, b.tet);
}

class Figures {
 public:
  Figures(const MeshSource& source, const SpacingAt& spacing)
      : source_(source), spacing_(spacing), cut_nodes_(source) {
    figures_.knows_subdomains = source.knows_subdomains();
  }

  MeshFigures take(const VisitPart& visit) {
    for (std::size_t i = 0; i < source_.size(); ++i) {
      const NumberedPart part = source_.part(i);
      if (visit) visit(part);
      add(part);
    }
    return std::move(figures_);
  }

 private:
  void add(const NumberedPart& part) {
    SubdomainFigures& here = figures_.subdomains.emplace_back();
    here.cells = cells_of(part);
    here.nodes = std::ssize(part.nodes);
    here.boundary_triangles = std::ssize(part.faces);
    for (const std::int64_t number : part.local2global) count_node(number);
    for (const TetRange& range : ranges_of(part)) add_tets(part, range, here);
    add_others(part, here);
    if (spacing_) add_edges(part);
    figures_.tets += std::ssize(part.tets);
    figures_.boundary_triangles += here.boundary_triangles;
    figures_.volume += here.volume;
  }

  void count_node(std::int64_t number) {
    const auto node = static_cast<std::size_t>(number);
    if (node >= is_counted_.size()) is_counted_.resize(std::max(node + 1, 2 * is_counted_.size()));
    if (!is_counted_[node]) ++figures_.nodes;
    is_counted_[node] = true;
  }

  void add_tets(const NumberedPart& part, const TetRange& range, SubdomainFigures& here) {
    TF_CHECK(range.region >= 1 && range.last <= part.tets.size());
    figures_.regions.resize(std::max(figures_.regions.size(), at(range.region)));
    RegionShapes& region = figures_.regions[at(range.region - 1)];
    const std::span<const Tet> tets(part.tets.begin() + static_cast<long>(range.first),
                                    part.tets.begin() + static_cast<long>(range.last));
    const std::vector<bool> is_near = tets_near_cuts(tets, cut_nodes_.of(part, range.region));
    TF_CHECK(is_near.size() == tets.size());
    for (std::size_t t = 0; t < tets.size(); ++t) {
      const auto node = [&](std::size_t i) -> const Vec3& { return part.nodes[at(tets[t][i])]; };
      const TetShape shape = congruent_.shape(node(0), node(1), node(2), node(3));
      const double volume = tet_volume(node(0), node(1), node(2), node(3));
      here.volume += volume;
      region.volume += volume;
      region.shapes.add(shape);
      if (volume > 0) ++figures_.volumes[std::ilogb(volume)];
      figures_.all.add(shape);
      (is_near[t] ? figures_.near_cuts : figures_.away_from_cuts).add(shape);
      const auto number = figures_.tets + static_cast<std::int64_t>(range.first + t);
      consider(shape, number, is_near[t], here);
    }
  }

  void add_others(const NumberedPart& part, SubdomainFigures& here) {
    std::vector<Vec3> corners;
    for_each_block_cell(part.blocks, [&](ElementType type, std::span<const std::int32_t> nodes,
                                         std::int32_t in_region) {
      corners.clear();
      for (const std::int32_t v : nodes) corners.push_back(part.nodes[at(v)]);
      const auto volume = static_cast<double>(element_volume(type, corners));
      const double jacobian = scaled_jacobian(type, corners);
      CellFigures& figures = figures_.others[type];
      ++figures.cells;
      figures.volume += volume;
      figures.least_scaled_jacobian = std::min(figures.least_scaled_jacobian, jacobian);
      figures.sum_of_scaled_jacobians += jacobian;
      here.volume += volume;
      figures_.regions.resize(std::max(figures_.regions.size(), at(in_region)));
      figures_.regions[at(in_region - 1)].volume += volume;
    });
    figures_.boundary_quads += std::ssize(part.blocks[ElementType::quad].regions);
  }

  /// Keeps it when it is among the worst.
  void consider(const TetShape& shape, std::int64_t number, bool is_near, SubdomainFigures& here) {
    const auto [least, most] =
        std::minmax_element(shape.dihedral_cosines.begin(), shape.dihedral_cosines.end());
    const double angle = degrees_of(*most);
    here.min_dihedral_deg = std::min(here.min_dihedral_deg, angle);
    std::vector<WorstTet>& worst = figures_.worst;
    if (worst.size() == most_worst_tets && angle >= worst.back().min_dihedral_deg) return;
    const WorstTet tet{angle,
                       degrees_of(*least),
                       shape.radius_ratio,
                       shape.height,
                       shape.centroid,
                       figures_.subdomains.size() - 1,
                       number,
                       is_near};
    worst.insert(std::upper_bound(worst.begin(), worst.end(), tet, is_worse), tet);
    if (worst.size() > most_worst_tets) worst.pop_back();
  }

  void add_edges(const NumberedPart& part) {
    EdgeFigures& figures = figures_.edges;
    for (const auto& [a, b] : edges_of(part)) {
      const Vec3& from = part.nodes[at(a)];
      const Vec3& to = part.nodes[at(b)];
      const double ratio = distance(from, to) / spacing_(0.5 * (from + to));
      figures.over_spacing.add(ratio);
      figures.shortest = figures.edges == 0 ? ratio : std::min(figures.shortest, ratio);
      figures.longest = std::max(figures.longest, ratio);
      figures.sum += ratio;
      ++figures.edges;
    }
  }

  const MeshSource& source_;
  const SpacingAt& spacing_;
  const CutNodes cut_nodes_;
  std::vector<bool> is_counted_;  ///< of each node whether a part before has it
  MeshFigures figures_;
  CongruentTets congruent_;
};

}  // namespace

void TetFigures::add(const TetShape& shape) {
  if (shapes.tets == 0 || shape.height < shapes.smallest_height) lowest_at = shape.centroid;
  shapes.add(shape);
  radius_ratio.add(shape.radius_ratio);
}

double MeshFigures::steps_beside_away() const {
  const double away = away_from_cuts.shapes.smallest_height;
  const double least = all.shapes.smallest_height;
  return away > 0 && least > 0 ? away / least : 1;
}

std::int64_t MeshFigures::cells() const {
  std::int64_t sum = tets;
  for (const ElementType type : cell_block_types) sum += others[type].cells;
  return sum;
}

double MeshFigures::largest_over_mean() const {
  std::int64_t largest = 0;
  for (const SubdomainFigures& subdomain : subdomains) largest = std::max(largest, subdomain.cells);
  if (cells() == 0) return 1;
  return static_cast<double>(largest) * static_cast<double>(subdomains.size()) /
         static_cast<double>(cells());
}

MeshFigures figures_of(const MeshSource& source, const SpacingAt& spacing, const VisitPart& visit) {
  return Figures(source, spacing).take(visit);
}

}  // namespace tetfarm
