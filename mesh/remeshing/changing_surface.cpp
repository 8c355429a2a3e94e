#include "mesh/remeshing/changing_surface.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/check.h"
#include "mesh/geometry/hilbert_order.h"

namespace tetfarm {
namespace {

constexpr std::size_t most_complaints = 5;

/// The k for which a and b are nodes[k] and the next, in whichever order.
std::size_t side_of(const Triangle& t, std::int32_t a, std::int32_t b) {
  const std::size_t i = corner_of(t, a);
  return t[(i + 1) % 3] == b ? i : (i + 2) % 3;
}

std::string complaint_of_edge(const ChangingSurface& surface, std::int32_t a, std::int32_t b) {
  const std::vector<std::int32_t> on = surface.triangles_on(a, b);
  const bool is_feature = surface.is_feature(on.front(), a, b);
  for (const std::int32_t t : on) {
    if (surface.is_feature(t, a, b) != is_feature) return "triangles do not agree on a feature";
  }
  const bool may_be_smooth =
      on.size() == 2 && surface.triangle(on[0]).face == surface.triangle(on[1]).face;
  return is_feature || may_be_smooth ? "" : "an edge between faces is no feature";
}

std::string complaint_of_vertex(const ChangingSurface& surface, std::int32_t v) {
  const SurfaceVertex& vertex = surface.vertex(v);
  const std::size_t features = surface.feature_neighbours(v).size();
  if (vertex.kind == VertexKind::on_curve && features != 2) return "a curve ends or forks";
  if (vertex.kind != VertexKind::smooth) return "";
  if (features > 0) return "a feature edge at a smooth vertex";
  for (const std::int32_t t : surface.ring(v)) {
    if (surface.triangle(t).face != vertex.home) return "a smooth vertex has a triangle elsewhere";
  }
  return "";
}

std::string complaint_of_triangle(const ChangingSurface& surface, std::int32_t t) {
  const FaceTriangle& triangle = surface.triangle(t);
  const Triangle& n = triangle.nodes;
  if (n[0] == n[1] || n[1] == n[2] || n[2] == n[0]) return "a vertex twice";
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::ranges::count(surface.ring(n[k]), t) != 1) return "is not once in a ring";
    std::string complaint = complaint_of_edge(surface, n[k], n[(k + 1) % 3]);
    if (!complaint.empty()) return complaint;
  }
  bool is_in_tree = false;
  surface.tree().query(surface.box(n), [&](std::int32_t id) { is_in_tree |= id == t; });
  return is_in_tree ? "" : "is not in the tree";
}

}  // namespace

std::int32_t ChangingSurface::add_vertex(const Vec3& at, const SurfaceVertex& vertex) {
  if (!free_vertices_.empty()) {
    const std::int32_t v = free_vertices_.back();
    free_vertices_.pop_back();
    places_[static_cast<std::size_t>(v)] = at;
    this->vertex(v) = vertex;
    return v;
  }
  places_.push_back(at);
  vertices_.push_back(vertex);
  rings_.emplace_back();
  changed_.push_back(0);
  return static_cast<std::int32_t>(vertices_.size()) - 1;
}

void ChangingSurface::remove_vertex(std::int32_t v) {
  TF_CHECK(ring(v).empty());
  free_vertices_.push_back(v);
}

std::int32_t ChangingSurface::add_triangle(const FaceTriangle& triangle) {
  const Triangle& n = triangle.nodes;
  TF_CHECK(n[0] >= 0 && n[0] != n[1] && n[1] != n[2] && n[2] != n[0]);
  std::int32_t t = 0;
  if (free_triangles_.empty()) {
    t = static_cast<std::int32_t>(triangles_.size());
    triangles_.push_back(triangle);
    came_.push_back(0);
  } else {
    t = free_triangles_.back();
    free_triangles_.pop_back();
    triangles_[static_cast<std::size_t>(t)] = triangle;
  }
  for (const std::int32_t v : triangle.nodes) rings_[static_cast<std::size_t>(v)].add(t);
  tree_.add(t, box(triangle.nodes));
  note_change(triangle.nodes);
  came_[static_cast<std::size_t>(t)] = now_;
  ++triangle_count_;
  return t;
}

void ChangingSurface::remove_triangle(std::int32_t t) {
  Triangle& nodes = triangles_[static_cast<std::size_t>(t)].nodes;
  TF_CHECK(nodes[0] >= 0);
  for (const std::int32_t v : nodes) rings_[static_cast<std::size_t>(v)].remove(t);
  note_change(nodes);
  nodes = {-1, -1, -1};
  tree_.remove(t);
  free_triangles_.push_back(t);
  --triangle_count_;
}

void ChangingSurface::settle(std::int32_t v) {
  for (const std::int32_t t : ring(v)) {
    tree_.move(t, box(triangle(t).nodes));
    note_change(triangle(t).nodes);
  }
}

void ChangingSurface::number_by_place() {
  tree_ = TriangleOctree(whole_);
  std::vector<Vec3> places;
  std::vector<std::int32_t> used;
  for (std::int32_t v = 0; v < vertex_end(); ++v) {
    if (ring(v).empty()) continue;
    used.push_back(v);
    places.push_back(at(v));
  }
  std::vector<std::int32_t> order = hilbert_order(places);
  for (std::int32_t& v : order) v = used[static_cast<std::size_t>(v)];
  renumber_vertices(order);
  const std::vector<FaceTriangle> triangles = triangles_by_vertex();
  triangles_.clear();
  came_.clear();
  free_triangles_.clear();
  triangle_count_ = 0;
  for (const FaceTriangle& t : triangles) add_triangle(t);
}

/// In the order of their lowest vertices, equals in that of their numbers.
std::vector<FaceTriangle> ChangingSurface::triangles_by_vertex() const {
  std::vector<std::size_t> start(vertices_.size() + 1, 0);
  const auto lowest = [](const FaceTriangle& t) {
    return static_cast<std::size_t>(std::min({t.nodes[0], t.nodes[1], t.nodes[2]}));
  };
  for (const FaceTriangle& t : triangles_) {
    if (t.nodes[0] >= 0) ++start[lowest(t) + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<FaceTriangle> sorted(static_cast<std::size_t>(triangle_count_));
  for (const FaceTriangle& t : triangles_) {
    if (t.nodes[0] >= 0) sorted[start[lowest(t)]++] = t;
  }
  return sorted;
}

/// @param order the old numbers in the new order, without those of vertices that are gone.
void ChangingSurface::renumber_vertices(const std::vector<std::int32_t>& order) {
  std::vector<std::int32_t> number(vertices_.size(), -1);
  std::vector<Vec3> places;
  std::vector<SurfaceVertex> vertices;
  for (const std::int32_t v : order) {
    number[static_cast<std::size_t>(v)] = static_cast<std::int32_t>(places.size());
    places.push_back(at(v));
    vertices.push_back(vertex(v));
    vertices.back().settled = 0;
  }
  for (FaceTriangle& t : triangles_) {
    if (t.nodes[0] < 0) continue;
    for (std::int32_t& v : t.nodes) v = number[static_cast<std::size_t>(v)];
  }
  places_ = std::move(places);
  vertices_ = std::move(vertices);
  rings_.assign(vertices_.size(), {});
  changed_.assign(vertices_.size(), 0);
  free_vertices_.clear();
}

void ChangingSurface::note_change(const Triangle& nodes) {
  ++now_;
  for (const std::int32_t v : nodes) changed_[static_cast<std::size_t>(v)] = now_;
}

Box3 ChangingSurface::box(const Triangle& t) const {
  Box3 box;
  for (const std::int32_t v : t) box.add(at(v));
  return box;
}

std::vector<std::int32_t> ChangingSurface::triangles_on(std::int32_t a, std::int32_t b) const {
  std::vector<std::int32_t> found;
  find_triangles_on(a, b, found);
  return found;
}

void ChangingSurface::find_triangles_on(std::int32_t a, std::int32_t b,
                                        std::vector<std::int32_t>& found) const {
  found.clear();
  const std::span<const std::int32_t> other = ring(b);
  for (const std::int32_t t : ring(a)) {
    if (std::ranges::find(other, t) != other.end()) found.push_back(t);
  }
  std::ranges::sort(found);
}

bool ChangingSurface::has_edge(std::int32_t a, std::int32_t b) const {
  return std::ranges::any_of(ring(a),
                             [&](std::int32_t t) { return has_corner(triangle(t).nodes, b); });
}

bool ChangingSurface::has_new_triangle(std::uint64_t then, std::int32_t a, std::int32_t b) const {
  return std::ranges::any_of(ring(a), [&](std::int32_t t) {
    return came_[static_cast<std::size_t>(t)] > then && has_corner(triangle(t).nodes, b);
  });
}

bool ChangingSurface::is_feature(std::int32_t t, std::int32_t a, std::int32_t b) const {
  return is_feature_edge(triangle(t), a, b);
}

std::vector<std::int32_t> ChangingSurface::feature_neighbours(std::int32_t v) const {
  std::vector<std::int32_t> found;
  for (const std::int32_t t : ring(v)) {
    const FaceTriangle& of = triangle(t);
    const std::size_t k = corner_of(of.nodes, v);
    if (is_feature_side(of, k)) found.push_back(of.nodes[(k + 1) % 3]);
    if (is_feature_side(of, (k + 2) % 3)) found.push_back(of.nodes[(k + 2) % 3]);
  }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool is_feature_edge(const FaceTriangle& t, std::int32_t a, std::int32_t b) {
  return is_feature_side(t, side_of(t.nodes, a, b));
}

void mark_feature_edge(FaceTriangle& t, std::int32_t a, std::int32_t b) {
  t.features = static_cast<std::uint8_t>(t.features | 1U << side_of(t.nodes, a, b));
}

std::vector<std::string> complaints_of(const ChangingSurface& surface) {
  std::vector<std::string> complaints;
  const auto note = [&complaints](const std::string& what, std::int32_t of, const char* kind) {
    if (what.empty() || complaints.size() >= most_complaints) return;
    complaints.push_back(std::string(kind) + " " + std::to_string(of) + ": " + what);
  };
  for (std::int32_t t = 0; t < surface.triangle_end(); ++t) {
    if (surface.is_there(t)) note(complaint_of_triangle(surface, t), t, "triangle");
  }
  for (std::int32_t v = 0; v < surface.vertex_end(); ++v) {
    if (!surface.ring(v).empty()) note(complaint_of_vertex(surface, v), v, "vertex");
  }
  return complaints;
}

}  // namespace tetfarm
