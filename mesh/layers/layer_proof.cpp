#include "mesh/layers/layer_proof.h"

#include <algorithm>
#include <array>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/layers/layer_cells.h"
#include "mesh/layers/plane_retreat.h"
#include "mesh/layers/unlayered_domain.h"

namespace tetfarm {
namespace {

using Column = std::array<std::vector<Vec3>, 3>;  // the points of the three lines

bool has_positive_tets(const LayerCell& cell, const Column& points) {
  std::array<Vec3, 6> p;
  for (std::size_t k = 0; k < nodes_of(cell.type); ++k) {
    p[k] = points[at(cell.nodes[k].corner)][at(cell.nodes[k].level)];
  }
  return is_positive(cell.type, p);
}

/// The layers above a wall triangle below the first cell that is not positive.
int positive_layers(const std::array<int, 3>& stops, const Column& points) {
  const int layers = layers_above(stops);
  for (int layer = 1; layer <= layers; ++layer) {
    if (!has_positive_tets(layer_cell(stops, layer), points)) return layer - 1;
  }
  return layers;
}

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
    for (const std::int32_t v : surface_.triangles[at(t)]) {
      const std::int32_t line = is_wall_[at(t)] ? plan_.vertex2line[at(v)] : line_of_top_[at(v)];
      if (line >= 0 && plan_.lines[at(line)].stop > 0) lines.push_back(line);
    }
    return lines;
  }

 private:
  const LayerPlan& plan_;
  const SurfaceMesh& surface_;
  std::vector<std::int32_t> line_of_top_;  // of each vertex that is a line's; -1: of none
  std::vector<bool> is_wall_;
};

/// The triangles of the rest that meet others, or are turned: the layers below went too far.
std::vector<std::int64_t> faults_of(const SurfaceMesh& rest) {
  const CheckedSurface checked = check_surface(rest);
  std::vector<std::int64_t> faults;
  for (const SurfaceDefect& defect : checked.report.defects) {
    faults.insert(faults.end(), defect.triangles.begin(), defect.triangles.end());
  }
  for (std::size_t t = 0; t < rest.triangles.size(); ++t) {
    if (checked.surface.triangles[t] != rest.triangles[t]) {
      faults.push_back(static_cast<std::int64_t>(t));
    }
  }
  return faults;
}

}  // namespace

ProofFindings prove_cells(const LayerPlan& plan, const SurfaceMesh& surface) {
  ProofFindings findings = findings_of(plan);
  for (const std::int32_t t : plan.wall) {
    const std::array<std::int32_t, 3> lines = lines_of(plan, surface, t);
    std::array<int, 3> stops{};
    for (std::size_t k = 0; k < 3; ++k) stops[k] = plan.lines[at(lines[k])].stop;
    if (layers_above(stops) == 0) continue;
    Column points;
    for (std::size_t k = 0; k < 3; ++k) points[k] = points_of(plan.lines[at(lines[k])]);
    const int most = positive_layers(stops, points);
    for (const std::int32_t line : lines) stop_at(line, most, findings);
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
  for (const std::int64_t fault : faults) {
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
