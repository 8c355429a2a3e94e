#include "mesh/shapes/refined_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "base/error.h"
#include "mesh/core/complaints.h"

namespace tetfarm {
namespace {

[[noreturn]] void refuse_edge(double longest_edge, const std::string& why) {
  throw UsageError("edges of at most " + text_of(longest_edge) + " " + why, "--max-edge");
}

[[noreturn]] void refuse_many(double longest_edge) {
  refuse_edge(longest_edge, "would make more than " +
                                std::to_string(static_cast<int>(most_refined_triangles)) +
                                " triangles");
}

class Refinement {
 public:
  Refinement(const SurfaceMesh& surface, double longest_edge)
      : surface_(surface), longest_edge_(longest_edge), most_norm2_(longest_edge * longest_edge) {
    refined_.vertices = surface.vertices;
    refined_.patch_names = surface.patch_names;
    refined_.region_names = surface.region_names;
  }

  /// The pieces of a triangle, in its orientation.
  void add_pieces(std::size_t number) {
    waiting_.push_back(surface_.triangles[number]);
    while (!waiting_.empty()) {
      const Triangle t = waiting_.back();
      waiting_.pop_back();
      const std::size_t longest = longest_edge_to_halve(t);
      if (longest == 3) {
        add(t, number);
        continue;
      }
      const std::int32_t a = t[longest];
      const std::int32_t b = t[(longest + 1) % 3];
      const std::int32_t c = t[(longest + 2) % 3];
      const std::int32_t m = midpoint(a, b);
      waiting_.push_back({m, b, c});
      waiting_.push_back({a, m, c});
    }
  }

  SurfaceMesh take() { return std::move(refined_); }

 private:
  const Vec3& at(std::int32_t v) const { return refined_.vertices[static_cast<std::size_t>(v)]; }

  bool is_halved(std::int32_t a, std::int32_t b) const {
    const double length2 = norm2(at(a) - at(b));
    if (!(length2 > most_norm2_)) return false;
    // Half of the length where coordinates are not rounded.
    const Vec3 middle = 0.5 * (at(a) + at(b));
    return std::max(norm2(middle - at(a)), norm2(middle - at(b))) < 0.5 * length2;
  }

  /// The edge from this corner to the next; 3: none.
  std::size_t longest_edge_to_halve(const Triangle& t) const {
    std::size_t longest = 3;
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double length = norm2(at(t[i]) - at(t[(i + 1) % 3]));
      if (length > most && is_halved(t[i], t[(i + 1) % 3])) {
        most = length;
        longest = i;
      }
    }
    return longest;
  }

  std::int32_t midpoint(std::int32_t a, std::int32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto key = (static_cast<std::uint64_t>(low) << 32) | static_cast<std::uint64_t>(high);
    const auto next = static_cast<std::int32_t>(refined_.vertices.size());
    const auto [it, is_new] = midpoints_.try_emplace(key, next);
    if (is_new) refined_.vertices.push_back(0.5 * (at(a) + at(b)));
    return it->second;
  }

  void add(const Triangle& t, std::size_t number) {
    if (static_cast<double>(refined_.triangles.size()) >= most_refined_triangles) {
      refuse_many(longest_edge_);
    }
    refined_.triangles.push_back(t);
    if (!surface_.patch_of_triangle.empty()) {
      refined_.patch_of_triangle.push_back(surface_.patch_of_triangle[number]);
    }
    if (!surface_.sides.empty()) refined_.sides.push_back(surface_.sides[number]);
  }

  const SurfaceMesh& surface_;
  double longest_edge_;
  double most_norm2_;
  SurfaceMesh refined_;
  std::vector<Triangle> waiting_;
  std::unordered_map<std::uint64_t, std::int32_t> midpoints_;
};

/// No piece has more than the area of an equilateral triangle, nor more of a side than an edge.
double least_pieces(const SurfaceMesh& surface, double longest_edge) {
  constexpr double equilateral_area = 0.4330127;
  double pieces = 0;
  for (const Triangle& t : surface.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = surface.vertices[static_cast<std::size_t>(t[i])];
    const double longest =
        std::max({distance(p[0], p[1]), distance(p[1], p[2]), distance(p[2], p[0])});
    const double area = 0.5 * norm(cross(p[1] - p[0], p[2] - p[0]));
    pieces += std::max(
        {1.0, longest / longest_edge, area / longest_edge / longest_edge / equilateral_area});
  }
  return pieces;
}

}  // namespace

SurfaceMesh refined_surface(const SurfaceMesh& surface, double longest_edge) {
  if (!(longest_edge > 0) || !std::isfinite(longest_edge)) {
    refuse_edge(longest_edge, "make no sense");
  }
  if (!(least_pieces(surface, longest_edge) <= most_refined_triangles)) refuse_many(longest_edge);
  Refinement refinement(surface, longest_edge);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) refinement.add_pieces(t);
  return refinement.take();
}

}  // namespace tetfarm
