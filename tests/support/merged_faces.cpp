#include "tests/support/merged_faces.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "tests/support/surface_parts.h"

namespace tetfarm::shapes {
namespace {

using Whole = std::array<std::int64_t, 3>;
using Edge = std::array<std::int32_t, 2>;

Whole whole(const Vec3& p) {
  return {static_cast<std::int64_t>(p.x), static_cast<std::int64_t>(p.y),
          static_cast<std::int64_t>(p.z)};
}

Whole difference(const Whole& a, const Whole& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Whole product(const Whole& a, const Whole& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The direction in smallest whole numbers.
Whole direction(Whole v) {
  const std::int64_t factor = std::gcd(std::gcd(v[0], v[1]), v[2]);
  for (std::int64_t& x : v) x /= factor;
  return v;
}

/// Triangles of one plane that are joined by edges, and the way round them.
struct Face {
  Whole normal{};
  std::vector<std::int32_t> triangles;
  std::map<std::int32_t, std::int32_t> next;  // along the outlines, the face on the left
  bool is_merged = true;
};

class FaceMerger {
 public:
  FaceMerger(const SurfaceMesh& fine, const MergeOptions& options, Chance& chance)
      : fine_(fine), options_(options), chance_(chance) {
    for (const Vec3& p : fine.vertices) points_.push_back(whole(p));
    find_faces();
    find_outlines();
    choose_nodes();
  }

  SurfaceMesh merge() {
    SurfaceMesh mesh;
    for (const Face& face : faces_) {
      if (face.is_merged) {
        add_polygon(mesh, face);
      } else {
        for (const std::int32_t t : face.triangles) {
          mesh.triangles.push_back(fine_.triangles[at(t)]);
        }
      }
    }
    std::vector<std::int32_t> number(points_.size(), -1);
    for (Triangle& t : mesh.triangles) {
      for (std::int32_t& v : t) {
        std::int32_t& mine = number[at(v)];
        if (mine < 0) {
          mine = static_cast<std::int32_t>(mesh.vertices.size());
          mesh.vertices.push_back(fine_.vertices[at(v)]);
        }
        v = mine;
      }
    }
    return with_one_patch(std::move(mesh));
  }

 private:
  Whole normal(std::size_t triangle) const {
    const auto& [a, b, c] = fine_.triangles[triangle];
    return direction(product(difference(points_[at(b)], points_[at(a)]),
                             difference(points_[at(c)], points_[at(a)])));
  }

  /// Neighbours with one normal share an edge, and so the plane.
  void find_faces() {
    std::vector<Whole> normals;
    for (std::size_t t = 0; t < fine_.triangles.size(); ++t) {
      normals.push_back(normal(t));
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& corners = fine_.triangles[t];
        const bool is_new =
            triangle_of_edge_
                .try_emplace(Edge{corners[k], corners[(k + 1) % 3]}, static_cast<std::int32_t>(t))
                .second;
        TF_CHECK(is_new);
      }
    }
    face_of_triangle_.assign(fine_.triangles.size(), -1);
    for (std::size_t t = 0; t < fine_.triangles.size(); ++t) {
      if (face_of_triangle_[t] >= 0) continue;
      const auto number = static_cast<std::int32_t>(faces_.size());
      Face face{normals[t], {static_cast<std::int32_t>(t)}, {}, true};
      face_of_triangle_[t] = number;
      for (std::size_t i = 0; i < face.triangles.size(); ++i) {
        for (const std::int32_t beside : neighbours(face.triangles[i])) {
          if (face_of_triangle_[at(beside)] >= 0 || normals[at(beside)] != face.normal) continue;
          face_of_triangle_[at(beside)] = number;
          face.triangles.push_back(beside);
        }
      }
      face.is_merged = chance_.pick(0, 15) >= options_.unmerged_in_16;
      faces_.push_back(std::move(face));
    }
  }

  std::array<std::int32_t, 3> neighbours(std::int32_t t) const {
    std::array<std::int32_t, 3> result{};
    const auto& corners = fine_.triangles[at(t)];
    for (std::size_t k = 0; k < 3; ++k) {
      result[k] = triangle_of_edge_.at({corners[(k + 1) % 3], corners[k]});
    }
    return result;
  }

  void find_outlines() {
    edges_of_node_.assign(points_.size(), 0);
    for (const auto& [edge, triangle] : triangle_of_edge_) {
      const std::int32_t face = face_of_triangle_[at(triangle)];
      const std::int32_t beside = face_of_triangle_[at(triangle_of_edge_.at({edge[1], edge[0]}))];
      if (face == beside) continue;
      Face& mine = faces_[at(face)];
      if (!mine.next.try_emplace(edge[0], edge[1]).second) mine.is_merged = false;
      ++edges_of_node_[at(edge[0])];
    }
  }

  bool is_straight(std::int32_t before, std::int32_t here, std::int32_t after) const {
    return product(difference(points_[at(here)], points_[at(before)]),
                   difference(points_[at(after)], points_[at(here)])) == Whole{};
  }

  /// All but those within faces and, unless chance keeps them, within straight edges.
  void choose_nodes() {
    is_kept_.assign(points_.size(), false);
    for (std::size_t v = 0; v < points_.size(); ++v) {
      is_kept_[v] = edges_of_node_[v] > 2 || chance_.pick(0, 15) < options_.kept_in_16;
    }
    for (const Face& face : faces_) {
      if (!face.is_merged) {
        for (const std::int32_t t : face.triangles) {
          for (const std::int32_t v : fine_.triangles[at(t)]) is_kept_[at(v)] = true;
        }
        continue;
      }
      for (const auto& [before, here] : face.next) {
        if (!is_straight(before, here, face.next.at(here))) is_kept_[at(here)] = true;
      }
    }
  }

  /// Seen from where the normal points, along the axis that it is nearest to.
  GridPoint flattened(const Face& face, std::int32_t node) const {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (std::abs(face.normal[k]) > std::abs(face.normal[axis])) axis = k;
    }
    const Whole& p = points_[at(node)];
    const std::int64_t u = p[(axis + 1) % 3], v = p[(axis + 2) % 3];
    return face.normal[axis] > 0 ? GridPoint{u, v} : GridPoint{v, u};
  }

  void add_polygon(SurfaceMesh& mesh, const Face& face) const {
    std::vector<std::vector<std::int32_t>> paths;
    std::map<std::int32_t, std::int32_t> next = face.next;
    while (!next.empty()) {
      std::vector<std::int32_t> path;
      for (auto step = next.begin(); step != next.end(); step = next.find(path.back())) {
        path.push_back(step->second);
        next.erase(step);
      }
      std::erase_if(path, [this](std::int32_t v) { return !is_kept_[at(v)]; });
      paths.push_back(std::move(path));
    }
    std::vector<Loop> loops;
    for (const auto& path : paths) {
      loops.emplace_back();
      for (const std::int32_t v : path) loops.back().push_back(flattened(face, v));
    }
    const auto outline = std::find_if(loops.begin(), loops.end(), turns_left);
    TF_CHECK(outline != loops.end());
    std::swap(paths.front(), paths[static_cast<std::size_t>(outline - loops.begin())]);
    std::swap(loops.front(), *outline);
    std::vector<std::int32_t> numbers;
    for (const auto& path : paths) numbers.insert(numbers.end(), path.begin(), path.end());
    for (const auto& [a, b, c] : clip_ears(loops, options_.order)) {
      mesh.triangles.push_back({numbers[at(a)], numbers[at(b)], numbers[at(c)]});
    }
  }

  static bool turns_left(const Loop& loop) {
    std::int64_t area = 0;
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) area += turn(loop[0], loop[k], loop[k + 1]);
    return area > 0;
  }

  const SurfaceMesh& fine_;
  const MergeOptions& options_;
  Chance& chance_;
  std::vector<Whole> points_;
  std::map<Edge, std::int32_t> triangle_of_edge_;
  std::vector<std::int32_t> face_of_triangle_;
  std::vector<Face> faces_;
  std::vector<int> edges_of_node_;  // of outlines, each once
  std::vector<bool> is_kept_;
};

}  // namespace

SurfaceMesh with_merged_faces(const SurfaceMesh& fine, const MergeOptions& options,
                              Chance& chance) {
  return FaceMerger(fine, options, chance).merge();
}

}  // namespace tetfarm::shapes
