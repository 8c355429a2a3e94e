#include "mesh/inspect/surface_sides.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>

#include "base/array_index.h"
#include "mesh/core/validate.h"
#include "tests/support/voxel_surface.h"

namespace tetfarm {
namespace {

SurfaceSides sides_joined(const SurfaceMesh& surface) {
  const std::vector<char> all(surface.triangles.size(), 1);
  return join_sides(surface, edge_uses(surface.triangles, all));
}

shapes::VoxelSurface random_cubes(std::mt19937& random) {
  std::array<int, 36> labels{};
  for (int& label : labels) label = static_cast<int>(random() % 3);
  return shapes::voxel_surface(
      {{4, 3, 3}, [&](int x, int y, int z) { return labels[at(x + 4 * (y + 3 * z))]; }});
}

TEST(SurfaceSides, that_are_joined_are_of_one_region_and_close_round_it) {
  std::mt19937 random(3);
  for (int round = 0; round < 30; ++round) {
    const shapes::VoxelSurface made = random_cubes(random);
    const SurfaceSides sides = sides_joined(made.surface);
    std::map<std::int32_t, std::set<int>> regions_of_sheet;
    std::map<std::int32_t, std::vector<Triangle>> sheets;
    for (std::size_t t = 0; t < made.surface.triangles.size(); ++t) {
      const auto& [a, b, c] = made.surface.triangles[t];
      const std::int32_t behind = sides.side2sheet[side_behind(t)];
      const std::int32_t front = sides.side2sheet[side_in_front(t)];
      regions_of_sheet[behind].insert(made.sets[t][0]);
      regions_of_sheet[front].insert(made.sets[t][1]);
      sheets[behind].push_back({a, b, c});
      sheets[front].push_back({a, c, b});
    }
    EXPECT_EQ(std::ssize(sheets), sides.sheets);
    std::set<int> seen;
    for (const auto& [sheet, regions] : regions_of_sheet) {
      EXPECT_EQ(regions.size(), 1U);
      seen.insert(*regions.begin());
    }
    EXPECT_EQ(seen.size(), made.cubes_of_set.size());
    for (const auto& [sheet, triangles] : sheets) {
      EXPECT_TRUE(unmatched_edges(triangles).empty());
    }
  }
}

TEST(SurfaceSides, parts_are_joined_over_edges_and_all_are_numbered_by_their_first) {
  std::mt19937 random(8);
  for (int round = 0; round < 30; ++round) {
    const SurfaceMesh surface = random_cubes(random).surface;
    const SurfaceSides sides = sides_joined(surface);
    // Each triangle takes the lowest number of those beside it, until nothing changes.
    std::vector<std::int32_t> lowest(surface.triangles.size());
    for (std::size_t t = 0; t < lowest.size(); ++t) lowest[t] = static_cast<std::int32_t>(t);
    std::map<std::set<std::int32_t>, std::set<std::size_t>> triangles_of_edge;
    for (std::size_t t = 0; t < lowest.size(); ++t) {
      const auto& [a, b, c] = surface.triangles[t];
      for (const auto& edge : {std::set{a, b}, std::set{b, c}, std::set{c, a}}) {
        triangles_of_edge[edge].insert(t);
      }
    }
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (const auto& [edge, triangles] : triangles_of_edge) {
        std::int32_t least = lowest[*triangles.begin()];
        for (const std::size_t t : triangles) least = std::min(least, lowest[t]);
        for (const std::size_t t : triangles) {
          has_changed = has_changed || lowest[t] != least;
          lowest[t] = least;
        }
      }
    }
    std::map<std::int32_t, std::int32_t> number;
    for (std::size_t t = 0; t < lowest.size(); ++t) {
      const auto next = static_cast<std::int32_t>(number.size());
      EXPECT_EQ(number.try_emplace(lowest[t], next).first->second, sides.triangle2part[t]);
    }
    EXPECT_EQ(std::ssize(number), sides.parts);
    std::int32_t next = 0;
    for (const std::int32_t sheet : sides.side2sheet) {
      EXPECT_LE(sheet, next);
      next = std::max(next, sheet + 1);
    }
    EXPECT_EQ(next, sides.sheets);
  }
}

/// Cubes in two rows of two, where the label is not 0.
SurfaceSides sides_of_cubes(const std::array<int, 4>& labels) {
  return sides_joined(
      shapes::voxel_surface(
          {{2, 2, 1}, [&labels](int x, int y, int) { return labels[at(x + 2 * y)]; }})
          .surface);
}

TEST(SurfaceSides, of_two_cubes_are_as_many_as_the_regions_that_they_bound) {
  const SurfaceSides one = sides_of_cubes({1, 0, 0, 0});
  EXPECT_EQ(one.sheets, 2);
  EXPECT_EQ(one.parts, 1);
  const SurfaceSides beside = sides_of_cubes({1, 2, 0, 0});
  EXPECT_EQ(beside.sheets, 3);
  EXPECT_EQ(beside.parts, 1);
  const SurfaceSides at_an_edge = sides_of_cubes({1, 0, 0, 1});
  EXPECT_EQ(at_an_edge.sheets, 3);
  EXPECT_EQ(at_an_edge.parts, 1);
  const SurfaceSides joined = sides_of_cubes({1, 1, 0, 0});
  EXPECT_EQ(joined.sheets, 2);
}

}  // namespace
}  // namespace tetfarm
