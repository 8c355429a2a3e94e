#include "mesh/core/subdomain_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "base/array_index.h"
#include "tests/support/shapes.h"
#include "tests/support/voxel_surface.h"

namespace tetfarm {
namespace {

/// Cubes with labels by chance as a sub-domain of several regions; `cubes` of each region.
struct Cubes {
  explicit Cubes(unsigned seed) {
    std::mt19937 random(seed);
    std::array<int, 36> labels{};
    for (int& label : labels) label = static_cast<int>(random() % 4);
    const shapes::VoxelSurface made = shapes::voxel_surface(
        {{4, 3, 3}, [&](int x, int y, int z) { return labels[at(x + 4 * (y + 3 * z))]; }});
    SurfaceMesh surface = made.surface;
    for (const auto& [behind, front] : made.sets) surface.sides.push_back({behind, front});
    cubes = made.cubes_of_set;
    root = root_subdomain(surface);
  }
  std::int32_t regions() const { return static_cast<std::int32_t>(cubes.size()) - 1; }

  std::vector<int> cubes;
  Subdomain root;
};

TEST(SubdomainRegions, of_several_are_all_of_them_once_and_of_one_that_one) {
  const Cubes cubes(3);
  ASSERT_GT(cubes.regions(), 5);
  const std::vector<std::int32_t> regions = regions_of(cubes.root);
  ASSERT_EQ(std::ssize(regions), cubes.regions());
  for (std::int32_t i = 0; i < cubes.regions(); ++i) EXPECT_EQ(regions[at(i)], i + 1);
  Subdomain one = root_subdomain(shapes::unit_cube());
  EXPECT_EQ(regions_of(one), std::vector<std::int32_t>{1});
  one.region = 7;
  EXPECT_EQ(regions_of(one), std::vector<std::int32_t>{7});
  EXPECT_EQ(triangles_out_of(one, 7), one.triangles);
}

TEST(SubdomainRegions, have_triangles_that_turn_out_of_them_and_enclose_their_cubes) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Cubes cubes(seed);
    for (std::int32_t region = 1; region <= cubes.regions(); ++region) {
      EXPECT_NEAR(enclosed_volume(cubes.root.vertices, triangles_out_of(cubes.root, region)),
                  cubes.cubes[at(region)], 1e-12);
    }
  }
}

TEST(SubdomainRegions, are_halved_in_their_order_the_lower_half_never_the_larger) {
  for (std::int32_t count = 1; count < 10; ++count) {
    std::vector<std::int32_t> regions;
    for (std::int32_t i = 0; i < count; ++i) regions.push_back(3 * i + 2);
    const RegionHalves halves = halves_of(regions);
    std::vector<std::int32_t> both = halves.left;
    both.insert(both.end(), halves.right.begin(), halves.right.end());
    EXPECT_EQ(both, regions);
    EXPECT_EQ(std::ssize(halves.left), count / 2);
  }
}

/// Calls visit(path, region) for leaves one level below where one region is left.
template <class Visit>
void for_each_leaf(const std::vector<std::int32_t>& regions, TreePath path, const Visit& visit) {
  if (regions.size() == 1) {
    visit(path, regions.front());
    visit(path.left(), regions.front());
    visit(path.right().right(), regions.front());
    return;
  }
  const RegionHalves halves = halves_of(regions);
  for_each_leaf(halves.left, path.left(), visit);
  for_each_leaf(halves.right, path.right(), visit);
}

TEST(SubdomainRegions, of_leaves_are_told_by_their_paths_alone) {
  for (std::int32_t count = 1; count <= 9; ++count) {
    std::vector<std::int32_t> regions;
    for (std::int32_t region = 1; region <= count; ++region) regions.push_back(region);
    int leaves = 0;
    for_each_leaf(regions, {}, [&](TreePath path, std::int32_t region) {
      EXPECT_EQ(region_of_leaf(path, count), region) << path.text() << " of " << count;
      ++leaves;
    });
    EXPECT_EQ(leaves, 3 * count);
  }
}

TEST(SubdomainRegions, that_are_taken_out_are_whole_and_keep_their_origins) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Cubes cubes(seed);
    std::vector<std::int32_t> regions = regions_of(cubes.root);
    for (; !regions.empty(); regions = halves_of(regions).left) {
      const Subdomain part = part_of_regions(cubes.root, regions, TreePath{5});
      EXPECT_TRUE(validate(part).empty());
      EXPECT_EQ(part.path.heap, 5U);
      EXPECT_EQ(regions_of(part), regions);
      for (const std::int32_t region : regions) {
        EXPECT_NEAR(enclosed_volume(part.vertices, triangles_out_of(part, region)),
                    cubes.cubes[at(region)], 1e-12);
      }
      const auto kept = [&](std::int32_t region) {
        return std::binary_search(regions.begin(), regions.end(), region);
      };
      const auto expected =
          std::count_if(cubes.root.sides.begin(), cubes.root.sides.end(),
                        [&](const Sides& sides) { return kept(sides[0]) || kept(sides[1]); });
      EXPECT_EQ(std::ssize(part.triangles), expected);
      EXPECT_EQ(part.sides.empty(), regions.size() == 1);
      for (const Sides& sides : part.sides) {
        for (const std::int32_t region : sides) EXPECT_TRUE(region == 0 || kept(region));
      }
      for (std::size_t v = 0; v < part.vertices.size(); ++v) {
        const auto origin = std::find(cubes.root.node_origin.begin(), cubes.root.node_origin.end(),
                                      part.node_origin[v]);
        ASSERT_NE(origin, cubes.root.node_origin.end());
        EXPECT_EQ(cubes.root.vertices[at(origin - cubes.root.node_origin.begin())],
                  part.vertices[v]);
      }
    }
  }
}

}  // namespace
}  // namespace tetfarm
