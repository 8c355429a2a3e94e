// The generators of CAD-like surfaces keep what they promise: the tests of the volume kernel lean
// on it.
#include "tests/support/cad_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "mesh/core/validate.h"
#include "mesh/inspect/surface_check.h"

namespace tetfarm {
namespace {

class CadSurfaces : public testing::TestWithParam<shapes::SurfaceGenerator> {
 protected:
  static void expect_valid(const SurfaceMesh& surface) {
    EXPECT_TRUE(unmatched_edges(surface.triangles).empty());
    EXPECT_GT(enclosed_volume(surface.vertices, surface.triangles), 0);
    const CheckedSurface checked = check_surface(surface);
    for (const SurfaceDefect& defect : checked.report.defects) ADD_FAILURE() << defect.message;
    EXPECT_EQ(checked.surface.triangles, surface.triangles) << "turned to be oriented";
  }
};

TEST_P(CadSurfaces, are_valid_and_oriented_by_construction) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_valid(GetParam().make(seed, 0));
    expect_valid(GetParam().make(seed, 1));
  }
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE("size 2, seed " + std::to_string(seed));
    expect_valid(GetParam().make(seed, 2));
  }
}

TEST_P(CadSurfaces, are_valid_when_they_are_moved_exactly) {
  for (std::uint64_t seed = 100; seed < 124; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const CheckedSurface checked =
        check_surface(shapes::moved_exactly(GetParam().make(seed, 1), seed));
    EXPECT_TRUE(checked.report.defects.empty());
  }
}

TEST_P(CadSurfaces, are_the_same_for_the_same_seed_and_others_for_others) {
  const SurfaceMesh one = GetParam().make(7, 1);
  EXPECT_EQ(one.vertices, GetParam().make(7, 1).vertices);
  EXPECT_EQ(one.triangles, GetParam().make(7, 1).triangles);
  EXPECT_NE(one.vertices, GetParam().make(8, 1).vertices);
}

INSTANTIATE_TEST_SUITE_P(Generators, CadSurfaces,
                         testing::ValuesIn(shapes::cad_surface_generators().begin(),
                                           shapes::cad_surface_generators().end()),
                         [](const auto& test) { return std::string(test.param.name); });

int most_triangles_of_a_node(const SurfaceMesh& surface) {
  std::map<std::int32_t, int> count;
  for (const Triangle& t : surface.triangles) {
    for (const std::int32_t v : t) ++count[v];
  }
  int most = 0;
  for (const auto& [node, triangles] : count) most = std::max(most, triangles);
  return most;
}

TEST(CadSurface, of_a_large_fan_has_a_node_of_more_than_a_thousand_triangles) {
  const auto fan = shapes::cad_surface_generators()[1];
  ASSERT_EQ(fan.name, std::string("fan_node"));
  int most = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    most = std::max(most, most_triangles_of_a_node(fan.make(seed, 3)));
  }
  EXPECT_GT(most, 1000);
  EXPECT_LE(most, 2010);
}

}  // namespace
}  // namespace tetfarm
