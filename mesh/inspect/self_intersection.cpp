#include "mesh/inspect/self_intersection.h"

#include <set>
#include <string>
#include <utility>

#include "base/check.h"
#include "base/counted.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/inspect/defect_text.h"

namespace tetfarm {

std::optional<SurfaceDefect> check_self_intersection(const SurfaceMesh& surface,
                                                     const std::vector<char>& sieve) {
  std::vector<Triangle> triangles;
  TF_CHECK(sieve.size() == surface.triangles.size());
  std::vector<std::int32_t> numbers;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if (sieve[t] == 0) continue;
    triangles.push_back(surface.triangles[t]);
    numbers.push_back(static_cast<std::int32_t>(t));
  }
  const BoxTree tree(triangle_boxes(surface.vertices, triangles));
  std::vector<char> is_hit(triangles.size(), 0);
  std::size_t count = 0;
  std::set<std::pair<std::int32_t, std::int32_t>> first;  // the few lowest pairs
  tree.self_pairs([&](std::int32_t i, std::int32_t j) {
    const auto a = static_cast<std::size_t>(i);
    const auto b = static_cast<std::size_t>(j);
    if (!triangles_meet_beyond_shared(surface.vertices, triangles[a], triangles[b])) return;
    is_hit[a] = is_hit[b] = 1;
    ++count;
    first.emplace(i, j);
    if (first.size() > places_named) first.erase(std::prev(first.end()));
  });
  if (count == 0) return std::nullopt;
  SurfaceDefect defect{"self-intersection", "", {}};
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (is_hit[t] != 0) defect.triangles.push_back(numbers[t]);
  }
  std::vector<std::string> places;
  for (const auto& [i, j] : first) {
    places.push_back(triangle_text(surface, numbers[static_cast<std::size_t>(i)]) + " meets " +
                     triangle_text(surface, numbers[static_cast<std::size_t>(j)]));
  }
  defect.message = with_places(counted(count, "pair") + " of triangles that intersect or touch, " +
                                   counted(defect.triangles.size(), "triangle") + " in all",
                               places, count);
  return defect;
}

}  // namespace tetfarm
