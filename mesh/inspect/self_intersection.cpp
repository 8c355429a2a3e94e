#include "mesh/inspect/self_intersection.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "base/check.h"
#include "base/counted.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/triangle_intersection.h"
#include "mesh/inspect/defect_text.h"

namespace tetfarm {
namespace {

std::vector<std::int32_t> numbers_in(const std::vector<char>& sieve) {
  std::vector<std::int32_t> numbers;
  numbers.reserve(sieve.size() -
                  static_cast<std::size_t>(std::count(sieve.begin(), sieve.end(), 0)));
  for (std::size_t t = 0; t < sieve.size(); ++t) {
    if (sieve[t] != 0) numbers.push_back(static_cast<std::int32_t>(t));
  }
  return numbers;
}

std::vector<Box3> boxes_of(const SurfaceMesh& surface, const std::vector<std::int32_t>& numbers) {
  std::vector<Box3> boxes(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (const std::int32_t v : surface.triangles[static_cast<std::size_t>(numbers[i])]) {
      boxes[i].add(surface.vertices[static_cast<std::size_t>(v)]);
    }
  }
  return boxes;
}

}  // namespace

std::optional<SurfaceDefect> check_self_intersection(const SurfaceMesh& surface,
                                                     const std::vector<char>& sieve) {
  TF_CHECK(sieve.size() == surface.triangles.size());
  const std::vector<std::int32_t> numbers = numbers_in(sieve);
  const auto triangle = [&](std::size_t i) -> const Triangle& {
    return surface.triangles[static_cast<std::size_t>(numbers[i])];
  };
  const BoxTree tree(boxes_of(surface, numbers));
  std::vector<char> is_hit(numbers.size(), 0);
  std::size_t count = 0;
  std::set<std::pair<std::int32_t, std::int32_t>> first;  // the few lowest pairs
  tree.self_pairs([&](std::int32_t i, std::int32_t j) {
    const auto a = static_cast<std::size_t>(i);
    const auto b = static_cast<std::size_t>(j);
    if (!triangles_meet_beyond_shared(surface.vertices, triangle(a), triangle(b))) return;
    is_hit[a] = is_hit[b] = 1;
    ++count;
    first.emplace(i, j);
    if (first.size() > places_named) first.erase(std::prev(first.end()));
  });
  if (count == 0) return std::nullopt;
  SurfaceDefect defect{"self-intersection", "", {}};
  for (std::size_t t = 0; t < numbers.size(); ++t) {
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
