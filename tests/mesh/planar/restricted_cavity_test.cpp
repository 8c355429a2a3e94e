#include "mesh/planar/restricted_cavity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

/// Two triangles: the unit square with the diagonal 0-2.
TriangleComplex square() {
  return make_triangle_complex({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
}

TEST(RestrictedCavity, locates_the_triangle_that_holds_a_point) {
  const TriangleComplex complex = square();
  EXPECT_EQ(locate(complex, 0, {0.2, 0.7}), 1);
  EXPECT_EQ(locate(complex, 1, {0.7, 0.2}), 0);
}

TEST(RestrictedCavity, stops_at_the_border_and_at_constrained_edges) {
  TriangleComplex complex = square();
  EXPECT_EQ(locate(complex, 0, {2, 0.5}), std::nullopt);
  complex.constrain(complex.find_edge(0, 2), true);
  EXPECT_EQ(locate(complex, 0, {0.2, 0.7}), std::nullopt);
}

TEST(RestrictedCavity, fills_a_cavity_with_a_fan) {
  TriangleComplex complex = square();
  Cavity cavity;
  ASSERT_TRUE(find_cavity(complex, 0, {0.5, 0.5}, cavity));
  EXPECT_EQ(fill_cavity(complex, {0.5, 0.5}, cavity), 4);
  EXPECT_EQ(complex.size(), 4);
  EXPECT_THAT(validate(complex), IsEmpty());
}

TEST(RestrictedCavity, does_not_grow_across_a_constrained_edge) {
  TriangleComplex complex = square();
  complex.constrain(complex.find_edge(0, 2), true);
  Cavity cavity;
  ASSERT_TRUE(find_cavity(complex, 0, {0.6, 0.4}, cavity));
  fill_cavity(complex, {0.6, 0.4}, cavity);
  EXPECT_EQ(complex.size(), 4);
  EXPECT_THAT(validate(complex), IsEmpty());
  const EdgeHandle kept = complex.find_edge(0, 2);
  ASSERT_NE(kept, no_edge);
  EXPECT_TRUE(complex.is_constrained(triangle_of(kept), edge_of(kept)));
}

TEST(RestrictedCavity, refuses_a_point_that_is_a_node) {
  const TriangleComplex complex = square();
  Cavity cavity;
  EXPECT_FALSE(find_cavity(complex, 0, {1, 0}, cavity));
}

TEST(RestrictedCavity, refuses_a_point_on_a_constrained_edge) {
  const TriangleComplex complex = square();
  Cavity cavity;
  EXPECT_FALSE(find_cavity(complex, 0, {0.5, 0}, cavity));
}

}  // namespace
}  // namespace tetfarm
