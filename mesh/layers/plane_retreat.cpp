#include "mesh/layers/plane_retreat.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/layers/layer_fan.h"
#include "mesh/layers/side_triangles.h"
#include "mesh/layers/unlayered_domain.h"
#include "mesh/planar/constrained_delaunay.h"
#include "mesh/planar/planar_mesh.h"

namespace tetfarm {
namespace {

/// A vertex counts as run past also where it is nearer to the top than so many of the last layers.
constexpr double last_heights_clear = 0.5;

/// Where loops cross, edges count that are no further from there than this share of the plane.
constexpr double place_of_crossing = 1e-9;

double distance_to_edge(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 way{b.x - a.x, b.y - a.y};
  const Vec2 from{p.x - a.x, p.y - a.y};
  const double length2 = way.x * way.x + way.y * way.y;
  const double share =
      length2 > 0 ? std::clamp((from.x * way.x + from.y * way.y) / length2, 0.0, 1.0) : 0;
  return std::hypot(from.x - share * way.x, from.y - share * way.y);
}

/// The corner of the triangle from which the edge runs. @pre there is one.
int corner_of(const Triangle& triangle, std::int32_t from, std::int32_t to) {
  for (int k = 0; k < 3; ++k) {
    if (triangle[at(k)] == from && triangle[at((k + 1) % 3)] == to) return k;
  }
  check_failed("a triangle is across an edge that it does not have", __FILE__, __LINE__);
}

/// What lies between two planes: of each vertex there the next ones.
class PlaneSeams {
 public:
  explicit PlaneSeams(const WallPlanes& planes) {
    for (std::size_t p = 0; p < planes.planes.size(); ++p) {
      for (const PlaneBorder& border : planes.planes[p].border) {
        const std::int32_t other = planes.plane_of_triangle[at(border.across)];
        if (other < 0) continue;
        next_[{static_cast<std::int32_t>(p), other, border.edge[0]}].push_back(border.edge[1]);
        next_[{other, static_cast<std::int32_t>(p), border.edge[0]}].push_back(border.edge[1]);
      }
    }
  }

  /// The vertex after `here` when one comes from `before`; nothing where the seam ends or forks.
  std::optional<std::int32_t> next(const PlanesOfLine& planes, std::int32_t here,
                                   std::int32_t before) const {
    const auto found = next_.find({planes[0], planes[1], here});
    if (found == next_.end()) return std::nullopt;
    std::optional<std::int32_t> next;
    for (const std::int32_t v : found->second) {
      if (v == before) continue;
      if (next) return std::nullopt;
      next = v;
    }
    return next;
  }

 private:
  std::map<std::array<std::int32_t, 3>, std::vector<std::int32_t>> next_;  // by planes and vertex
};

/// Makes a PlaneRetreat.
class Retreat {
 public:
  Retreat(const SurfaceMesh& surface, const WallPlanes& planes, const LayerPlan& plan)
      : surface_(surface),
        planes_(planes),
        plan_(plan),
        old2new_(surface.vertices.size(), -1),
        run_past_by_(surface.vertices.size(), -1) {
    is_left_.assign(planes.planes.size(), false);
    for (std::size_t i = 0; i < plan.lines.size(); ++i) {
      if (plan.lines[i].stop == 0) continue;
      for (const std::int32_t plane : planes.of_line[i]) {
        if (plane >= 0) is_left_[at(plane)] = true;
      }
    }
    made_.plan = plan;
    made_.surface.patch_names = surface.patch_names;
    made_.surface.region_names = surface.region_names;
  }

  /// @param is_filled whether a plane is to have nodes within it.
  PlaneRetreat make(const PlaneSpacing& spacing, const std::vector<bool>& is_filled) {
    keep_vertices_of_rest();
    run_past_vertices();
    if (made_.tangled.empty()) {
      number_vertices();
      find_sides();
      add_line_vertices();
      add_triangles();
      renumber_plan();
      for (std::size_t p = 0; p < is_left_.size(); ++p) {
        if (is_left_[p]) fill(p, is_filled[p] ? spacing : PlaneSpacing{});
      }
    }
    if (made_.tangled.empty()) return std::move(made_);
    PlaneRetreat failed;
    failed.tangled = std::move(made_.tangled);
    std::sort(failed.tangled.begin(), failed.tangled.end());
    failed.tangled.erase(std::unique(failed.tangled.begin(), failed.tangled.end()),
                         failed.tangled.end());
    return failed;
  }

 private:
  bool is_left(std::int32_t triangle) const {
    const std::int32_t plane = planes_.plane_of_triangle[at(triangle)];
    return plane >= 0 && is_left_[at(plane)];
  }

  const LayerLine& line(std::int32_t number) const { return plan_.lines[at(number)]; }

  /// The line with layers that runs in the plane from this vertex, or past it; else -1.
  std::int32_t line_from(std::int32_t vertex, std::size_t plane) const {
    const std::int32_t here =
        run_past_by_[at(vertex)] >= 0 ? run_past_by_[at(vertex)] : plan_.vertex2line[at(vertex)];
    if (here < 0 || line(here).stop == 0) return -1;
    return planes_.hold_in(at(here), static_cast<std::int32_t>(plane)) ? here : -1;
  }

  /// The line of a vertex at an edge of the plane's border; else -1.
  std::int32_t line_at_border(const PlaneBorder& border, std::size_t end, std::size_t plane) const {
    const std::int32_t vertex = border.edge[end];
    const std::int32_t first = line_from(vertex, plane);
    if (first < 0 || first != plan_.vertex2line[at(vertex)] || !is_wall(border.across)) {
      return first;
    }
    const Triangle& nodes = surface_.triangles[at(border.across)];
    const auto corner = std::find(nodes.begin(), nodes.end(), vertex) - nodes.begin();
    return lines_of(plan_, surface_, border.across)[at(corner)];
  }

  bool is_wall(std::int32_t triangle) const {
    return std::binary_search(plan_.wall.begin(), plan_.wall.end(), triangle);
  }

  /// What stands for a vertex of the plane's old border in its new one, where its line is this.
  std::int32_t moved(std::int32_t vertex, std::int32_t from) const {
    return from < 0 ? old2new_[at(vertex)] : top_vertex(from);
  }

  std::int32_t top_vertex(std::int32_t number) const {
    const LayerLine& l = made_.plan.lines[at(number)];
    return vertex_at(l, l.stop);
  }

  /// Lines along the seam of two planes leave out what they run past.
  void run_past_vertices() {
    const PlaneSeams seams(planes_);
    for (std::size_t i = 0; i < plan_.lines.size(); ++i) {
      if (plan_.lines[i].stop == 0 || planes_.of_line[i][1] < 0) continue;
      if (!runs_past(static_cast<std::int32_t>(i), seams)) {
        made_.tangled.push_back(static_cast<std::int32_t>(i));
      }
    }
  }

  bool runs_past(std::int32_t number, const PlaneSeams& seams) {
    const LayerLine& along = line(number);
    const Vec3 top = point_of(along, along.stop);
    const double reach = distance(along.at, top) +
                         last_heights_clear * distance(point_of(along, along.stop - 1), top);
    std::int32_t before = -1;
    std::int32_t here = along.foot;
    while (true) {
      const std::optional<std::int32_t> next =
          seams.next(planes_.of_line[at(number)], here, before);
      if (!next) return false;
      if (distance(along.at, surface_.vertices[at(*next)]) >= reach) return true;
      if (old2new_[at(*next)] >= 0 || run_past_by_[at(*next)] >= 0) return false;
      run_past_by_[at(*next)] = number;
      before = std::exchange(here, *next);
    }
  }

  /// Those of triangles that stay.
  void keep_vertices_of_rest() {
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      if (is_left(static_cast<std::int32_t>(t))) continue;
      for (const std::int32_t v : surface_.triangles[t]) old2new_[at(v)] = 0;
    }
  }

  /// Those of the borders too, and numbers all.
  void number_vertices() {
    for (std::size_t p = 0; p < is_left_.size(); ++p) {
      if (!is_left_[p]) continue;
      for (const PlaneBorder& border : planes_.planes[p].border) {
        for (const std::int32_t v : border.edge) {
          if (run_past_by_[at(v)] < 0) old2new_[at(v)] = 0;
        }
      }
    }
    std::vector<Vec3>& vertices = made_.surface.vertices;
    for (std::size_t v = 0; v < old2new_.size(); ++v) {
      if (old2new_[v] < 0) continue;
      old2new_[v] = static_cast<std::int32_t>(vertices.size());
      vertices.push_back(surface_.vertices[v]);
    }
  }

  /// Edges between wall and plane from which layers grow on either end.
  void find_sides() {
    for (std::size_t p = 0; p < is_left_.size(); ++p) {
      if (!is_left_[p]) continue;
      ++made_.figures.planes;
      made_.figures.triangles_before += std::ssize(planes_.planes[p].triangles);
      for (const auto& [edge, across] : planes_.planes[p].border) {
        if (!is_wall(across)) continue;
        if (line_from(edge[0], p) < 0 && line_from(edge[1], p) < 0) continue;
        made_.plan.sides.push_back({across,
                                    corner_of(surface_.triangles[at(across)], edge[1], edge[0]),
                                    planes_.planes[p].patch, -1});
      }
    }
    std::sort(made_.plan.sides.begin(), made_.plan.sides.end(),
              [](const LayerSide& a, const LayerSide& b) {
                return std::tie(a.triangle, a.corner) < std::tie(b.triangle, b.corner);
              });
    for (FanPiece& piece : made_.plan.fans) {
      for (std::size_t end = 0; end < piece.ends.size(); ++end) {
        const std::int32_t plane = plane_of_end(piece, end);
        if (plane >= 0) piece.ends.at(end).patch = planes_.planes[at(plane)].patch;
      }
    }
  }

  /// The plane in which the piece has a side at that end; -1: none.
  std::int32_t plane_of_end(const FanPiece& piece, std::size_t end) const {
    const auto [left, right] = lines_at_end(numbers_of(piece), end);
    return left == right || line(left).stop == 0 ? -1 : planes_.of_line[at(left)][0];
  }

  /// The lines of a side, as its plane has the edge.
  std::array<std::int32_t, 2> lines_of_side(const LayerSide& side) const {
    const std::array<std::int32_t, 3> lines = tetfarm::lines_of(plan_, surface_, side.triangle);
    return {lines[at((side.corner + 1) % 3)], lines[at(side.corner)]};
  }

  void add_line_vertices() {
    std::vector<LayerLine>& lines = made_.plan.lines;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].stop == 0 || !planes_.holds(i)) continue;
      lines[i].vertices = lines[i].in_tets ? lines[i].stop : 1;
    }
    for_each_end([&](const FanPiece&, FanEnd&, std::int32_t left, std::int32_t right) {
      lines[at(left)].low_vertex = lines[at(right)].low_vertex = 0;
    });
    for (const LayerSide& side : made_.plan.sides) {
      const auto [a, b] = lines_of_side(side);
      for (const auto& [higher, lower] : {std::pair{a, b}, std::pair{b, a}}) {
        // Its points from the lower line's top on, or all; feet are vertices as they are.
        const int needed = is_divided({line(a), line(b)})
                               ? line(higher).stop
                               : line(higher).stop - std::max(line(lower).stop, 1) + 1;
        lines[at(higher)].vertices = std::max(lines[at(higher)].vertices, needed);
      }
    }
    std::vector<Vec3>& vertices = made_.surface.vertices;
    for (LayerLine& l : lines) {
      if (l.vertices == l.stop) l.low_vertex = -1;
      if (l.vertices == 0) continue;
      if (l.low_vertex >= 0) {
        l.low_vertex = static_cast<std::int32_t>(vertices.size());
        vertices.push_back(point_of(l, 1));
      }
      l.first_vertex = static_cast<std::int32_t>(vertices.size());
      const std::vector<Vec3> points = points_of(l);
      vertices.insert(vertices.end(), points.end() - l.vertices, points.end());
    }
  }

  /// Calls visit(piece, end, left line, right line) for those in planes.
  template <class Visit>
  void for_each_end(const Visit& visit) {
    for (FanPiece& piece : made_.plan.fans) {
      for (std::size_t end = 0; end < piece.ends.size(); ++end) {
        if (piece.ends.at(end).patch < 0) continue;
        const auto [left, right] = lines_at_end(numbers_of(piece), end);
        visit(piece, piece.ends.at(end), left, right);
      }
    }
  }

  void add_triangle(const Triangle& triangle, std::int32_t patch) {
    made_.surface.triangles.push_back(triangle);
    if (!surface_.patch_of_triangle.empty()) made_.surface.patch_of_triangle.push_back(patch);
    if (!surface_.sides.empty()) made_.surface.sides.push_back({1, 0});
  }

  /// Those that stay, and those of the sides.
  void add_triangles() {
    new_triangle_.assign(surface_.triangles.size(), -1);
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      if (is_left(static_cast<std::int32_t>(t))) continue;
      new_triangle_[t] = static_cast<std::int32_t>(made_.surface.triangles.size());
      Triangle nodes = surface_.triangles[t];
      for (std::int32_t& v : nodes) v = old2new_[at(v)];
      add_triangle(nodes, patch_of(surface_, t));
    }
    for (LayerSide& side : made_.plan.sides) {
      const auto [a, b] = lines_of_side(side);
      const auto first = static_cast<std::int32_t>(made_.surface.triangles.size());
      add_side({a, b}, 0, side.patch);
      if (made_.surface.triangles.size() > at(first)) side.last = first;
    }
    for_each_end([&](const FanPiece&, FanEnd& end, std::int32_t left, std::int32_t right) {
      end.triangle = static_cast<std::int32_t>(made_.surface.triangles.size());
      add_side_triangle({vertex_of(left, 0), vertex_of(right, 1), vertex_of(left, 1)}, end.patch);
      add_side({left, right}, 1, end.patch);
    });
  }

  /// What is between two lines from a level on.
  void add_side(const std::array<std::int32_t, 2>& numbers, int first_level, std::int32_t patch) {
    const std::vector<LayerLine>& lines = made_.plan.lines;
    const LineSide side = {lines[at(numbers[0])], lines[at(numbers[1])], first_level};
    made_.figures.quads += quads_of(side);
    for (const SideTriangle& triangle : triangles_of(side)) {
      Triangle vertices{};
      std::transform(triangle.begin(), triangle.end(), vertices.begin(), [&](const SideNode& node) {
        return vertex_of(numbers.at(at(node.end)), node.level);
      });
      add_side_triangle(vertices, patch);
    }
  }

  void add_side_triangle(const Triangle& triangle, std::int32_t patch) {
    add_triangle(triangle, patch);
    ++made_.figures.side_triangles;
  }

  std::int32_t vertex_of(std::int32_t number, int level) const {
    const LayerLine& l = made_.plan.lines[at(number)];
    return level == 0 ? old2new_[at(l.foot)] : vertex_at(l, level);
  }

  void renumber_plan() {
    LayerPlan& plan = made_.plan;
    plan.vertex2line.assign(made_.surface.vertices.size(), -1);
    for (std::size_t i = 0; i < plan.lines.size(); ++i) {
      LayerLine& l = plan.lines[i];
      l.foot = old2new_[at(l.foot)];
      if (l.because_of >= 0) l.because_of = old2new_[at(l.because_of)];
      std::int32_t& first = plan.vertex2line[at(l.foot)];
      if (first < 0) first = static_cast<std::int32_t>(i);
    }
    for (std::int32_t& t : plan.wall) t = new_triangle_[at(t)];
    for (FanCorner& corner : plan.fan_corners) corner.triangle = new_triangle_[at(corner.triangle)];
    for (FanPiece& piece : plan.fans) piece.beside = new_triangle_[at(piece.beside)];
    for (LayerSide& side : plan.sides) side.triangle = new_triangle_[at(side.triangle)];
  }

  /// The new border of a plane, by the vertices of the new surface.
  struct Loops {
    PlanarRegion region;
    std::vector<std::int32_t> vertices;              // of each point
    std::vector<std::array<std::int32_t, 2>> lines;  // of each edge those at its ends; -1: none
  };

  Loops loops_of(std::size_t plane) const {
    Loops loops;
    std::map<std::int32_t, std::int32_t> points;
    const auto point_at = [&](std::int32_t vertex) {
      const auto [found, is_new] =
          points.emplace(vertex, static_cast<std::int32_t>(loops.vertices.size()));
      if (is_new) {
        loops.vertices.push_back(vertex);
        loops.region.points.push_back(
            planes_.planes[plane].project(made_.surface.vertices[at(vertex)]));
      }
      return found->second;
    };
    const auto add_edge = [&](std::int32_t from, std::int32_t to, std::int32_t first_line,
                              std::int32_t last_line) {
      if (from == to) return;
      const std::int32_t first = point_at(from);
      loops.region.edges.push_back({first, point_at(to)});
      loops.lines.push_back({first_line, last_line});
    };
    for (const PlaneBorder& border : planes_.planes[plane].border) {
      const std::int32_t first_line = line_at_border(border, 0, plane);
      const std::int32_t last_line = line_at_border(border, 1, plane);
      add_edge(moved(border.edge[0], first_line), moved(border.edge[1], last_line), first_line,
               last_line);
    }
    for (const FanPiece& piece : made_.plan.fans) {
      for (std::size_t end = 0; end < piece.ends.size(); ++end) {
        if (piece.ends.at(end).patch < 0) continue;
        if (plane_of_end(piece, end) != static_cast<std::int32_t>(plane)) continue;
        const auto [left, right] = lines_at_end(numbers_of(piece), end);
        add_edge(top_vertex(left), top_vertex(right), left, right);
      }
    }
    return loops;
  }

  void fill(std::size_t plane, const PlaneSpacing& spacing) {
    const Loops loops = loops_of(plane);
    const WallPlane& here = planes_.planes[plane];
    PlanarMesh mesh;
    std::optional<PlanarFailure> failure;
    if (spacing) {
      PlanarResult result =
          mesh_region(loops.region, [&](const Vec2& point) { return spacing(here.lift(point)); });
      mesh = std::move(result.mesh);
      failure = std::move(result.failure);
    } else {
      ConstrainedDelaunay result = constrained_delaunay(loops.region);
      mesh = {std::move(result.complex.points), std::move(result.complex.triangles)};
      failure = std::move(result.failure);
    }
    if (failure) {
      add_tangled(plane, loops, *failure);
      return;
    }
    std::vector<std::int32_t> vertices = loops.vertices;
    for (std::size_t i = vertices.size(); i < mesh.points.size(); ++i) {
      vertices.push_back(static_cast<std::int32_t>(made_.surface.vertices.size()));
      made_.surface.vertices.push_back(here.lift(mesh.points[i]));
    }
    made_.plan.vertex2line.resize(made_.surface.vertices.size(), -1);
    for (const auto& [a, b, c] : mesh.triangles) {
      add_triangle({vertices[at(a)], vertices[at(b)], vertices[at(c)]}, here.patch);
    }
    made_.figures.triangles_after += std::ssize(mesh.triangles);
  }

  /// The lines of the edges at each place of the failure; all of the plane where there are none.
  void add_tangled(std::size_t plane, const Loops& loops, const PlanarFailure& failure) {
    const std::size_t before = made_.tangled.size();
    const auto add_lines = [this](const std::array<std::int32_t, 2>& lines) {
      for (const std::int32_t number : lines) {
        if (number >= 0) made_.tangled.push_back(number);
      }
    };
    double extent = 0;
    for (const Vec2& p : loops.region.points) {
      extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
    }
    for (const Vec2& place : failure.where) {
      std::vector<std::pair<double, std::size_t>> near;
      for (std::size_t e = 0; e < loops.lines.size(); ++e) {
        if (std::max(loops.lines[e][0], loops.lines[e][1]) < 0) continue;
        const auto& [a, b] = loops.region.edges[e];
        near.emplace_back(
            distance_to_edge(place, loops.region.points[at(a)], loops.region.points[at(b)]), e);
      }
      std::sort(near.begin(), near.end());
      for (const auto& [distance, e] : near) {
        if (distance > near.front().first + place_of_crossing * extent) break;
        add_lines(loops.lines[e]);
      }
    }
    if (made_.tangled.size() > before) return;
    for (std::size_t i = 0; i < plan_.lines.size(); ++i) {
      if (plan_.lines[i].stop > 0 && planes_.hold_in(i, static_cast<std::int32_t>(plane))) {
        made_.tangled.push_back(static_cast<std::int32_t>(i));
      }
    }
    TF_CHECK(made_.tangled.size() > before);
  }

  const SurfaceMesh& surface_;
  const WallPlanes& planes_;
  const LayerPlan& plan_;
  std::vector<bool> is_left_;               // of each plane, whether it is triangulated anew
  std::vector<std::int32_t> old2new_;       // of each vertex; -1: left out
  std::vector<std::int32_t> run_past_by_;   // of each vertex the line, or -1
  std::vector<std::int32_t> new_triangle_;  // of each triangle; -1: left out
  PlaneRetreat made_;
};

}  // namespace

bool runs_in_plane(const LayerPlan& plan, const WallPlanes& planes) {
  TF_CHECK(plan.lines.size() == planes.of_line.size());
  for (std::size_t i = 0; i < plan.lines.size(); ++i) {
    if (plan.lines[i].stop > 0 && planes.holds(i)) return true;
  }
  return false;
}

PlaneRetreat retreat_planes(const SurfaceMesh& surface, const WallPlanes& planes,
                            const LayerPlan& plan, const PlaneSpacing& spacing) {
  TF_CHECK(plan.sides.empty() && plan.vertex2line.size() == surface.vertices.size());
  return Retreat(surface, planes, plan)
      .make(spacing, std::vector<bool>(planes.planes.size(), true));
}

namespace {

/// Old triangles of planes count for the spacing from so many heights of the layers on.
constexpr double heights_to_old_plane = 2;

/// The triangles of the planes that no line is near.
std::vector<std::int32_t> far_triangles(const SurfaceMesh& surface, const WallPlanes& planes,
                                        const LayerPlan& plan) {
  std::vector<Box3> near;
  for (std::size_t i = 0; i < plan.lines.size(); ++i) {
    const LayerLine& line = plan.lines[i];
    if (line.stop == 0 || !planes.holds(i)) continue;
    const double reach = heights_to_old_plane * distance(line.at, point_of(line, line.stop));
    const Vec3 round{reach, reach, reach};
    near.push_back({line.at - round, line.at + round});
  }
  const BoxTree tree(near);
  std::vector<std::int32_t> far;
  for (const WallPlane& plane : planes.planes) {
    for (const std::int32_t t : plane.triangles) {
      Box3 box;
      for (const std::int32_t v : surface.triangles[at(t)]) box.add(surface.vertices[at(v)]);
      bool is_near = false;
      tree.query(box, [&is_near](std::int32_t) { is_near = true; });
      if (!is_near) far.push_back(t);
    }
  }
  return far;
}

/// What the spacing within the planes is made from.
SurfaceMesh surface_for_spacing(const SurfaceMesh& surface, const WallPlanes& planes,
                                const LayerPlan& plan, const PlaneRetreat& unfilled) {
  const UnlayeredDomain rest = unlayered_domain(unfilled.plan, unfilled.surface, TreePath{2}, 1);
  const auto of_planes = std::ssize(unfilled.surface.triangles) - unfilled.figures.triangles_after;
  SurfaceMesh round;
  round.vertices = rest.root.vertices;
  for (std::size_t t = 0; t < rest.root.triangles.size(); ++t) {
    if (rest.stands_for[t] < of_planes) round.triangles.push_back(rest.root.triangles[t]);
  }
  for (const std::int32_t t : far_triangles(surface, planes, plan)) {
    Triangle nodes = surface.triangles[at(t)];
    for (std::int32_t& v : nodes) {
      round.vertices.push_back(surface.vertices[at(v)]);
      v = static_cast<std::int32_t>(round.vertices.size()) - 1;
    }
    round.triangles.push_back(nodes);
  }
  return round;
}

/// Whether what the layers leave is a domain.
bool leaves_domain(const PlaneRetreat& made) {
  const Subdomain root = unlayered_domain(made.plan, made.surface, TreePath{2}, 1).root;
  const SurfaceMesh rest{root.vertices, root.triangles, {}, {}, {}, {}};
  return check_surface(rest).report.defects.empty();
}

}  // namespace

std::optional<PlaneRetreat> retreat_planes(const SurfaceMesh& surface, const LayerPlan& plan,
                                           const MakePlaneSpacing& make_spacing) {
  const WallPlanes planes = wall_planes(surface, graph_of(plan, surface));
  if (!runs_in_plane(plan, planes)) return std::nullopt;
  const PlaneRetreat unfilled = retreat_planes(surface, planes, plan, PlaneSpacing{});
  TF_CHECK(unfilled.tangled.empty());
  const PlaneSpacing spacing = make_spacing(surface_for_spacing(surface, planes, plan, unfilled));
  PlaneRetreat made = retreat_planes(surface, planes, plan, spacing);
  TF_CHECK(made.tangled.empty());
  std::vector<bool> has_axis;
  for (const WallPlane& plane : planes.planes) has_axis.push_back(plane.axis >= 0);
  const bool all_have = std::find(has_axis.begin(), has_axis.end(), false) == has_axis.end();
  if (all_have || leaves_domain(made)) return made;
  return Retreat(surface, planes, plan).make(spacing, has_axis);
}

}  // namespace tetfarm
