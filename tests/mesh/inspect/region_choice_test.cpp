#include "mesh/inspect/region_choice.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/inspect/region_map.h"
#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"
#include "tests/support/voxel_surface.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Chosen {
  SurfaceMesh surface;
  SurfaceReport report;
  std::optional<SurfaceDefect> defect;
};

Chosen chosen(const SurfaceMesh& surface, const RegionRules& rules, bool has_interfaces) {
  Chosen result{surface, {}, {}};
  const std::vector<char> all(surface.triangles.size(), 1);
  const RegionMap map(surface, join_sides(surface, edge_uses(surface.triangles, all)));
  result.defect = choose_regions(map, rules, has_interfaces, result.surface, result.report);
  return result;
}

/// Boxes round the origin, each in the next, with a volume of 8, 64 and 216 inside.
SurfaceMesh three_shells() {
  SurfaceMesh mesh = shapes::box({-3, -3, -3}, {3, 3, 3}, 1);
  for (const double half : {2.0, 1.0}) {
    mesh = joined(mesh, shapes::box({-half, -half, -half}, {half, half, half}, 1));
  }
  return mesh;
}

std::vector<std::pair<std::int32_t, double>> figures(const Chosen& choice) {
  std::vector<std::pair<std::int32_t, double>> result;
  for (const RegionFigures& region : choice.report.regions) {
    result.emplace_back(region.number, std::round(region.volume));
  }
  return result;
}

/// The regions of the surface enclose what they should, turned to point out of them.
double volume_of(const SurfaceMesh& surface, std::int32_t region) {
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    if (surface.sides[t][0] == region) triangles.push_back({a, b, c});
    if (surface.sides[t][1] == region) triangles.push_back({a, c, b});
  }
  return enclosed_volume(surface.vertices, triangles);
}

TEST(RegionChoice, without_interfaces_is_every_other_shell_inward) {
  const Chosen choice = chosen(three_shells(), {}, false);
  EXPECT_FALSE(choice.defect.has_value());
  EXPECT_THAT(figures(choice),
              ElementsAre(std::pair(1, 152.0), std::pair(0, 56.0), std::pair(2, 8.0)));
  EXPECT_THAT(choice.surface.region_names, ElementsAre("region 1", "region 2"));
  EXPECT_NEAR(choice.report.volume, 160, 1e-9);
  EXPECT_NEAR(volume_of(choice.surface, 1), 152, 1e-9);
  EXPECT_NEAR(volume_of(choice.surface, 2), 8, 1e-9);
  ASSERT_EQ(choice.report.shells.size(), 3U);
  EXPECT_EQ(choice.report.shells[2].parent, 1);
  EXPECT_EQ(choice.report.shells[2].depth, 2);
  EXPECT_THAT(choice.report.remarks, ElementsAre(HasSubstr("12 triangles pointed into")));
}

TEST(RegionChoice, with_interfaces_is_all_that_is_bounded) {
  const Chosen choice = chosen(three_shells(), {}, true);
  EXPECT_THAT(figures(choice),
              ElementsAre(std::pair(1, 152.0), std::pair(2, 56.0), std::pair(3, 8.0)));
  for (std::size_t t = 0; t < choice.surface.triangles.size(); ++t) {
    const auto [behind, front] = choice.surface.sides[t];
    EXPECT_GT(behind, 0);
    EXPECT_TRUE(front == 0 || behind < front) << "out of the one with the lower number";
  }
}

TEST(RegionChoice, under_an_outer_boundary_is_the_outside_and_every_other_shell_from_there) {
  RegionRules rules;
  rules.is_outside_meshed = true;
  const Chosen choice = chosen(three_shells(), rules, false);
  EXPECT_THAT(choice.surface.region_names, ElementsAre("outside", "region 2"));
  EXPECT_THAT(figures(choice), ElementsAre(std::pair(1, 0.0), std::pair(0, 152.0),
                                           std::pair(2, 56.0), std::pair(0, 8.0)));
  const Chosen with_interfaces = chosen(three_shells(), rules, true);
  EXPECT_THAT(with_interfaces.surface.region_names, ElementsAre("outside"));
}

TEST(RegionChoice, follows_wishes_and_leaves_out_what_is_between_voids) {
  RegionRules rules;
  rules.wishes = {{{0, 0, 0}, "", true}, {{1.5, 0, 0}, "shell", false}, {{2.5, 0, 0}, "", true}};
  const Chosen choice = chosen(three_shells(), rules, false);
  EXPECT_THAT(choice.surface.region_names, ElementsAre("shell"));
  EXPECT_NEAR(choice.report.volume, 56, 1e-9);
  EXPECT_EQ(std::count(choice.surface.sides.begin(), choice.surface.sides.end(), Sides{0, 0}), 12);
  EXPECT_THAT(choice.report.remarks, testing::Contains(HasSubstr("12 triangles with no meshed")));
  EXPECT_NEAR(volume_of(choice.surface, 1), 56, 1e-9);
}

TEST(RegionChoice, refuses_points_on_the_surface_outside_and_of_one_region_twice) {
  const auto refusal = [](const std::vector<RegionWish>& wishes, bool is_outside_meshed = false) {
    try {
      chosen(three_shells(), {wishes, is_outside_meshed}, false);
    } catch (const UsageError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal({{{1, 0.2, 0.1}, "a", false}}), HasSubstr("is on the surface"));
  EXPECT_THAT(refusal({{{5, 0, 0}, "a", false}}), HasSubstr("is outside the surface"));
  EXPECT_THAT(refusal({{{5, 0, 0}, "a", true}}, true), HasSubstr("is to be meshed up to"));
  EXPECT_EQ(refusal({{{5, 0, 0}, "a", false}}, true), "");
  EXPECT_THAT(refusal({{{0, 0, 0}, "a", false}, {{0.5, 0, 0}, "b", false}}),
              HasSubstr("is in the same region as"));
}

TEST(RegionChoice, of_voids_alone_is_a_defect) {
  RegionRules rules;
  rules.wishes = {{{0, 0, 0}, "", true}};
  const Chosen choice = chosen(shapes::box({-1, -1, -1}, {1, 1, 1}, 1), rules, false);
  ASSERT_TRUE(choice.defect.has_value());
  EXPECT_EQ(choice.defect->kind, "nothing to mesh");
}

}  // namespace
}  // namespace tetfarm
