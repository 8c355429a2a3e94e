#include "mesh/decompose/invalid_zones.h"

#include <gtest/gtest.h>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(InvalidZones, lie_at_the_ends_of_a_box_and_not_in_its_middle) {
  const Subdomain box = root_subdomain(shapes::box({0, 0, 0}, {1, 1, 1}, 10));
  const SurfaceTopology topology = make_surface_topology(box);
  const auto area = area_in_invalid_zones(box, topology, {0, 0, 1}, {0.05, 0.5, 0.96});
  EXPECT_NEAR(area[0], 1, 1e-12);
  EXPECT_EQ(area[1], 0);
  EXPECT_NEAR(area[2], 1, 1e-12);
}

TEST(InvalidZones, do_not_count_earlier_cuts) {
  Subdomain box = root_subdomain(shapes::box({0, 0, 0}, {1, 1, 1}, 10));
  for (Origin& origin : box.triangle_origin) origin.owner = 1;
  const auto area = area_in_invalid_zones(box, make_surface_topology(box), {0, 0, 1}, {0.05, 0.5});
  EXPECT_EQ(area, (std::vector<double>{0, 0}));
}

}  // namespace
}  // namespace tetfarm
