#include "mesh/decompose/region_split.h"

#include <gmock/gmock.h>

#include "mesh/core/subdomain_regions.h"

namespace tetfarm {
namespace {

/// Boxes side by side along x, each a region, as wide as given; neighbours share a face.
Subdomain row_of_regions(const std::vector<double>& widths) {
  SurfaceMesh surface;
  double x = 0;
  const auto add_wall = [&surface](double at) {
    for (int i = 0; i < 4; ++i) {
      surface.vertices.push_back({at, static_cast<double>(i / 2), static_cast<double>(i % 2)});
    }
  };
  const auto add = [&surface](Triangle a, Triangle b, Sides sides) {
    surface.triangles.insert(surface.triangles.end(), {a, b});
    surface.sides.insert(surface.sides.end(), {sides, sides});
  };
  add_wall(0);
  add({0, 1, 3}, {0, 3, 2}, {1, 0});
  std::int32_t region = 0;
  for (const double width : widths) {
    ++region;
    x += width;
    add_wall(x);
    const std::int32_t a = 4 * (region - 1);
    const std::int32_t b = a + 4;
    add({a, b, b + 1}, {a, b + 1, a + 1}, {region, 0});
    add({a + 2, b + 3, b + 2}, {a + 2, a + 3, b + 3}, {region, 0});
    add({a, b + 2, b}, {a, a + 2, b + 2}, {region, 0});
    add({a + 1, b + 1, b + 3}, {a + 1, b + 3, a + 3}, {region, 0});
    const bool is_last = region == std::ssize(widths);
    add({b, b + 2, b + 3}, {b, b + 3, b + 1}, {region, is_last ? 0 : region + 1});
    surface.region_names.emplace_back("r");
  }
  return root_subdomain(surface);
}

TEST(RegionSplit, goes_on_until_each_subdomain_is_the_region_that_its_path_says) {
  const Subdomain root = row_of_regions({1, 1, 1, 1, 1, 1, 1});
  ASSERT_EQ(validate(root), std::vector<std::string>());
  std::vector<Subdomain> open = {root};
  std::vector<std::int32_t> found;
  while (!open.empty()) {
    const Subdomain here = open.back();
    open.pop_back();
    EXPECT_EQ(validate(here), std::vector<std::string>());
    if (here.region > 0) {
      EXPECT_EQ(region_of_leaf(here.path, 7), here.region);
      EXPECT_EQ(region_of_leaf(here.path.left().right(), 7), here.region) << "below it too";
      EXPECT_NEAR(enclosed_volume(here.vertices, here.triangles), 1, 1e-14);
      found.push_back(here.region);
      continue;
    }
    RegionSplit split = split_regions(here, SpacingField(0.5), 7);
    open.push_back(std::move(split.left));
    open.push_back(std::move(split.right));
  }
  EXPECT_THAT(found, testing::UnorderedElementsAre(1, 2, 3, 4, 5, 6, 7));
}

TEST(RegionSplit, gives_each_region_parts_by_its_work_and_one_at_least) {
  const Subdomain root = row_of_regions({12, 0.25});
  const RegionSplit many = split_regions(root, SpacingField(0.5), 10);
  EXPECT_EQ(many.left_parts, 9);
  EXPECT_EQ(many.right_parts, 1);
  const RegionSplit even = split_regions(row_of_regions({3, 3}), SpacingField(0.5), 6);
  EXPECT_EQ(even.left_parts, 3);
  EXPECT_EQ(even.right_parts, 3);
}

TEST(RegionSplit, keeps_the_origins_of_what_both_sides_share) {
  const Subdomain root = row_of_regions({1, 1});
  const RegionSplit split = split_regions(root, SpacingField(0.5), 2);
  std::vector<Origin> shared;
  for (const Origin& origin : split.left.triangle_origin) {
    if (std::ranges::count(split.right.triangle_origin, origin) > 0) shared.push_back(origin);
  }
  EXPECT_EQ(shared.size(), 2U);
}

TEST(RegionSplit, gives_what_is_left_over_to_the_first_of_regions_that_are_as_large) {
  const Subdomain root = row_of_regions({1, 1, 1, 1});
  const SpacingField spacing(0.3);
  for (const auto& [parts, left] : {std::pair{4, 2}, {5, 3}, {6, 4}, {7, 4}, {8, 4}}) {
    const RegionSplit split = split_regions(root, spacing, parts);
    EXPECT_EQ(split.left_parts, left) << parts;
    EXPECT_EQ(split.right_parts, parts - left) << parts;
  }
}

TEST(RegionSplit, gives_more_parts_to_larger_regions) {
  const RegionSplit split = split_regions(row_of_regions({4, 1}), SpacingField(0.2), 5);
  EXPECT_EQ(split.left_parts, 4);
  EXPECT_EQ(split.right_parts, 1);
}

}  // namespace
}  // namespace tetfarm
