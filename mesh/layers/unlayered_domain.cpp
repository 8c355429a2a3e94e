#include "mesh/layers/unlayered_domain.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/layers/layer_fan.h"
#include "mesh/layers/side_triangles.h"

namespace tetfarm {
namespace {

/// The nodes of the surface that are on the boundary still, then the tops of the lines.
class BoundaryNodes {
 public:
  BoundaryNodes(const SurfaceMesh& surface, std::size_t lines)
      : surface_(surface), of_vertex_(surface.vertices.size(), -1), of_line_(lines, -1) {}

  void use_vertex(std::int32_t vertex) { of_vertex_[at(vertex)] = 0; }

  /// Numbers what is used, and the top of each line that has layers.
  void number(const LayerPlan& plan, std::uint64_t owner_of_top, Subdomain& root) {
    for (std::size_t v = 0; v < of_vertex_.size(); ++v) {
      if (of_vertex_[v] < 0) continue;
      of_vertex_[v] = static_cast<std::int32_t>(root.vertices.size());
      root.vertices.push_back(surface_.vertices[v]);
      root.node_origin.push_back({0, static_cast<std::uint32_t>(v)});
    }
    std::uint32_t top = 0;
    for (std::size_t i = 0; i < plan.lines.size(); ++i) {
      const LayerLine& line = plan.lines[i];
      if (line.stop == 0) continue;
      if (line.vertices > 0) {
        of_line_[i] = of_vertex(vertex_at(line, line.stop));
        continue;
      }
      if (!has_top(line)) continue;
      of_line_[i] = static_cast<std::int32_t>(root.vertices.size());
      root.vertices.push_back(point_of(line, line.stop));
      root.node_origin.push_back({owner_of_top, top++});
    }
    for (std::size_t i = 0; i < plan.lines.size(); ++i) {
      const LineEnd& end = plan.lines[i].end;
      if (end.line >= 0 && end.depth == 0) of_line_[i] = of_line_[at(end.line)];
    }
  }

  std::int32_t of_vertex(std::int32_t vertex) const { return of_vertex_[at(vertex)]; }
  Triangle tops_of(const LayerPlan& plan, Triangle lines) const {
    for (std::int32_t& line : lines) {
      const LayerLine& l = plan.lines[at(line)];
      line = l.stop > 0 ? of_line_[at(line)] : of_vertex(l.foot);
    }
    return lines;
  }

 private:
  const SurfaceMesh& surface_;
  std::vector<std::int32_t> of_vertex_;
  std::vector<std::int32_t> of_line_;
};

/// Of each triangle of the surface, whether it is of a side of the layers.
std::vector<bool> triangles_of_sides(const LayerPlan& plan, const SurfaceMesh& surface) {
  std::vector<bool> is_of_side(surface.triangles.size(), false);
  const auto mark = [&is_of_side](std::int32_t first, const std::vector<SideTriangle>& triangles) {
    for (std::size_t i = 0; i < triangles.size(); ++i) is_of_side[at(first) + i] = true;
  };
  for (const LayerSide& side : plan.sides) {
    if (side.last < 0) continue;
    const std::array<std::int32_t, 3> lines = lines_of(plan, surface, side.triangle);
    mark(side.last, triangles_of({plan.lines[at(lines[at((side.corner + 1) % 3)])],
                                  plan.lines[at(lines[at(side.corner)])]}));
  }
  for (const FanPiece& piece : plan.fans) {
    for (std::size_t end = 0; end < piece.ends.size(); ++end) {
      const std::int32_t first = piece.ends.at(end).triangle;
      if (first < 0) continue;
      is_of_side[at(first)] = true;
      const auto [left, right] = lines_at_end(numbers_of(piece), end);
      mark(first + 1, triangles_of({plan.lines[at(left)], plan.lines[at(right)], 1}));
    }
  }
  return is_of_side;
}

/// Of each triangle of the surface, whether the layers above it end on others.
std::vector<bool> triangles_outside(const LayerPlan& plan, const SurfaceMesh& surface) {
  std::vector<bool> is_outside(surface.triangles.size(), false);
  for (const std::int32_t t : plan.wall) {
    const std::array<std::int32_t, 3> lines = lines_of(plan, surface, t);
    is_outside[at(t)] = std::any_of(lines.begin(), lines.end(), [&](std::int32_t l) {
      return plan.lines[at(l)].end.depth > 0;
    });
  }
  return is_outside;
}

/// Of each triangle of the surface, whether there are cells above it.
std::vector<bool> triangles_with_cells(const LayerPlan& plan, const SurfaceMesh& surface) {
  std::vector<bool> has_cells(surface.triangles.size(), false);
  for (const std::int32_t t : plan.wall) {
    const std::array<std::int32_t, 3> lines = lines_of(plan, surface, t);
    has_cells[at(t)] = std::any_of(lines.begin(), lines.end(),
                                   [&](std::int32_t l) { return plan.lines[at(l)].stop > 0; });
  }
  return has_cells;
}

}  // namespace

UnlayeredDomain unlayered_domain(const LayerPlan& plan, const SurfaceMesh& surface, TreePath path,
                                 std::uint64_t owner_of_top) {
  TF_CHECK(owner_of_top != 0 && plan.vertex2line.size() == surface.vertices.size());
  UnlayeredDomain domain;
  Subdomain& root = domain.root;
  root.path = path;
  const std::vector<bool> has_cells = triangles_with_cells(plan, surface);
  std::vector<bool> is_left_out = triangles_of_sides(plan, surface);
  const std::vector<bool> is_outside = triangles_outside(plan, surface);
  std::transform(is_left_out.begin(), is_left_out.end(), is_outside.begin(), is_left_out.begin(),
                 std::logical_or<>());
  BoundaryNodes nodes(surface, plan.lines.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (is_left_out[t]) continue;
    if (!has_cells[t]) {
      for (const std::int32_t v : surface.triangles[t]) nodes.use_vertex(v);
      continue;
    }
    for (const std::int32_t number : lines_of(plan, surface, static_cast<std::int32_t>(t))) {
      const LayerLine& line = plan.lines[at(number)];
      const std::int32_t top = vertex_at(line, line.stop);
      if (top >= 0) nodes.use_vertex(top);
    }
  }
  nodes.number(plan, owner_of_top, root);
  std::uint32_t top = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (is_left_out[t]) continue;
    Triangle triangle = surface.triangles[t];
    if (has_cells[t]) {
      const auto [a, b, c] = lines_of(plan, surface, static_cast<std::int32_t>(t));
      triangle = nodes.tops_of(plan, {a, b, c});
    } else {
      for (std::int32_t& v : triangle) v = nodes.of_vertex(v);
    }
    TF_CHECK(*std::min_element(triangle.begin(), triangle.end()) >= 0);
    root.triangles.push_back(triangle);
    domain.stands_for.push_back(static_cast<std::int32_t>(t));
    root.triangle_origin.push_back(has_cells[t] ? Origin{owner_of_top, top++}
                                                : Origin{0, static_cast<std::uint32_t>(t)});
  }
  for (const FanPiece& piece : plan.fans) {
    for (const Triangle& lines : open_triangles(plan, piece)) {
      root.triangles.push_back(nodes.tops_of(plan, lines));
      domain.stands_for.push_back(piece.beside);
      domain.lines_of_fans.push_back(lines);
      root.triangle_origin.push_back({owner_of_top, top++});
    }
  }
  domain.top_triangles = top;
  domain.top_nodes = std::count_if(plan.lines.begin(), plan.lines.end(), has_top);
  return domain;
}

}  // namespace tetfarm
