#include "mesh/layers/pml_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/array_index.h"
#include "base/check.h"
#include "base/counted.h"
#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/layers/layer_proof.h"
#include "mesh/layers/pml_offset.h"
#include "mesh/layers/side_triangles.h"

namespace tetfarm {
namespace {

constexpr const char* blocks_place = "absorbing layers with corners = \"block\"";

/// One of the six planes of the box round a surface.
struct BoxPlane {
  int axis = 0;
  bool is_high = false;
  double at = 0;
};

/// In the order in which their faces are extruded.
std::array<BoxPlane, 6> planes_of(const Box3& box) {
  std::array<BoxPlane, 6> planes;
  for (int axis = 0; axis < 3; ++axis) {
    planes.at(at(2 * axis)) = {axis, false, box.low[axis]};
    planes.at(at(2 * axis + 1)) = {axis, true, box.high[axis]};
  }
  return planes;
}

Box3 box_round(const SurfaceMesh& surface) {
  Box3 box;
  for (const Triangle& t : surface.triangles) {
    for (const std::int32_t v : t) box.add(surface.vertices[at(v)]);
  }
  return box;
}

[[noreturn]] void refuse_face(const SurfaceMesh& surface, std::size_t triangle) {
  throw UsageError("they go beyond planes across x, y and z that bound the domain, and triangle " +
                       std::to_string(triangle) + " at " +
                       text_of(surface.vertices[at(surface.triangles[triangle][0])]) +
                       " lies in none of them; take corners = \"mitre\", or leave its patch out",
                   blocks_place);
}

/// The plane of each triangle of the patches, as a number among planes_of; -1: it is of others.
std::vector<std::int32_t> planes_of_triangles(const SurfaceMesh& surface, const Box3& box,
                                              std::span<const std::int32_t> patches) {
  const std::array<BoxPlane, 6> planes = planes_of(box);
  std::vector<std::int32_t> found(surface.triangles.size(), -1);
  for (std::size_t t = 0; t < found.size(); ++t) {
    if (!std::binary_search(patches.begin(), patches.end(), patch_of(surface, t))) continue;
    const Triangle& triangle = surface.triangles[t];
    const auto plane = std::find_if(planes.begin(), planes.end(), [&](const BoxPlane& p) {
      const double tolerance = same_plane_sine * (box.high[p.axis] - box.low[p.axis]);
      return std::all_of(triangle.begin(), triangle.end(), [&](std::int32_t v) {
        return std::abs(surface.vertices[at(v)][p.axis] - p.at) <= tolerance;
      });
    });
    if (plane == planes.end()) refuse_face(surface, t);
    found[t] = static_cast<std::int32_t>(plane - planes.begin());
  }
  return found;
}

/// Where a node is: so many layers beyond a vertex of the given surface along each axis.
struct BlockPlace {
  std::int32_t base = 0;
  std::array<int, 3> steps{};

  friend auto operator<=>(const BlockPlace&, const BlockPlace&) = default;
};

/// A line as it was made; its numbers of vertices are right when all are made.
struct BlockLine {
  LayerLine line;
  BlockPlace end;
  int axis = 0;
  bool is_at_border = false;  ///< of its face: its points were vertices when it was made
  std::int32_t first = -1;    ///< then those of levels 1 and up, but for the last
  std::int32_t last = -1;     ///< and that
};

/// Extrudes faces of a surface, one after the other.
class BlockExtrusion {
 public:
  /// @pre `request` outlives this.
  BlockExtrusion(const SurfaceMesh& surface, const PmlBlocksRequest& request)
      : patches_(request.patches),
        law_(request.law),
        layers_(request.layers),
        levels_(levels_of(law_, layers_)),
        result_(surface) {
    TF_CHECK(std::is_sorted(patches_.begin(), patches_.end()) && layers_ > 0);
    const Box3 box = box_round(surface);
    is_wall_.assign(surface.triangles.size(), false);
    for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
      places_.push_back({static_cast<std::int32_t>(v), {}});
    }
    move_into_planes(planes_of(box), planes_of_triangles(surface, box, patches_));
    for (const BoxPlane& plane : planes_of(box)) extrude(plane);
  }

  SurfaceMesh surface() && { return std::move(result_); }
  std::vector<BlockLine> lines() { return finished_lines(); }

  /// Triangles of the surface above which lines run, ascending.
  std::vector<std::int32_t> wall() const {
    std::vector<std::int32_t> wall;
    for (std::size_t t = 0; t < is_wall_.size(); ++t) {
      if (is_wall_[t]) wall.push_back(static_cast<std::int32_t>(t));
    }
    return wall;
  }

  /// Those that no further block has gone beyond, by triangle and corner.
  std::vector<LayerSide> sides() const {
    std::vector<LayerSide> sides;
    std::copy_if(sides_.begin(), sides_.end(), std::back_inserter(sides),
                 [this](const LayerSide& side) { return !is_wall_[at(side.last)]; });
    return sides;
  }

 private:
  /// Of all nodes of that level above the plane; the same for all, to the last bit.
  double coordinate(const BoxPlane& plane, int level) const {
    const double outside = plane.is_high ? plane.at + levels_.back() : plane.at - levels_.back();
    const double height = levels_[at(level)];
    return (plane.is_high ? outside - height : outside + height) + 0.0;  // no negative zero
  }

  void move_into_planes(const std::array<BoxPlane, 6>& planes,
                        const std::vector<std::int32_t>& plane_of_triangle) {
    for (std::size_t t = 0; t < plane_of_triangle.size(); ++t) {
      if (plane_of_triangle[t] < 0) continue;
      const BoxPlane& plane = planes.at(at(plane_of_triangle[t]));
      for (const std::int32_t v : result_.triangles[t]) {
        Vec3& p = result_.vertices[at(v)];
        p = p + Vec3{0, 0, 0};
        p[plane.axis] = coordinate(plane, layers_);
      }
    }
  }

  bool is_of_face(std::size_t t, const BoxPlane& plane) const {
    if (!std::binary_search(patches_.begin(), patches_.end(), patch_of(result_, t))) return false;
    const double inner = coordinate(plane, layers_);
    const Triangle& triangle = result_.triangles[t];
    return std::all_of(triangle.begin(), triangle.end(), [&](std::int32_t v) {
      return result_.vertices[at(v)][plane.axis] == inner;
    });
  }

  void extrude(const BoxPlane& plane) {
    std::vector<std::int32_t> face;
    is_in_face_.assign(result_.vertices.size(), false);
    for (std::size_t t = 0; t < result_.triangles.size(); ++t) {
      if (!is_of_face(t, plane)) continue;
      face.push_back(static_cast<std::int32_t>(t));
      is_wall_[t] = true;
      for (const std::int32_t v : result_.triangles[t]) is_in_face_[at(v)] = true;
    }
    if (face.empty()) return;
    find_border(face);
    add_lines(plane);
    for (const std::int32_t t : face) add_sides(t);
    for (const std::int32_t t : face) {
      for (std::int32_t& v : result_.triangles[at(t)]) v = line_at(v).line.foot;
    }
  }

  /// Which vertices of the face other triangles have, and the patches of those beyond its edges.
  void find_border(const std::vector<std::int32_t>& face) {
    std::vector<bool> is_of_it(result_.triangles.size(), false);
    for (const std::int32_t t : face) is_of_it[at(t)] = true;
    is_at_border_.assign(result_.vertices.size(), false);
    patch_beyond_.clear();
    for (std::size_t t = 0; t < result_.triangles.size(); ++t) {
      if (is_of_it[t]) continue;
      const Triangle& triangle = result_.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t v = triangle[k];
        const std::int32_t next = triangle[(k + 1) % 3];
        if (!is_in_face_[at(v)]) continue;
        is_at_border_[at(v)] = true;
        if (is_in_face_[at(next)]) patch_beyond_[{next, v}] = patch_of(result_, t);
      }
    }
  }

  void add_lines(const BoxPlane& plane) {
    line_of_vertex_.assign(result_.vertices.size(), -1);
    for (std::size_t v = 0; v < is_in_face_.size(); ++v) {
      if (!is_in_face_[v]) continue;
      line_of_vertex_[v] = static_cast<std::int32_t>(lines_.size());
      add_line(static_cast<std::int32_t>(v), plane);
    }
  }

  void add_line(std::int32_t v, const BoxPlane& plane) {
    BlockLine& added = lines_.emplace_back();
    added.end = places_[at(v)];
    added.axis = plane.axis;
    added.is_at_border = is_at_border_[at(v)];
    LayerLine& line = added.line;
    line.at = result_.vertices[at(v)];
    line.at[plane.axis] = coordinate(plane, 0);
    line.along[plane.axis] = plane.is_high ? -1 : 1;
    line.later = line.along;
    line.bends_from = line.bends_to = levels_.back();
    line.law = law_;
    line.stop = line.wanted = layers_;
    line.first_wanted = law_.first;
    line.of_pml = line.in_tets = true;
    line.foot = added.is_at_border ? static_cast<std::int32_t>(result_.vertices.size()) : v;
    line.because_of = line.foot;
    if (!added.is_at_border) {
      result_.vertices[at(v)] = line.at;
      places_[at(v)].steps.at(at(plane.axis)) = layers_;
      return;
    }
    added.first = line.foot + 1;
    added.last = v;
    for (int level = 0; level < layers_; ++level) {
      result_.vertices.push_back(point_of(line, level));
      places_.push_back(place_on(added, level));
    }
  }

  /// Of a point of the line.
  BlockPlace place_on(const BlockLine& line, int level) const {
    BlockPlace place = line.end;
    place.steps.at(at(line.axis)) = layers_ - level;
    return place;
  }

  const BlockLine& line_at(std::int32_t v) const { return lines_[at(line_of_vertex_[at(v)])]; }

  /// At the edges where the face ends.
  void add_sides(std::int32_t t) {
    for (int corner = 0; corner < 3; ++corner) {
      const std::int32_t a = result_.triangles[at(t)].at(at(corner));
      const std::int32_t b = result_.triangles[at(t)].at(at((corner + 1) % 3));
      const auto beyond = patch_beyond_.find({a, b});
      if (beyond == patch_beyond_.end()) continue;
      const std::array<const BlockLine*, 2> ends = {&line_at(b), &line_at(a)};
      sides_.push_back(
          {t, corner, beyond->second, static_cast<std::int32_t>(result_.triangles.size())});
      for (const SideTriangle& triangle : triangles_of({ends[0]->line, ends[1]->line})) {
        Triangle nodes{};
        std::transform(triangle.begin(), triangle.end(), nodes.begin(), [&](const SideNode& node) {
          return vertex_of(*ends.at(at(node.end)), node.level);
        });
        add_triangle(nodes, beyond->second);
      }
    }
  }

  std::int32_t vertex_of(const BlockLine& line, int level) const {
    if (level == 0) return line.line.foot;
    return level == layers_ ? line.last : line.first + level - 1;
  }

  void add_triangle(const Triangle& nodes, std::int32_t patch) {
    result_.triangles.push_back(nodes);
    if (!result_.patch_of_triangle.empty()) result_.patch_of_triangle.push_back(patch);
    if (!result_.sides.empty()) result_.sides.push_back({1, 0});
    is_wall_.push_back(false);
  }

  /// Tells each line where it ends: at a vertex, at a point of another line, or at a top.
  std::vector<BlockLine> finished_lines() {
    const std::map<BlockPlace, std::int32_t> vertices = vertices_at_places();
    std::map<BlockPlace, LineEnd> owned;
    for (std::size_t i = 0; i < lines_.size(); ++i) find_vertices(i, vertices, owned);
    std::vector<std::int32_t> tops(places_.size(), -1);
    for (std::size_t i = 0; i < lines_.size(); ++i) find_end(i, vertices, owned, tops);
    for (BlockLine& line : lines_) find_inner(line, vertices, tops);
    return std::move(lines_);
  }

  /// Of the points where lines of different axes may meet.
  std::map<BlockPlace, std::int32_t> vertices_at_places() const {
    std::map<BlockPlace, std::int32_t> vertices;
    std::vector<bool> has_line(places_.size(), false);
    for (const BlockLine& line : lines_) has_line[at(line.end.base)] = true;
    for (std::size_t v = 0; v < places_.size(); ++v) {
      if (has_line[at(places_[v].base)]) vertices[places_[v]] = static_cast<std::int32_t>(v);
    }
    return vertices;
  }

  void find_vertices(std::size_t i, const std::map<BlockPlace, std::int32_t>& vertices,
                     std::map<BlockPlace, LineEnd>& owned) {
    BlockLine& line = lines_[i];
    if (!line.is_at_border) return;
    for (int level = 1; level < layers_; ++level) {
      const BlockPlace place = place_on(line, level);
      if (vertices.contains(place)) {
        TF_CHECK(vertices.at(place) == line.first + level - 1);
        line.line.vertices = layers_;
        line.line.first_vertex = line.first;
      } else {
        TF_CHECK(line.line.vertices == 0);
        owned[place] = {static_cast<std::int32_t>(i), level};
      }
    }
  }

  void find_end(std::size_t i, const std::map<BlockPlace, std::int32_t>& vertices,
                const std::map<BlockPlace, LineEnd>& owned, std::vector<std::int32_t>& tops) {
    const BlockPlace& place = lines_[i].end;
    LayerLine& line = lines_[i].line;
    line.end.depth = *std::max_element(place.steps.begin(), place.steps.end());
    const auto vertex = vertices.find(place);
    if (vertex != vertices.end()) {
      if (line.vertices > 0) {
        line.end.vertex = vertex->second;
      } else {
        line.vertices = 1;
        line.first_vertex = vertex->second;
      }
      return;
    }
    TF_CHECK(line.vertices == 0);
    std::int32_t& top = tops[at(place.base)];
    if (line.end.depth > 0) {
      const LineEnd& other = owned.at(place);
      line.end.line = other.line;
      line.end.level = other.level;
    } else if (top < 0) {
      top = static_cast<std::int32_t>(i);
    } else {
      line.end.line = top;
      line.end.level = layers_;
    }
  }

  static void find_inner(BlockLine& line, const std::map<BlockPlace, std::int32_t>& vertices,
                         const std::vector<std::int32_t>& tops) {
    if (line.line.end.depth == 0) return;
    const auto vertex = vertices.find({line.end.base, {}});
    if (vertex != vertices.end()) {
      line.line.end.inner_vertex = vertex->second;
    } else {
      line.line.end.inner_line = tops[at(line.end.base)];
      TF_CHECK(line.line.end.inner_line >= 0);
    }
  }

  std::span<const std::int32_t> patches_;
  HeightLaw law_;
  int layers_;
  std::vector<double> levels_;
  SurfaceMesh result_;
  std::vector<BlockPlace> places_;  // of each vertex
  std::vector<bool> is_wall_;       // of each triangle
  std::vector<BlockLine> lines_;
  std::vector<LayerSide> sides_;
  // Of the face that is extruded:
  std::vector<bool> is_in_face_;
  std::vector<bool> is_at_border_;
  std::vector<std::int32_t> line_of_vertex_;
  std::map<std::array<std::int32_t, 2>, std::int32_t> patch_beyond_;  // by its edges
};

void require_outside_sound(const SurfaceMesh& surface, const SurfaceMesh& given) {
  const CheckedSurface checked =
      check_surface({surface.vertices, surface.triangles, {}, {}, {}, {}});
  if (checked.report.defects.empty()) return;
  const SurfaceDefect& defect = checked.report.defects.front();
  TF_CHECK(!defect.triangles.empty());
  const auto triangle = at(defect.triangles.front());
  throw UsageError("the outside would have a " + defect.kind + " of " +
                       counted(defect.triangles.size(), "triangle") + " near " +
                       text_of(surface.vertices[at(surface.triangles[triangle][0])]) +
                       (triangle < given.triangles.size() ? "" : ", on the side of a block") +
                       "; name whole faces of the domain, or take corners = \"mitre\"",
                   blocks_place);
}

void require_no_layers_at(const SurfaceMesh& surface, const PmlBlocksRequest& request,
                          std::span<const LayerRequest> others) {
  std::vector<bool> has_layers(surface.vertices.size(), false);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const bool is_wall = std::any_of(others.begin(), others.end(), [&](const LayerRequest& other) {
      return std::binary_search(other.patches.begin(), other.patches.end(), patch_of(surface, t));
    });
    if (!is_wall) continue;
    for (const std::int32_t v : surface.triangles[t]) has_layers[at(v)] = true;
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& patches = request.patches;
    if (!std::binary_search(patches.begin(), patches.end(), patch_of(surface, t))) continue;
    for (const std::int32_t v : surface.triangles[t]) {
      if (!has_layers[at(v)]) continue;
      throw UsageError("boundary layers meet them at " + text_of(surface.vertices[at(v)]) +
                           "; leave out the [[layers]] there, or the patch in [[pml]]",
                       blocks_place);
    }
  }
}

void require_positive(const LayerPlan& plan, const SurfaceMesh& surface, double height) {
  for (const std::int32_t t : plan.wall) {
    std::array<const LayerLine*, 3> lines{};
    const std::array<std::int32_t, 3> numbers = lines_of(plan, surface, t);
    for (std::size_t k = 0; k < 3; ++k) lines[k] = &plan.lines[at(numbers[k])];
    if (!lines[0]->of_pml || positive_layers(lines, 1) == lines[0]->stop) continue;
    throw UsageError("layers that are " + text_of(height) + " high are too low at " +
                         text_of(lines[0]->at) + ", where numbers do not tell them apart",
                     blocks_place);
  }
}

/// The plan's own lines and those of blocks, by their feet; other numbers follow.
void merge_lines(std::vector<BlockLine> blocks, std::size_t vertices, LayerPlan& plan) {
  std::vector<std::pair<std::int32_t, std::int32_t>> order;  // feet, and numbers so far
  const auto own = static_cast<std::int32_t>(plan.lines.size());
  for (BlockLine& block : blocks) {
    LineEnd& end = block.line.end;
    if (end.line >= 0) end.line += own;
    if (end.inner_line >= 0) end.inner_line += own;
    plan.lines.push_back(std::move(block.line));
  }
  for (std::size_t i = 0; i < plan.lines.size(); ++i) {
    order.emplace_back(plan.lines[i].foot, static_cast<std::int32_t>(i));
  }
  std::sort(order.begin(), order.end());
  std::vector<std::int32_t> now(order.size());
  std::vector<LayerLine> lines;
  for (std::size_t i = 0; i < order.size(); ++i) {
    now[at(order[i].second)] = static_cast<std::int32_t>(i);
    lines.push_back(std::move(plan.lines[at(order[i].second)]));
  }
  const auto renumber = [&now](std::int32_t& line) {
    if (line >= 0) line = now[at(line)];
  };
  plan.vertex2line.assign(vertices, -1);
  for (std::size_t i = lines.size(); i-- > 0;) {
    plan.vertex2line[at(lines[i].foot)] = static_cast<std::int32_t>(i);
    renumber(lines[i].end.line);
    renumber(lines[i].end.inner_line);
  }
  for (FanPiece& fan : plan.fans) {
    for (std::int32_t& line : fan.from) renumber(line);
    for (std::int32_t& line : fan.to) renumber(line);
  }
  for (FanCorner& corner : plan.fan_corners) renumber(corner.line);
  plan.lines = std::move(lines);
}

}  // namespace

PmlBlockCounts counts_of_pml_blocks(const SurfaceMesh& surface, const PmlBlocksRequest& request) {
  const std::vector<std::int32_t> planes =
      planes_of_triangles(surface, box_round(surface), request.patches);
  std::map<std::array<std::int32_t, 2>, std::int32_t> plane_of_edge;
  std::vector<std::uint8_t> axes(surface.vertices.size(), 0);  // the sum of 1, 2 and 4
  std::int64_t faces = 0;
  std::int64_t edges = 0;
  for (std::size_t t = 0; t < planes.size(); ++t) {
    if (planes[t] < 0) continue;
    ++faces;
    const Triangle& triangle = surface.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = triangle[k];
      const std::int32_t b = triangle[(k + 1) % 3];
      axes[at(a)] = static_cast<std::uint8_t>(axes[at(a)] | (1U << at(planes[t] / 2)));
      const auto other = plane_of_edge.find({b, a});
      if (other != plane_of_edge.end() && other->second != planes[t]) ++edges;
      plane_of_edge[{a, b}] = planes[t];
    }
  }
  const std::int64_t corners = std::count(axes.begin(), axes.end(), std::uint8_t{7});
  const std::int64_t n = request.layers;
  return {faces + 4 * n * edges + 6 * n * n * corners,
          3 * n * faces + 6 * n * n * edges + 6 * n * n * n * corners};
}

void require_pml_blocks(const SurfaceMesh& surface, const PmlBlocksRequest& request,
                        std::span<const LayerRequest> others) {
  require_no_layers_at(surface, request, others);
  require_outside_sound(BlockExtrusion(surface, request).surface(), surface);
}

PmlBlocks with_pml_blocks(const SurfaceMesh& surface, LayerPlan plan,
                          const PmlBlocksRequest& request) {
  TF_CHECK(plan.vertex2line.size() == surface.vertices.size());
  BlockExtrusion extrusion(surface, request);
  PmlBlocks blocks;
  blocks.plan = std::move(plan);
  std::vector<BlockLine> lines = extrusion.lines();
  for (const std::int32_t t : extrusion.wall()) blocks.plan.wall.push_back(t);
  for (const LayerSide& side : extrusion.sides()) blocks.plan.sides.push_back(side);
  blocks.surface = std::move(extrusion).surface();
  std::sort(blocks.plan.wall.begin(), blocks.plan.wall.end());
  std::sort(blocks.plan.sides.begin(), blocks.plan.sides.end(),
            [](const LayerSide& a, const LayerSide& b) {
              return std::pair(a.triangle, a.corner) < std::pair(b.triangle, b.corner);
            });
  merge_lines(std::move(lines), blocks.surface.vertices.size(), blocks.plan);
  require_positive(blocks.plan, blocks.surface, request.law.first);
  return blocks;
}

}  // namespace tetfarm
