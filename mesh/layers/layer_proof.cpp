#include "mesh/layers/layer_proof.h"

#include <algorithm>
#include <array>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/layers/layer_cells.h"
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

/// Of each top triangle of the domain that is left, the wall triangle below; else -1.
std::vector<std::int32_t> walls_below(const LayerPlan& plan, const Subdomain& root) {
  std::vector<bool> is_wall(root.triangles.size(), false);
  std::vector<std::int32_t> walls(root.triangles.size(), -1);
  for (const std::int32_t t : plan.wall) is_wall[at(t)] = true;
  for (std::size_t t = 0; t < walls.size(); ++t) {
    if (is_wall[t] && root.triangle_origin[t].owner != 0) walls[t] = static_cast<std::int32_t>(t);
  }
  return walls;
}

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

ProofFindings prove_top(const LayerPlan& plan, const SurfaceMesh& surface) {
  ProofFindings findings = findings_of(plan);
  const Subdomain root = unlayered_domain(plan, surface, TreePath{2}, 1).root;
  const std::vector<std::int32_t> walls = walls_below(plan, root);
  SurfaceMesh rest;
  rest.vertices = root.vertices;
  rest.triangles = root.triangles;
  bool is_of_layers = false;
  const std::vector<std::int64_t> faults = faults_of(rest);
  for (const std::int64_t fault : faults) {
    if (walls[at(fault)] < 0) continue;
    is_of_layers = true;
    for (const std::int32_t line : lines_of(plan, surface, walls[at(fault)])) {
      const int stop = plan.lines[at(line)].stop;
      if (stop > 0) stop_at(line, std::min(stop - 1, stop * 2 / 3), findings);
    }
  }
  // Without layers the rest is the surface, which has no defects.
  TF_CHECK(faults.empty() || is_of_layers);
  return findings;
}

}  // namespace tetfarm
