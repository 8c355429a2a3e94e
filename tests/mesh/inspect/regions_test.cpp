// Surfaces of several regions: what the check makes of them.
#include <gmock/gmock.h>

#include <map>
#include <set>

#include "base/error.h"
#include "mesh/core/subdomain_regions.h"
#include "mesh/core/validate.h"
#include "mesh/inspect/region_map.h"
#include "mesh/inspect/surface_sides.h"
#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"
#include "tests/support/voxel_surface.h"

namespace tetfarm {
namespace {

using shapes::Voxels;
using shapes::VoxelSurface;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::vector<double> volumes(const CheckedSurface& checked) {
  std::vector<double> result;
  for (const RegionFigures& region : checked.report.regions) {
    if (region.number > 0) result.push_back(region.volume);
  }
  return result;
}

/// Every region of the root is closed, and they have the volumes that the report says.
void expect_closed_regions(const CheckedSurface& checked) {
  ASSERT_THAT(kinds(checked.report), IsEmpty());
  const Subdomain root = root_subdomain(checked.surface);
  EXPECT_THAT(validate(root), IsEmpty());
  double sum = 0;
  for (const RegionFigures& region : checked.report.regions) {
    if (region.number == 0) continue;
    EXPECT_NEAR(enclosed_volume(root.vertices, triangles_out_of(root, region.number)),
                region.volume, 1e-9 * region.volume);
    sum += region.volume;
  }
  EXPECT_NEAR(checked.report.volume, sum, 1e-9 * sum);
  EXPECT_NEAR(domain_volume(checked.surface), sum, 1e-9 * sum);
}

SurfaceMesh row_of_cubes(int labels) {
  return shapes::voxel_surface({{labels, 1, 1}, [](int x, int, int) { return x + 1; }}).surface;
}

TEST(Regions, of_two_cubes_with_a_common_face_are_two) {
  const CheckedSurface checked = check_surface(row_of_cubes(2));
  expect_closed_regions(checked);
  EXPECT_THAT(volumes(checked), ElementsAre(1, 1));
  EXPECT_EQ(std::ranges::count(checked.surface.sides, Sides{1, 2}), 2);
  EXPECT_EQ(std::ranges::count(checked.surface.sides, Sides{1, 0}), 10);
  EXPECT_EQ(std::ranges::count(checked.surface.sides, Sides{2, 0}), 10);
  EXPECT_THAT(checked.surface.region_names, ElementsAre("region 1", "region 2"));
}

TEST(Regions, do_not_depend_on_which_way_the_triangles_face) {
  const SurfaceMesh given = row_of_cubes(3);
  const CheckedSurface as_given = check_surface(given);
  std::mt19937 random(1);
  for (int i = 0; i < 10; ++i) {
    SurfaceMesh flipped = given;
    for (Triangle& t : flipped.triangles) {
      if (below(random, 2) == 0) std::swap(t[1], t[2]);
    }
    const CheckedSurface checked = check_surface(flipped);
    expect_closed_regions(checked);
    EXPECT_THAT(volumes(checked), ElementsAre(1, 1, 1));
    EXPECT_EQ(checked.surface.sides.size(), as_given.surface.sides.size());
  }
}

/// Three wedges round the z axis, of a prism whose foot is a triangle.
SurfaceMesh three_wedges() {
  SurfaceMesh mesh;
  for (const double z : {0.0, 1.0}) {
    mesh.vertices.insert(mesh.vertices.end(), {{0, 0, z}, {2, 0, z}, {-1, 2, z}, {-1, -2, z}});
  }
  for (std::int32_t i = 1; i <= 3; ++i) {
    const std::int32_t j = i % 3 + 1;
    mesh.triangles.push_back({0, i, j});
    mesh.triangles.push_back({4, i + 4, j + 4});
    mesh.triangles.push_back({i, j, j + 4});
    mesh.triangles.push_back({i, j + 4, i + 4});
    mesh.triangles.push_back({0, i, i + 4});
    mesh.triangles.push_back({0, i + 4, 4});
  }
  return mesh;
}

TEST(Regions, may_meet_in_an_edge) {
  const CheckedSurface wedges = check_surface(three_wedges());
  expect_closed_regions(wedges);
  EXPECT_THAT(volumes(wedges), ElementsAre(2, 2, 2));
  const auto quarters = check_surface(
      shapes::voxel_surface({{2, 2, 1}, [](int x, int y, int) { return 1 + x + 2 * y; }}).surface);
  expect_closed_regions(quarters);
  EXPECT_THAT(volumes(quarters), ElementsAre(1, 1, 1, 1));
}

TEST(Regions, that_share_only_an_edge_are_two) {
  const CheckedSurface checked = check_surface(
      shapes::voxel_surface({{2, 2, 1}, [](int x, int y, int) { return x == y ? 1 : 0; }}).surface);
  expect_closed_regions(checked);
  EXPECT_THAT(volumes(checked), ElementsAre(1, 1));
  EXPECT_THAT(checked.surface.sides, testing::Not(Contains(Sides{1, 2})));
}

TEST(Regions, that_share_only_a_vertex_stay_one_domain_unless_the_job_names_them) {
  const SurfaceMesh mesh =
      welded(joined(shapes::unit_cube(), shapes::box({1, 1, 1}, {2, 2, 2}, 1)));
  EXPECT_THAT(check_surface(mesh).surface.sides, IsEmpty());
  const CheckedSurface named = check_surface(
      mesh, {.wishes = {{{0.5, 0.5, 0.5}, "low", false}}, .is_outside_meshed = false});
  expect_closed_regions(named);
  EXPECT_THAT(named.surface.region_names, ElementsAre("low", "region 2"));
}

SurfaceMesh cube_in_cube() {
  return shapes::between(shapes::box({0, 0, 0}, {4, 4, 4}, 2),
                         shapes::box({1, 1, 1}, {3, 3, 3}, 2));
}

TEST(Regions, of_nested_shells_are_void_in_turn_unless_the_job_says_otherwise) {
  const CheckedSurface plain = check_surface(cube_in_cube());
  EXPECT_THAT(plain.surface.sides, IsEmpty());
  EXPECT_NEAR(plain.report.volume, 56, 1e-12);
  const CheckedSurface both = check_surface(
      cube_in_cube(), {.wishes = {{{2, 2, 2}, "core", false}}, .is_outside_meshed = false});
  expect_closed_regions(both);
  EXPECT_THAT(volumes(both), ElementsAre(56, 8));
  EXPECT_THAT(both.surface.region_names, ElementsAre("region 1", "core"));
}

TEST(Regions, are_found_by_points_however_deep_and_in_whatever_order_the_shells_come) {
  const auto cube = [](double low, double high) {
    return shapes::box({low, low, low}, {high, high, high}, 2);
  };
  const std::vector<RegionWish> wishes = {{{3.5, 3.5, 3.6}, "kernel", false},
                                          {{2.5, 2.5, 2.6}, "shell", false},
                                          {{1.5, 1.5, 1.6}, "void", true},
                                          {{0.5, 0.5, 0.6}, "skin", false}};
  const SurfaceMesh inward = joined(joined(cube(0, 8), cube(1, 7)), joined(cube(2, 6), cube(3, 5)));
  const SurfaceMesh outward =
      joined(joined(cube(3, 5), cube(2, 6)), joined(cube(1, 7), cube(0, 8)));
  for (const SurfaceMesh& mesh : {inward, outward}) {
    const CheckedSurface checked =
        check_surface(mesh, {.wishes = wishes, .is_outside_meshed = false});
    expect_closed_regions(checked);
    std::map<std::string, double> volume_of;
    for (const RegionFigures& region : checked.report.regions) {
      volume_of[region.name] = region.volume;
    }
    EXPECT_NEAR(volume_of["kernel"], 8, 1e-12);
    EXPECT_NEAR(volume_of["shell"], 64 - 8, 1e-12);
    EXPECT_NEAR(volume_of["void"], 216 - 64, 1e-12);
    EXPECT_NEAR(volume_of["skin"], 512 - 216, 1e-12);
    EXPECT_NEAR(checked.report.volume, 512 - 216 + 64, 1e-9);
  }
}

TEST(Regions, may_be_declared_void) {
  const CheckedSurface checked = check_surface(
      row_of_cubes(3), {.wishes = {{{1.5, 0.5, 0.5}, "", true}, {{2.5, 0.5, 0.5}, "right", false}},
                        .is_outside_meshed = false});
  expect_closed_regions(checked);
  EXPECT_THAT(checked.surface.region_names, ElementsAre("region 1", "right"));
  EXPECT_THAT(volumes(checked), ElementsAre(1, 1));
}

TEST(Regions, of_a_body_under_an_outer_boundary_are_void_unless_named) {
  const OuterBoundary outer{OuterBoundary::Kind::box, 3, 0};
  for (const bool is_named : {false, true}) {
    RegionRules rules;
    rules.is_outside_meshed = true;
    if (is_named) rules.wishes.push_back({{0.5, 0.5, 0.5}, "left", false});
    const CheckedSurface body = check_surface(row_of_cubes(2), rules);
    ASSERT_THAT(kinds(body.report), IsEmpty());
    const SurfaceMesh domain = add_outer_boundary(body.surface, outer, 0.3);
    EXPECT_THAT(validate(root_subdomain(domain)), IsEmpty());
    EXPECT_NEAR(domain_volume(domain), is_named ? 215 : 214, 1e-9);
    EXPECT_EQ(region_count(domain), is_named ? 2 : 1);
    EXPECT_EQ(domain.region_names[0], "outside");
  }
}

TEST(Regions, refuse_points_that_name_none) {
  const auto refusal = [](const std::vector<RegionWish>& wishes) -> std::string {
    try {
      check_surface(row_of_cubes(2), {.wishes = wishes, .is_outside_meshed = false});
    } catch (const UsageError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal({{{1, 0.5, 0.5}, "", false}}), HasSubstr("(1, 0.5, 0.5) is on the surface"));
  EXPECT_THAT(refusal({{{5, 0.5, 0.5}, "", false}}), HasSubstr("is outside the surface"));
  EXPECT_THAT(refusal({{{0.5, 0.5, 0.5}, "", false}, {{0.6, 0.5, 0.5}, "", false}}),
              HasSubstr("is in the same region as (0.5, 0.5, 0.5)"));
}

TEST(Regions, refuse_to_make_the_outside_void_where_it_is_to_be_meshed) {
  try {
    check_surface(shapes::unit_cube(),
                  {.wishes = {{{5, 0.5, 0.5}, "", true}}, .is_outside_meshed = true});
    ADD_FAILURE() << "it was taken";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("meshed up to the outer boundary"));
  }
}

TEST(Regions, that_are_all_void_leave_nothing_to_mesh) {
  const CheckedSurface checked = check_surface(
      shapes::unit_cube(), {.wishes = {{{0.5, 0.5, 0.5}, "", true}}, .is_outside_meshed = false});
  EXPECT_THAT(kinds(checked.report), ElementsAre("nothing to mesh"));
}

TEST(Regions, are_not_made_by_a_sheet_that_ends_inside) {
  SurfaceMesh mesh = row_of_cubes(2);
  const auto wall = std::ranges::find_if(mesh.triangles, [&mesh](const Triangle& t) {
    return std::ranges::all_of(
        t, [&mesh](std::int32_t v) { return mesh.vertices[static_cast<std::size_t>(v)].x == 1; });
  });
  mesh.triangles.erase(wall);
  const CheckedSurface checked = check_surface(mesh);
  ASSERT_THAT(kinds(checked.report), ElementsAre("open edge"));
  EXPECT_THAT(checked.report.defects[0].message, HasSubstr("1 open edge"));
  EXPECT_THAT(checked.report.defects[0].message, HasSubstr("a sheet that ends inside a region"));
}

TEST(Regions, are_not_made_by_a_wall_across_a_ring) {
  // A ring of eight cubes with one label but for one cube; then the walls of that cube are two, and
  // one of them is taken away.
  SurfaceMesh mesh =
      shapes::voxel_surface({{3, 3, 1},
                             [](int x, int y, int) {
                               return x == 1 && y == 1 ? 0 : x == 1 && y == 0 ? 2 : 1;
                             }})
          .surface;
  std::erase_if(mesh.triangles, [&mesh](const Triangle& t) {
    return std::ranges::all_of(t, [&mesh](std::int32_t v) {
      const Vec3& p = mesh.vertices[static_cast<std::size_t>(v)];
      return p.x == 1 && p.y <= 1;
    });
  });
  const CheckedSurface checked = check_surface(mesh);
  ASSERT_THAT(kinds(checked.report), ElementsAre("sheet inside a region"));
  EXPECT_THAT(checked.report.defects[0].message,
              HasSubstr("2 triangles with the same region on both sides"));
  EXPECT_EQ(checked.report.defects[0].triangles.size(), 2U);
}

TEST(Regions, of_random_cubes_are_those_of_a_flood_fill) {
  std::mt19937 random(7);
  for (int round = 0; round < 60; ++round) {
    const auto labels = 2 + below(random, 3);
    std::map<std::array<int, 3>, int> label;
    const Voxels voxels{{4, 3, 3}, [&](int x, int y, int z) {
                          const auto [it, is_new] = label.try_emplace({x, y, z}, 0);
                          if (is_new) it->second = static_cast<int>(below(random, labels));
                          return it->second;
                        }};
    const VoxelSurface made = shapes::voxel_surface(voxels);
    const std::vector<char> all(made.surface.triangles.size(), 1);
    const auto uses = edge_uses(made.surface.triangles, all);
    const RegionMap map(made.surface, join_sides(made.surface, uses));
    ASSERT_FALSE(map.unclear_part());
    ASSERT_EQ(map.regions() + 1, std::ssize(made.cubes_of_set));
    std::set<std::pair<int, int>> pairs;
    for (std::size_t t = 0; t < made.sets.size(); ++t) {
      for (std::size_t side = 0; side < 2; ++side) {
        pairs.emplace(made.sets[t][side], map.sides_of(t)[side]);
      }
    }
    // Each set is one region, and each region one set.
    EXPECT_EQ(pairs.size(), made.cubes_of_set.size());
    EXPECT_TRUE(pairs.contains({0, 0}));
    for (const auto& [set, region] : pairs) {
      if (set == 0) continue;
      EXPECT_NEAR(map.volume(region), made.cubes_of_set[static_cast<std::size_t>(set)], 1e-9);
    }
  }
}

}  // namespace
}  // namespace tetfarm
