#include "mesh/recovery/surface_flats.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/predicates.h"

namespace tetfarm {
namespace {

bool holds(const std::vector<std::int32_t>& ids, std::int32_t id) {
  return std::binary_search(ids.begin(), ids.end(), id);
}

std::vector<std::int32_t> common(const std::vector<std::int32_t>& a,
                                 const std::vector<std::int32_t>& b) {
  std::vector<std::int32_t> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

struct EdgeOfTriangle {
  std::array<std::int32_t, 2> edge;
  std::int32_t triangle;
  std::int32_t opposite;
  friend bool operator<(const EdgeOfTriangle& a, const EdgeOfTriangle& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle;
  }
};

std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t i) {
  while (parent[at(i)] != i) i = parent[at(i)] = parent[at(parent[at(i)])];
  return i;
}

/// A number for each triangle: the same for neighbours in one plane.
std::vector<std::int32_t> planes_of(std::span<const Vec3> points,
                                    const std::vector<Triangle>& triangles) {
  std::vector<EdgeOfTriangle> edges;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[i][k], triangles[i][(k + 1) % 3]);
      edges.push_back({{low, high}, static_cast<std::int32_t>(i), triangles[i][(k + 2) % 3]});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::int32_t> parent(triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const auto& [edge, triangle, opposite] = edges[i];
    if (edges[i + 1].edge != edge) continue;
    if (orient3d(points[at(edge[0])], points[at(edge[1])], points[at(opposite)],
                 points[at(edges[i + 1].opposite)]) != 0) {
      continue;
    }
    parent[at(root_of(parent, triangle))] = root_of(parent, edges[i + 1].triangle);
  }
  for (std::size_t i = 0; i < parent.size(); ++i) {
    parent[i] = root_of(parent, static_cast<std::int32_t>(i));
  }
  return parent;
}

}  // namespace

SurfaceFlats::SurfaceFlats(std::span<const Vec3> points, const std::vector<Triangle>& triangles)
    : planes_(points.size()), lines_(points.size()) {
  const auto plane = planes_of(points, triangles);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const std::int32_t v : triangles[i]) planes_[at(v)].push_back(plane[i]);
  }
  for (Ids& ids : planes_) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  }
}

const SurfaceFlats::Ids& SurfaceFlats::of(const std::vector<Ids>& all, std::int32_t node) {
  static const Ids none;
  return at(node) < all.size() ? all[at(node)] : none;
}

void SurfaceFlats::make_room(std::int32_t node) {
  planes_.resize(std::max(planes_.size(), at(node) + 1));
  lines_.resize(planes_.size());
}

std::int32_t SurfaceFlats::line_through(std::int32_t a, std::int32_t b) {
  const Ids shared = common(lines(a), lines(b));
  if (!shared.empty()) return shared.front();
  const std::int32_t line = count_of_lines_++;
  lines_[at(a)].push_back(line);
  lines_[at(b)].push_back(line);
  return line;
}

void SurfaceFlats::add(std::int32_t node, std::span<const std::int32_t> corners) {
  TF_CHECK(corners.size() >= 2);
  make_room(node);
  Ids shared = planes(corners[0]);
  for (const std::int32_t v : corners.subspan(1)) shared = common(shared, planes(v));
  planes_[at(node)] = shared;
  lines_[at(node)].clear();
  if (corners.size() == 2) lines_[at(node)].push_back(line_through(corners[0], corners[1]));
}

void SurfaceFlats::remove(std::int32_t node) {
  if (at(node) >= planes_.size()) return;
  planes_[at(node)].clear();
  lines_[at(node)].clear();
}

bool SurfaceFlats::are_in_line(const std::array<std::int32_t, 3>& nodes) const {
  const Ids first_two = common(lines(nodes[0]), lines(nodes[1]));
  return std::any_of(first_two.begin(), first_two.end(),
                     [&](std::int32_t line) { return holds(lines(nodes[2]), line); });
}

bool SurfaceFlats::are_flat(const std::array<std::int32_t, 4>& nodes) const {
  const auto fewest = *std::min_element(nodes.begin(), nodes.end(), [this](auto u, auto v) {
    return planes(u).size() < planes(v).size();
  });
  for (const std::int32_t plane : planes(fewest)) {
    if (std::all_of(nodes.begin(), nodes.end(),
                    [&](std::int32_t v) { return holds(planes(v), plane); })) {
      return true;
    }
  }
  // Of three nodes on a line, one is among the first two.
  for (const std::int32_t v : {nodes[0], nodes[1]}) {
    for (const std::int32_t line : lines(v)) {
      if (std::count_if(nodes.begin(), nodes.end(),
                        [&](std::int32_t u) { return holds(lines(u), line); }) >= 3) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace tetfarm
