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
#include "mesh/layers/layer_fan.h"
#include "mesh/layers/layer_plan.h"
#include "mesh/layers/side_triangles.h"
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

/// What the surface encloses with the quads of the layers' sides, where these have some.
inline double volume_within(const LayerPlan& plan, const SurfaceMesh& surface) {
  SurfaceMesh closed = surface;
  const auto add_quads = [&closed](const std::vector<Vec3>& from, const std::vector<Vec3>& to,
                                   std::size_t low) {
    for (std::size_t i = low + 1; i < std::min(from.size(), to.size()); ++i) {
      const auto first = static_cast<std::int32_t>(closed.vertices.size());
      closed.vertices.insert(closed.vertices.end(), {from[i - 1], from[i], to[i - 1], to[i]});
      closed.triangles.push_back({first, first + 2, first + 3});
      closed.triangles.push_back({first, first + 3, first + 1});
    }
  };
  for (const LayerSide& side : plan.sides) {
    const auto lines = lines_of(plan, surface, side.triangle);
    if (quads_of({plan.lines[at(lines[at((side.corner + 1) % 3)])],
                  plan.lines[at(lines[at(side.corner)])]}) == 0) {
      continue;
    }
    std::array<std::vector<Vec3>, 2> points;
    for (std::size_t k = 0; k < 2; ++k) {
      points[k] = points_of(plan.lines[at(lines[(at(side.corner) + k) % 3])]);
    }
    add_quads(points[1], points[0], 0);
  }
  for (const FanPiece& piece : plan.fans) {
    for (std::size_t end = 0; end < piece.ends.size(); ++end) {
      if (piece.ends.at(end).patch < 0) continue;
      const auto [left, right] = lines_at_end(numbers_of(piece), end);
      if (quads_of({plan.lines[at(left)], plan.lines[at(right)], 1}) == 0) continue;
      add_quads(points_of(plan.lines[at(left)]), points_of(plan.lines[at(right)]), 1);
    }
  }
  return enclosed_volume(closed.vertices, closed.triangles);
}

/// Adds up cells, and expects each of their component tets to be positive.
class LayerCellSums {
 public:
  void add(ElementType type, const std::vector<Vec3>& p) {
    for (const auto& tet : component_tets(type)) {
      EXPECT_GT(orient3d(p[tet[0]], p[tet[1]], p[tet[2]], p[tet[3]]), 0);
    }
    volume_ += element_volume(type, p);
    figures_.prisms += type == ElementType::prism ? 1 : 0;
    figures_.pyramids += type == ElementType::pyramid ? 1 : 0;
    figures_.tets += type == ElementType::tet ? 1 : 0;
  }

  /// Those above a triangle of these lines from a layer on.
  void add_column(const LayerPlan& plan, const std::array<std::int32_t, 3>& lines, int from) {
    LayerColumn column;
    std::array<std::vector<Vec3>, 3> points;
    for (std::size_t k = 0; k < 3; ++k) {
      const LayerLine& line = plan.lines[at(lines[k])];
      column.stops[k] = line.stop;
      column.early[k] = line.early;
      points[k] = points_of(line);
    }
    for (int layer = from; layer <= layers_above(column.stops); ++layer) {
      for (const LayerCell& cell : cells_of_layer(column, layer)) {
        std::vector<Vec3> p;
        for (std::size_t k = 0; k < nodes_of(cell.type); ++k) {
          p.push_back(points[at(cell.nodes[k].corner)][at(cell.nodes[k].level)]);
        }
        add(cell.type, p);
      }
    }
  }

  void add_fan(const LayerPlan& plan, const FanPiece& piece) {
    const PieceLines lines = lines_of(plan, piece);
    for (const FanCell& cell : base_cells(lines)) {
      std::vector<Vec3> p;
      for (std::size_t k = 0; k < nodes_of(cell.type); ++k) {
        p.push_back(base_points(lines)[cell.nodes[k]]);
      }
      add(cell.type, p);
    }
    for (const auto& [a, b, c] : open_triangles(plan, piece)) add_column(plan, {a, b, c}, 2);
  }

  const LayerFigures& figures() const { return figures_; }
  double volume() const { return static_cast<double>(volume_); }

 private:
  LayerFigures figures_;
  long double volume_ = 0;
};

/// A line that has fewer layers than wanted tells why, and stops differ by `step` at most, in a
/// fan by none.
inline void expect_right_stops(const LayerPlan& plan, const std::array<std::int32_t, 3>& lines,
                               int step) {
  for (std::size_t k = 0; k < 3; ++k) {
    const LayerLine& line = plan.lines[at(lines[k])];
    const LayerLine& next = plan.lines[at(lines[(k + 1) % 3])];
    EXPECT_LE(line.stop, line.wanted);
    EXPECT_EQ(line.reason == StopReason::complete, line.stop == line.wanted)
        << name_of(line.reason) << ' ' << line.stop << ' ' << line.wanted;
    EXPECT_LE(std::abs(line.stop - next.stop), line.foot == next.foot ? 0 : step);
  }
}

/// Every component tet is positive, stops are right, and what is left is a domain without defects,
/// turned as the surface was, of the volume that the cells leave.
inline LayerFigures expect_valid_layers(const LayerPlan& plan, const SurfaceMesh& surface,
                                        int step = 1) {
  LayerCellSums sums;
  std::int64_t full = 0;
  for (const std::int32_t t : plan.wall) {
    const auto lines = lines_of(plan, surface, t);
    expect_right_stops(plan, lines, step);
    full += std::all_of(lines.begin(), lines.end(), [&plan](std::int32_t line) {
      return plan.lines[at(line)].stop == plan.lines[at(line)].wanted;
    });
    sums.add_column(plan, lines, 1);
  }
  for (const FanPiece& piece : plan.fans) {
    for (const auto& [a, b, c] : open_triangles(plan, piece)) {
      expect_right_stops(plan, {a, b, c}, step);
    }
    sums.add_fan(plan, piece);
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
  EXPECT_NEAR(sums.volume(), whole - left, 1e-8 * whole);
  LayerFigures figures = sums.figures();
  figures.full = full;
  return figures;
}

}  // namespace tetfarm::test
