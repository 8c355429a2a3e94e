#include "mesh/decompose/planar_cut.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

double volume(const Subdomain& s) { return enclosed_volume(s.vertices, s.triangles); }

void expect_sound(const Subdomain& parent, const Cut& cut) {
  EXPECT_THAT(validate(cut.left), IsEmpty());
  EXPECT_THAT(validate(cut.right), IsEmpty());
  EXPECT_NEAR(volume(cut.left) + volume(cut.right), volume(parent), 1e-12 * volume(parent));
  EXPECT_GT(volume(cut.left), 0);
  EXPECT_GT(volume(cut.right), 0);
}

TEST(PlanarCut, halves_a_structured_box) {
  const Subdomain box = root_subdomain(shapes::box({0, 0, 0}, {2, 1, 1}, 8));
  const CutOutcome outcome = planar_cut(box, SpacingField(0.15));
  ASSERT_TRUE(outcome.cut) << outcome.reason;
  expect_sound(box, *outcome.cut);
}

TEST(PlanarCut, halves_spheres) {
  for (const Subdomain& shape :
       {root_subdomain(shapes::sphere({0, 0, 0}, 1, 3)), root_subdomain(shapes::nested_spheres(3)),
        root_subdomain(shapes::torus(0.4, 48, 20))}) {
    const CutOutcome outcome = planar_cut(shape, SpacingField(0.12));
    ASSERT_TRUE(outcome.cut) << outcome.reason;
    expect_sound(shape, *outcome.cut);
    EXPECT_GE(outcome.cut->smallest_angle_deg, 40);
  }
}

}  // namespace
}  // namespace tetfarm
