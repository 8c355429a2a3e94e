#include "mesh/layers/layer_proof.h"

#include <algorithm>
#include <array>
#include <map>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/layers/layer_cells.h"
#include "mesh/layers/layer_fan.h"
#include "mesh/layers/placed_column.h"
#include "mesh/layers/plane_retreat.h"
#include "mesh/layers/unlayered_domain.h"

namespace tetfarm {
namespace {

ProofFindings findings_of(const LayerPlan& plan) {
  ProofFindings findings;
  findings.holds = true;
  for (const LayerLine& line : plan.lines) findings.stops.push_back(line.stop);
  return findings;
}

void stop_at(std::int32_t line, int stop, ProofFindings& findings) {
  int& now = findings.stops[at(line)];
  if (stop >= now) return;
  now = stop;
  findings.holds = false;
}

/// The lines that have brought a triangle of the surface to where it is in the rest: its own, when
/// it is of the wall, or those that run in its plane to a corner of it.
class LinesBehind {
 public:
  LinesBehind(const LayerPlan& plan, const SurfaceMesh& surface)
      : plan_(plan),
        surface_(surface),
        line_of_top_(surface.vertices.size(), -1),
        is_wall_(surface.triangles.size(), false) {
    for (const std::int32_t t : plan.wall) is_wall_[at(t)] = true;
    for (std::size_t i = 0; i < plan.lines.size(); ++i) {
      const LayerLine& line = plan.lines[i];
      for (int k = 0; k < line.vertices; ++k) {
        line_of_top_[at(line.first_vertex + k)] = static_cast<std::int32_t>(i);
      }
    }
  }

  std::vector<std::int32_t> of(std::int32_t t) const {
    std::vector<std::int32_t> lines;
    if (is_wall_[at(t)]) {
      for (const std::int32_t line : lines_of(plan_, surface_, t)) add(line, lines);
      return lines;
    }
    for (const std::int32_t v : surface_.triangles[at(t)]) add(line_of_top_[at(v)], lines);
    return lines;
  }

 private:
  void add(std::int32_t line, std::vector<std::int32_t>& lines) const {
    if (line >= 0 && plan_.lines[at(line)].stop > 0) lines.push_back(line);
  }

  const LayerPlan& plan_;
  const SurfaceMesh& surface_;
  std::vector<std::int32_t> line_of_top_;  // of each vertex that is a line's; -1: of none
  std::vector<bool> is_wall_;
};

/// Of each triangle the region on the side where the domain has to be; 0: none.
std::vector<std::int32_t> regions_behind(const SurfaceMesh& rest, const SurfaceMesh& checked) {
  std::vector<std::int32_t> behind;
  for (std::size_t t = 0; t < rest.triangles.size(); ++t) {
    const Sides sides = sides_of(checked, t);
    behind.push_back(checked.triangles[t] == rest.triangles[t] ? sides[0] : sides[1]);
  }
  return behind;
}

/// A void of the domain may be a region to the check, which does not know what the job leaves out.
std::int32_t most_frequent_region(const std::vector<std::int32_t>& regions) {
  std::map<std::int32_t, std::int64_t> counts;
  for (const std::int32_t region : regions) {
    if (region > 0) ++counts[region];
  }
  const auto most =
      std::max_element(counts.begin(), counts.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? 1 : most->first;
}

/// The triangles of the rest that meet others, or are turned: the layers below went too far.
std::vector<std::int64_t> faults_of(const SurfaceMesh& rest) {
  const CheckedSurface checked = check_surface(rest);
  std::vector<std::int64_t> faults;
  for (const SurfaceDefect& defect : checked.report.defects) {
    faults.insert(faults.end(), defect.triangles.begin(), defect.triangles.end());
  }
  const std::vector<std::int32_t> behind = regions_behind(rest, checked.surface);
  const std::int32_t domain = most_frequent_region(behind);
  for (std::size_t t = 0; t < behind.size(); ++t) {
    if (behind[t] != domain) faults.push_back(static_cast<std::int64_t>(t));
  }
  return faults;
}

}  // namespace

namespace {

/// Looks at the cells above a triangle from a layer on.
void prove_column(const LayerPlan& plan, const std::array<std::int32_t, 3>& numbers, int from,
                  ProofFindings& findings) {
  std::array<const LayerLine*, 3> lines{};
  for (std::size_t k = 0; k < 3; ++k) lines[k] = &plan.lines[at(numbers[k])];
  const int most = positive_layers(lines, from);
  for (const std::int32_t line : numbers) stop_at(line, most, findings);
}

}  // namespace

int positive_layers(const std::array<const LayerLine*, 3>& lines, int from) {
  const PlacedColumn placed = placed_column(lines);
  for (int layer = from; layer <= placed.layers; ++layer) {
    for (const LayerCell& cell : cells_of_layer(placed.column, layer)) {
      if (!is_positive(cell.type, corners_of(placed, cell))) return layer - 1;
    }
  }
  return placed.layers;
}

bool has_positive_base(const PieceLines& lines) {
  const std::array<Vec3, fan_nodes> points = base_points(lines);
  const std::vector<FanCell> cells = base_cells(lines);
  return std::all_of(cells.begin(), cells.end(), [&points](const FanCell& cell) {
    std::array<Vec3, 5> p;
    for (std::size_t k = 0; k < nodes_of(cell.type); ++k) p[k] = points[cell.nodes[k]];
    return is_positive(cell.type, p);
  });
}

ProofFindings prove_cells(const LayerPlan& plan, const SurfaceMesh& surface) {
  ProofFindings findings = findings_of(plan);
  for (const std::int32_t t : plan.wall) {
    prove_column(plan, lines_of(plan, surface, t), 1, findings);
  }
  for (const FanPiece& piece : plan.fans) {
    if (!has_positive_base(lines_of(plan, piece))) {
      for (const std::int32_t line : piece.from) stop_at(line, 0, findings);
      for (const std::int32_t line : piece.to) stop_at(line, 0, findings);
    }
    for (const auto& [a, b, c] : open_triangles(plan, piece)) {
      prove_column(plan, {a, b, c}, 2, findings);
    }
  }
  return findings;
}

namespace {

/// The line is to lose a third of its layers, one at least.
void lower(const LayerPlan& plan, std::int32_t line, ProofFindings& findings) {
  const int stop = plan.lines[at(line)].stop;
  if (stop > 0) stop_at(line, std::min(stop - 1, stop * 2 / 3), findings);
}

/// @param plan, surface after planes have retreated.
void find_crossings(const LayerPlan& plan, const SurfaceMesh& surface, ProofFindings& findings) {
  const UnlayeredDomain domain = unlayered_domain(plan, surface, TreePath{2}, 1);
  SurfaceMesh rest;
  rest.vertices = domain.root.vertices;
  rest.triangles = domain.root.triangles;
  const std::vector<std::int64_t> faults = faults_of(rest);
  if (faults.empty()) return;
  const LinesBehind lines(plan, surface);
  const std::int64_t first_of_fans = std::ssize(rest.triangles) - std::ssize(domain.lines_of_fans);
  for (const std::int64_t fault : faults) {
    if (fault >= first_of_fans) {
      for (const std::int32_t line : domain.lines_of_fans[at(fault - first_of_fans)])
        lower(plan, line, findings);
      continue;
    }
    for (const std::int32_t line : lines.of(domain.stands_for[at(fault)]))
      lower(plan, line, findings);
  }
  // Without layers the rest is the surface, which has no defects.
  TF_CHECK(!findings.holds);
}

}  // namespace

ProofFindings prove_top(const LayerPlan& plan, const SurfaceMesh& surface,
                        const WallPlanes& planes) {
  ProofFindings findings = findings_of(plan);
  if (!runs_in_plane(plan, planes)) {
    find_crossings(plan, surface, findings);
    return findings;
  }
  const PlaneRetreat retreat = retreat_planes(surface, planes, plan, {});
  for (const std::int32_t line : retreat.tangled) lower(plan, line, findings);
  if (retreat.tangled.empty()) find_crossings(retreat.plan, retreat.surface, findings);
  return findings;
}

}  // namespace tetfarm
