/// What has to hold of any plan of layers, looked at apart from how it was made.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <vector>

#include "base/array_index.h"
#include "mesh/core/validate.h"
#include "mesh/geometry/predicates.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/layers/layer_cells.h"
#include "mesh/layers/layer_plan.h"
#include "mesh/layers/unlayered_domain.h"

namespace tetfarm::test {

inline LayerRequest request_of_all(const SurfaceMesh& surface, double first, int count) {
  LayerRequest request;
  request.law = {.first = first, .growth = 1.2, .acceleration = 1, .cap = 1.2, .equal = 1};
  request.count = count;
  for (std::size_t p = 0; p < std::max<std::size_t>(1, surface.patch_names.size()); ++p) {
    request.patches.push_back(static_cast<std::int32_t>(p));
  }
  return request;
}

/// Figures of what was checked, so that a test can tell that there was something.
struct LayerFigures {
  std::int64_t prisms = 0;
  std::int64_t pyramids = 0;
  std::int64_t tets = 0;
  std::int64_t full = 0;  ///< wall triangles with all layers
};

/// What the surface encloses with the quads of the layers' sides.
inline double volume_within(const LayerPlan& plan, const SurfaceMesh& surface) {
  SurfaceMesh closed = surface;
  for (const LayerSide& side : plan.sides) {
    const Triangle& nodes = surface.triangles[at(side.triangle)];
    std::array<std::vector<Vec3>, 2> points;
    for (std::size_t k = 0; k < 2; ++k) {
      points[k] = points_of(plan.lines[at(plan.vertex2line[at(nodes[(at(side.corner) + k) % 3])])]);
    }
    for (std::size_t i = 1; i < std::min(points[0].size(), points[1].size()); ++i) {
      const auto first = static_cast<std::int32_t>(closed.vertices.size());
      for (const auto& line : points) {
        closed.vertices.insert(closed.vertices.end(), {line[i - 1], line[i]});
      }
      closed.triangles.push_back({first + 2, first, first + 1});
      closed.triangles.push_back({first + 2, first + 1, first + 3});
    }
  }
  return enclosed_volume(closed.vertices, closed.triangles);
}

/// Every component tet is positive, stops differ by `step` at most, a line that has fewer layers
/// than wanted tells why, and what is left is a domain without defects, turned as the surface was,
/// of the volume that the cells leave.
inline LayerFigures expect_valid_layers(const LayerPlan& plan, const SurfaceMesh& surface,
                                        int step = 1) {
  LayerFigures figures;
  long double volume = 0;
  for (const std::int32_t t : plan.wall) {
    const auto lines = lines_of(plan, surface, t);
    std::array<int, 3> stops{};
    std::array<std::vector<Vec3>, 3> points;
    bool is_full = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const LayerLine& line = plan.lines[at(lines[k])];
      stops[k] = line.stop;
      points[k] = points_of(line);
      is_full = is_full && line.stop == line.wanted;
      EXPECT_LE(line.stop, line.wanted);
      EXPECT_EQ(line.reason == StopReason::complete, line.stop == line.wanted)
          << name_of(line.reason) << ' ' << line.stop << ' ' << line.wanted;
      EXPECT_LE(std::abs(line.stop - plan.lines[at(lines[(k + 1) % 3])].stop), step);
    }
    figures.full += is_full ? 1 : 0;
    for (int layer = 1; layer <= layers_above(stops); ++layer) {
      const LayerCell cell = layer_cell(stops, layer);
      std::vector<Vec3> p;
      for (std::size_t k = 0; k < nodes_of(cell.type); ++k) {
        p.push_back(points[at(cell.nodes[k].corner)][at(cell.nodes[k].level)]);
      }
      for (const auto& tet : component_tets(cell.type)) {
        EXPECT_GT(orient3d(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]), 0);
      }
      volume += element_volume(cell.type, p);
      figures.prisms += cell.type == ElementType::prism ? 1 : 0;
      figures.pyramids += cell.type == ElementType::pyramid ? 1 : 0;
      figures.tets += cell.type == ElementType::tet ? 1 : 0;
    }
  }
  const UnlayeredDomain rest = unlayered_domain(plan, surface, TreePath{2}, 1);
  EXPECT_EQ(validate(rest.root), std::vector<std::string>{});
  SurfaceMesh top;
  top.vertices = rest.root.vertices;
  top.triangles = rest.root.triangles;
  const CheckedSurface checked = check_surface(top);
  EXPECT_TRUE(checked.report.defects.empty());
  EXPECT_EQ(checked.surface.triangles, top.triangles);
  const double whole = volume_within(plan, surface);
  const double left = enclosed_volume(top.vertices, top.triangles);
  // Both volumes that are subtracted are rounded.
  EXPECT_NEAR(static_cast<double>(volume), whole - left, 1e-8 * whole);
  return figures;
}

}  // namespace tetfarm::test
