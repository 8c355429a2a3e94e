#include "mesh/inspect/triangle_defects.h"

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "mesh/core/complaints.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/inspect/defect_text.h"

namespace tetfarm {
namespace {

using Numbers = std::vector<std::int32_t>;

bool usable(double x) {
  return std::isfinite(x) && (x == 0 || (std::abs(x) >= 1e-60 && std::abs(x) <= 1e60));
}
bool usable(const Vec3& p) { return usable(p.x) && usable(p.y) && usable(p.z); }

bool indices_exist(const Triangle& t, std::size_t vertices) {
  return std::ranges::all_of(
      t, [vertices](std::int32_t v) { return v >= 0 && static_cast<std::size_t>(v) < vertices; });
}

Numbers bad_indices(const SurfaceMesh& surface) {
  Numbers bad;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (!indices_exist(surface.triangles[t], surface.vertices.size())) {
      bad.push_back(static_cast<std::int32_t>(t));
    }
  }
  return bad;
}

SurfaceDefect bad_index_defect(const SurfaceMesh& surface, const Numbers& bad) {
  std::vector<std::string> places;
  for (std::size_t i = 0; i < std::min(bad.size(), places_named); ++i) {
    const Triangle& t = surface.triangles[static_cast<std::size_t>(bad[i])];
    places.push_back("triangle " + std::to_string(bad[i]) + " has vertices " +
                     std::to_string(t[0]) + ", " + std::to_string(t[1]) + ", " +
                     std::to_string(t[2]));
  }
  const std::string what = counted(bad.size(), "triangle") + " with vertex numbers outside 0 to " +
                           std::to_string(static_cast<std::int64_t>(surface.vertices.size()) - 1);
  return {"bad vertex number", with_places(what, places, bad.size()), {bad.begin(), bad.end()}};
}

/// The triangles for which `is_bad` holds, out of those that the sieve lets through; these are
/// taken out.
template <typename Predicate>
Numbers take_out(const SurfaceMesh& surface, std::vector<char>& sieve, Predicate is_bad) {
  Numbers taken;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (sieve[t] != 0 && is_bad(surface.triangles[t])) {
      sieve[t] = 0;
      taken.push_back(static_cast<std::int32_t>(t));
    }
  }
  return taken;
}

bool repeats_a_vertex(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Sorted groups of triangles with the same three vertices, the groups in the order of their first
/// triangle.
std::vector<Numbers> equal_triangles(const SurfaceMesh& surface, const std::vector<char>& sieve) {
  std::vector<std::pair<Triangle, std::int32_t>> keys;
  keys.reserve(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (sieve[t] == 0) continue;
    Triangle key = surface.triangles[t];
    std::ranges::sort(key);
    keys.emplace_back(key, static_cast<std::int32_t>(t));
  }
  std::ranges::sort(keys);
  std::vector<Numbers> groups;
  for (std::size_t i = 0; i < keys.size();) {
    Numbers group;
    const std::size_t first = i;
    for (; i < keys.size() && keys[i].first == keys[first].first; ++i)
      group.push_back(keys[i].second);
    if (group.size() > 1) groups.push_back(std::move(group));
  }
  std::ranges::sort(groups);
  return groups;
}

SurfaceDefect duplicate_defect(const SurfaceMesh& surface, const std::vector<Numbers>& groups) {
  std::vector<std::string> places;
  SurfaceDefect defect{"duplicate triangle", "", {}};
  for (const Numbers& group : groups) {
    defect.triangles.insert(defect.triangles.end(), group.begin(), group.end());
    if (places.size() == places_named) continue;
    places.push_back(triangle_text(surface, group[0]) + " again as " + std::to_string(group[1]));
  }
  std::ranges::sort(defect.triangles);
  defect.message = with_places(counted(groups.size(), "triangle") + " present more than once",
                               places, groups.size());
  return defect;
}

void check_counts(const SurfaceMesh& surface, std::vector<SurfaceDefect>& defects) {
  const std::size_t n = surface.triangles.size();
  if (n >= 4) return;
  SurfaceDefect defect{"too few triangles",
                       n == 0
                           ? "no triangles at all"
                           : "only " + counted(n, "triangle") + "; a closed surface has at least 4",
                       {}};
  for (std::size_t t = 0; t < n; ++t) defect.triangles.push_back(static_cast<std::int64_t>(t));
  defects.push_back(defect);
}

}  // namespace

TriangleCheck check_triangles(const SurfaceMesh& surface) {
  TriangleCheck check;
  auto& [defects, sieve] = check;
  const std::size_t n = surface.triangles.size();
  check_counts(surface, defects);
  sieve.for_edges.assign(n, 1);
  if (const Numbers bad = bad_indices(surface); !bad.empty()) {
    defects.push_back(bad_index_defect(surface, bad));
    for (const std::int32_t t : bad) sieve.for_edges[static_cast<std::size_t>(t)] = 0;
  }
  const auto points = [&surface](const Triangle& t) {
    return triangle_points(surface.vertices, t);
  };
  const Numbers off = take_out(surface, sieve.for_edges, [&points](const Triangle& t) {
    return !std::ranges::all_of(points(t), [](const Vec3& p) { return usable(p); });
  });
  if (!off.empty()) {
    defects.push_back(defect_of_triangles(
        surface, "bad coordinate",
        counted(off.size(), "triangle") +
            " with a coordinate that is not a number, or beyond 1e60, or below 1e-60 but not 0",
        off));
  }
  Numbers flat = take_out(surface, sieve.for_edges, repeats_a_vertex);
  sieve.for_contact = sieve.for_edges;
  const Numbers thin = take_out(surface, sieve.for_contact,
                                [&points](const Triangle& t) { return is_degenerate(points(t)); });
  flat.insert(flat.end(), thin.begin(), thin.end());
  std::ranges::sort(flat);
  if (!flat.empty()) {
    defects.push_back(defect_of_triangles(
        surface, "degenerate triangle", counted(flat.size(), "triangle") + " without area", flat));
  }
  if (const auto groups = equal_triangles(surface, sieve.for_edges); !groups.empty()) {
    defects.push_back(duplicate_defect(surface, groups));
    for (const Numbers& group : groups) {
      for (std::size_t i = 1; i < group.size(); ++i) {
        sieve.for_edges[static_cast<std::size_t>(group[i])] = 0;
        sieve.for_contact[static_cast<std::size_t>(group[i])] = 0;
      }
    }
  }
  return check;
}

}  // namespace tetfarm
