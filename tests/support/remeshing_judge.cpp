#include "tests/support/remeshing_judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

#include "mesh/geometry/triangle_distance.h"
#include "mesh/inspect/surface_check.h"

namespace tetfarm {
namespace {

using Complaints = std::vector<std::string>;
using JudgedEdge = std::pair<std::int32_t, std::int32_t>;  // low, high
using TrianglesOfEdge = std::map<JudgedEdge, std::vector<std::size_t>>;

const Vec3& corner(const SurfaceMesh& s, std::size_t t, std::size_t k) {
  return s.vertices[static_cast<std::size_t>(s.triangles[t][k])];
}

Vec3 doubled_normal(const SurfaceMesh& s, std::size_t t) {
  return cross(corner(s, t, 1) - corner(s, t, 0), corner(s, t, 2) - corner(s, t, 0));
}

TrianglesOfEdge triangles_of_edges(const SurfaceMesh& s) {
  TrianglesOfEdge found;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = s.triangles[t][k];
      const std::int32_t b = s.triangles[t][(k + 1) % 3];
      found[std::minmax(a, b)].push_back(t);
    }
  }
  return found;
}

bool has_bad_numbers(const SurfaceMesh& s) {
  const auto count = static_cast<std::int32_t>(s.vertices.size());
  for (const Triangle& t : s.triangles) {
    for (const std::int32_t v : t) {
      if (v < 0 || v >= count) return true;
    }
  }
  const auto patches = static_cast<std::int32_t>(s.patch_names.size());
  for (const std::int32_t p : s.patch_of_triangle) {
    if (p < 0 || p >= patches) return true;
  }
  const std::size_t n = s.triangles.size();
  return (!s.patch_of_triangle.empty() && s.patch_of_triangle.size() != n) ||
         (!s.sides.empty() && s.sides.size() != n);
}

/// Of each region, each edge as often in one direction as in the other.
bool is_closed(const SurfaceMesh& s) {
  std::map<std::tuple<std::int32_t, std::int32_t, std::int32_t>, int> balance;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const Sides sides = sides_of(s, t);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = s.triangles[t][k];
      const std::int32_t b = s.triangles[t][(k + 1) % 3];
      const int way = a < b ? 1 : -1;
      balance[{sides[0], std::min(a, b), std::max(a, b)}] += way;
      balance[{sides[1], std::min(a, b), std::max(a, b)}] -= way;
    }
  }
  return std::ranges::all_of(balance, [](const auto& entry) { return entry.second == 0; });
}

double distance2_to_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
  return distance2_to_triangle(p, a, b, b);
}

/// Edges of other than two triangles lie where the input has such edges.
bool has_foreign_junction(const SurfaceMesh& input, const TrianglesOfEdge& before,
                          const SurfaceMesh& result, const TrianglesOfEdge& after,
                          double tolerance) {
  const auto place = [](const SurfaceMesh& s, std::int32_t v) {
    return s.vertices[static_cast<std::size_t>(v)];
  };
  for (const auto& [edge, triangles] : after) {
    if (triangles.size() == 2) continue;
    const Vec3 middle = 0.5 * (place(result, edge.first) + place(result, edge.second));
    bool found = false;
    for (const auto& [old_edge, old_triangles] : before) {
      if (old_triangles.size() != triangles.size()) continue;
      const double d2 =
          distance2_to_edge(middle, place(input, old_edge.first), place(input, old_edge.second));
      found = found || d2 <= tolerance * tolerance;
    }
    if (!found) return true;
  }
  return false;
}

/// The Euler number of each part that is connected over edges, sorted.
std::vector<std::int64_t> euler_numbers(const SurfaceMesh& s, const TrianglesOfEdge& edges) {
  std::vector<std::size_t> part(s.triangles.size());
  std::iota(part.begin(), part.end(), std::size_t{0});
  const auto root = [&part](std::size_t t) {
    while (part[t] != t) t = part[t] = part[part[t]];
    return t;
  };
  for (const auto& entry : edges) {
    for (const std::size_t t : entry.second) part[root(t)] = root(entry.second.front());
  }
  std::map<std::size_t, std::int64_t> euler;
  std::set<std::pair<std::size_t, std::int32_t>> seen;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    ++euler[root(t)];
    for (const std::int32_t v : s.triangles[t]) {
      if (seen.emplace(root(t), v).second) ++euler[root(t)];
    }
  }
  for (const auto& entry : edges) --euler[root(entry.second.front())];
  std::vector<std::int64_t> numbers;
  for (const auto& entry : euler) numbers.push_back(entry.second);
  std::ranges::sort(numbers);
  return numbers;
}

bool turns_by_more(const Vec3& a, const Vec3& b, double angle_deg) {
  const double angle = std::atan2(norm(cross(a, b)), dot(a, b));
  return angle * 180 / std::numbers::pi > angle_deg;
}

bool is_feature(const SurfaceMesh& s, const std::vector<std::size_t>& triangles, double angle_deg) {
  if (triangles.size() != 2) return true;
  const std::size_t t = triangles[0];
  const std::size_t u = triangles[1];
  return patch_of(s, t) != patch_of(s, u) || sides_of(s, t) != sides_of(s, u) ||
         turns_by_more(doubled_normal(s, t), doubled_normal(s, u), angle_deg);
}

std::vector<char> beside_flat_triangles(const SurfaceMesh& s, double height) {
  std::vector<char> beside(s.vertices.size(), 0);
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, distance(corner(s, t, k), corner(s, t, (k + 1) % 3)));
    if (norm(doubled_normal(s, t)) >= height * longest) continue;
    for (const std::int32_t v : s.triangles[t]) beside[static_cast<std::size_t>(v)] = 1;
  }
  return beside;
}

std::vector<Vec3> corners_of(const SurfaceMesh& s, const TrianglesOfEdge& edges,
                             const RemeshingDemands& demands) {
  std::vector<std::vector<Vec3>> ways(s.vertices.size());
  for (const auto& [edge, triangles] : edges) {
    if (!is_feature(s, triangles, demands.angle_deg)) continue;
    const auto a = static_cast<std::size_t>(edge.first);
    const auto b = static_cast<std::size_t>(edge.second);
    ways[a].push_back(s.vertices[b] - s.vertices[a]);
    ways[b].push_back(s.vertices[a] - s.vertices[b]);
  }
  const std::vector<char> unsure = beside_flat_triangles(s, 0.1 * demands.tolerance);
  std::vector<Vec3> corners;
  for (std::size_t v = 0; v < ways.size(); ++v) {
    if (unsure[v] != 0 || ways[v].empty()) continue;
    if (ways[v].size() != 2 || turns_by_more(-ways[v][0], ways[v][1], demands.angle_deg))
      corners.push_back(s.vertices[v]);
  }
  return corners;
}

/// How many vertices in use and middles of triangles of `of` are farther than that from `other`.
std::size_t points_too_far(const SurfaceMesh& of, const SurfaceMesh& other, double tolerance) {
  std::vector<Box3> boxes(other.triangles.size());
  const Vec3 margin{tolerance, tolerance, tolerance};
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      boxes[t].add(corner(other, t, k) - margin);
      boxes[t].add(corner(other, t, k) + margin);
    }
  }
  const auto is_far = [&](const Vec3& p) {
    Box3 at;
    at.add(p);
    for (std::size_t t = 0; t < boxes.size(); ++t) {
      if (!boxes[t].overlaps(at)) continue;
      const double d2 =
          distance2_to_triangle(p, corner(other, t, 0), corner(other, t, 1), corner(other, t, 2));
      if (d2 <= tolerance * tolerance) return false;
    }
    return true;
  };
  std::size_t far = 0;
  std::set<std::int32_t> used;
  for (std::size_t t = 0; t < of.triangles.size(); ++t) {
    used.insert(of.triangles[t].begin(), of.triangles[t].end());
    if (is_far((corner(of, t, 0) + corner(of, t, 1) + corner(of, t, 2)) / 3)) ++far;
  }
  for (const std::int32_t v : used) {
    if (is_far(of.vertices[static_cast<std::size_t>(v)])) ++far;
  }
  return far;
}

using AreaKey = std::tuple<std::int32_t, std::int32_t, std::int32_t>;  // patch, behind, in front

std::map<AreaKey, double> areas_of(const SurfaceMesh& s) {
  std::map<AreaKey, double> areas;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const Sides sides = sides_of(s, t);
    areas[{patch_of(s, t), sides[0], sides[1]}] += 0.5 * norm(doubled_normal(s, t));
  }
  return areas;
}

void judge_names_and_areas(const SurfaceMesh& input, const SurfaceMesh& result,
                           const RemeshingDemands& demands, Complaints& complaints) {
  if (input.patch_names != result.patch_names || input.region_names != result.region_names) {
    complaints.emplace_back("names of patches or regions differ");
    return;
  }
  const std::map<AreaKey, double> before = areas_of(input);
  std::map<AreaKey, double> after = areas_of(result);
  double whole = 0;
  for (const auto& [key, area] : before) {
    whole += area;
    if (std::abs(after[key] - area) > demands.area_share * area)
      complaints.push_back("the area of patch " + std::to_string(std::get<0>(key)) + " was " +
                           std::to_string(area) + ", is " + std::to_string(after[key]));
  }
  if (after.size() != before.size()) complaints.emplace_back("a patch is where it was not");
  if (std::abs(domain_volume(result) - domain_volume(input)) > 2 * whole * demands.tolerance)
    complaints.emplace_back("the volume changed by more than the tolerance explains");
}

void judge_crossings(const SurfaceMesh& result, Complaints& complaints) {
  SurfaceMesh plain = result;
  plain.sides.clear();
  plain.region_names.clear();
  for (const SurfaceDefect& defect : check_surface(plain).report.defects)
    complaints.push_back(defect.kind + ": " + defect.message);
}

void judge_corners(const SurfaceMesh& input, const TrianglesOfEdge& edges,
                   const SurfaceMesh& result, const RemeshingDemands& demands,
                   Complaints& complaints) {
  std::set<std::array<double, 3>> kept;
  for (const Triangle& t : result.triangles) {
    for (const std::int32_t v : t) {
      const Vec3& p = result.vertices[static_cast<std::size_t>(v)];
      kept.insert({p.x, p.y, p.z});
    }
  }
  std::size_t lost = 0;
  for (const Vec3& p : corners_of(input, edges, demands)) {
    if (!kept.contains({p.x, p.y, p.z})) ++lost;
  }
  if (lost > 0) complaints.push_back(std::to_string(lost) + " corners are lost");
}

}  // namespace

std::vector<std::string> remeshing_complaints(const SurfaceMesh& input, const SurfaceMesh& result,
                                              const RemeshingDemands& demands) {
  if (has_bad_numbers(result)) return {"bad numbers of vertices, patches or sides"};
  Complaints complaints;
  const TrianglesOfEdge before = triangles_of_edges(input);
  const TrianglesOfEdge after = triangles_of_edges(result);
  if (!is_closed(result)) complaints.emplace_back("a region is not closed, or not oriented");
  if (has_foreign_junction(input, before, result, after, demands.tolerance))
    complaints.emplace_back("an edge has other than two triangles, unlike the input there");
  judge_crossings(result, complaints);
  if (euler_numbers(input, before) != euler_numbers(result, after))
    complaints.emplace_back("other shells, or shells of another genus");
  judge_corners(input, before, result, demands, complaints);
  const std::size_t off = points_too_far(result, input, demands.tolerance);
  const std::size_t missed = points_too_far(input, result, demands.tolerance);
  if (off > 0) complaints.push_back(std::to_string(off) + " points are far from the input");
  if (missed > 0) complaints.push_back(std::to_string(missed) + " points of the input are far off");
  judge_names_and_areas(input, result, demands, complaints);
  return complaints;
}

}  // namespace tetfarm
