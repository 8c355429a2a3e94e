#include "mesh/core/subdomain.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/array_index.h"
#include "base/check.h"
#include "base/tree_path.h"
#include "mesh/core/complaints.h"
#include "mesh/core/subdomain_regions.h"
#include "mesh/core/validate.h"

namespace tetfarm {
namespace {

std::string text_of(const Origin& origin) {
  return "(owner " + std::to_string(origin.owner) + ", index " + std::to_string(origin.index) + ")";
}

void find_equal_lengths(const Subdomain& s, Complaints& complaints) {
  const auto compare = [&](std::size_t items, std::size_t origins, const std::string& what) {
    if (items != origins) {
      complaints.add(std::to_string(items) + " " + what + " but " + std::to_string(origins) +
                     " origins of " + what);
    }
  };
  compare(s.vertices.size(), s.node_origin.size(), "vertices");
  compare(s.triangles.size(), s.triangle_origin.size(), "triangles");
  const std::size_t sides = s.region == 0 ? s.triangles.size() : 0;
  if (s.region < 0 || s.sides.size() != sides) {
    complaints.add("region " + std::to_string(s.region) + " with sides of " +
                   std::to_string(s.sides.size()) + " triangles");
  }
  if (s.path.heap == 0) complaints.add("the tree path is 0, which is not a place in a tree");
}

void find_bad_triangles(const Subdomain& s, Complaints& complaints) {
  for (std::size_t i = 0; i < s.triangles.size() && !complaints.full(); ++i) {
    const auto& [a, b, c] = s.triangles[i];
    const bool in_range = std::min({a, b, c}) >= 0 && at(std::max({a, b, c})) < s.vertices.size();
    if (!in_range || a == b || b == c || c == a) {
      complaints.add("triangle " + std::to_string(i) + " (" + std::to_string(a) + ", " +
                     std::to_string(b) + ", " + std::to_string(c) + ") " +
                     (in_range ? "uses a vertex twice" : "has a vertex that does not exist"));
    }
  }
}

void find_bad_vertices(const Subdomain& s, Complaints& complaints) {
  std::vector<bool> is_used(s.vertices.size(), false);
  for (const Triangle& triangle : s.triangles) {
    for (const std::int32_t v : triangle) is_used[at(v)] = true;
  }
  for (std::size_t v = 0; v < s.vertices.size() && !complaints.full(); ++v) {
    const Vec3& p = s.vertices[v];
    const std::string name = "vertex " + std::to_string(v) + " ";
    if (!is_used[v]) complaints.add(name + text_of(p) + " is in no triangle");
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      complaints.add(name + text_of(p) + " is not finite");
    }
  }
}

void find_repeated_origins(std::vector<Origin> origins, const std::string& what,
                           Complaints& complaints) {
  std::sort(origins.begin(), origins.end());
  for (auto it = origins.begin(); !complaints.full(); ++it) {
    it = std::adjacent_find(it, origins.end());
    if (it == origins.end()) return;
    complaints.add("two " + what + " have the origin " + text_of(*it));
  }
}

void find_unmatched_edges(const Subdomain& subdomain, std::int32_t region, Complaints& complaints) {
  for (const auto& [a, b] : unmatched_edges(triangles_out_of(subdomain, region))) {
    complaints.add("edge " + std::to_string(a) + "-" + std::to_string(b) + " from " +
                   text_of(subdomain.vertices[at(a)]) + " to " +
                   text_of(subdomain.vertices[at(b)]) +
                   " is not used equally often in both directions");
    if (complaints.full()) return;
  }
}

}  // namespace

int TreePath::depth() const {
  TF_CHECK(heap > 0);
  return static_cast<int>(std::bit_width(heap)) - 1;
}

std::string TreePath::text() const { return tree_path(heap); }

Subdomain root_subdomain(const SurfaceMesh& surface) {
  TF_CHECK(surface.vertices.size() <= std::numeric_limits<std::int32_t>::max());
  Subdomain whole;
  whole.vertices = surface.vertices;
  whole.node_origin.reserve(surface.vertices.size());
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    whole.node_origin.push_back({0, static_cast<std::uint32_t>(v)});
  }
  whole.triangles = surface.triangles;
  whole.region = 0;
  whole.triangle_origin.reserve(surface.triangles.size());
  whole.sides.reserve(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    whole.triangle_origin.push_back({0, static_cast<std::uint32_t>(t)});
    whole.sides.push_back(sides_of(surface, t));
  }
  return part_of_regions(whole, regions_of(whole), whole.path);
}

std::vector<std::string> validate(const Subdomain& subdomain) {
  Complaints complaints;
  find_equal_lengths(subdomain, complaints);
  find_bad_triangles(subdomain, complaints);
  if (!complaints.empty()) return complaints.take();
  find_bad_vertices(subdomain, complaints);
  for (const std::int32_t region : regions_of(subdomain)) {
    find_unmatched_edges(subdomain, region, complaints);
  }
  find_repeated_origins(subdomain.node_origin, "vertices", complaints);
  find_repeated_origins(subdomain.triangle_origin, "triangles", complaints);
  return complaints.take();
}

}  // namespace tetfarm
