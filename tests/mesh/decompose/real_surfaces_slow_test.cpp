#include <gmock/gmock.h>

#include <cstdlib>
#include <string>

#include "mesh/decompose/planar_cut.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/inspect/outer_boundary.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

struct Leaves {
  int count = 0;
  double volume = 0;
};

Leaves cut_into(const Subdomain& subdomain, const SpacingField& spacing, int parts) {
  EXPECT_THAT(validate(subdomain), IsEmpty());
  if (parts > 1) {
    CutOptions options;
    options.left_share = static_cast<double>(parts / 2) / parts;
    const CutOutcome outcome = planar_cut(subdomain, spacing, options);
    if (outcome.cut) {
      const Leaves left = cut_into(outcome.cut->left, spacing, parts / 2);
      const Leaves right = cut_into(outcome.cut->right, spacing, parts - parts / 2);
      return {left.count + right.count, left.volume + right.volume};
    }
    ADD_FAILURE() << subdomain.path.text() << ": " << outcome.reason;
  }
  return {1, enclosed_volume(subdomain.vertices, subdomain.triangles)};
}

void expect_sixteen_leaves(const std::string& file, bool is_body) {
  const char* data = std::getenv("TETFARM_DATA");
  if (data == nullptr) GTEST_SKIP() << "TETFARM_DATA is not set";
  SurfaceMesh surface = read_surface(std::string(data) + "/" + file);
  if (is_body) surface = add_outer_boundary(surface, {OuterBoundary::Kind::box, 5, 0}, 0.3);
  const SpacingField spacing = make_spacing_field(surface, {});
  const Leaves leaves = cut_into(root_subdomain(surface), spacing, 16);
  const double volume = enclosed_volume(surface.vertices, surface.triangles);
  EXPECT_EQ(leaves.count, 16);
  EXPECT_NEAR(leaves.volume, volume, 1e-12 * volume);
}

TEST(RealSurfaces, flange_is_cut_into_sixteen) {
  expect_sixteen_leaves("flange/flange.stl", false);
}
TEST(RealSurfaces, pipe_is_cut_into_sixteen) { expect_sixteen_leaves("pipe/pipe.stl", false); }
TEST(RealSurfaces, almond_in_a_box_is_cut_into_sixteen) {
  expect_sixteen_leaves("nasa_almond_in_box/nasa_almond_in_box.msh", false);
}
TEST(RealSurfaces, wing_with_sharp_trailing_edge_is_cut_into_sixteen) {
  expect_sixteen_leaves("onera_m6_sharp_te/onera_m6_sharp_te.msh.gz", false);
}
TEST(RealSurfaces, aircraft_with_a_duct_is_cut_into_sixteen) {
  expect_sixteen_leaves("prime_open_duct/prime_open_duct.msh.gz", true);
}

}  // namespace
}  // namespace tetfarm
