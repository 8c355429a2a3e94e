#include "mesh/planar/triangle_complex.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The unit square with its centre (node 4): four triangles.
TriangleComplex fan() {
  return make_triangle_complex({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}},
                               {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
}

TEST(TriangleComplex, finds_the_neighbours) {
  const TriangleComplex complex = fan();
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_EQ(complex.neighbour(0, 0), edge_handle(1, 1));
  EXPECT_EQ(complex.neighbour(0, 1), edge_handle(3, 0));
  EXPECT_EQ(complex.neighbour(0, 2), no_edge);
}

TEST(TriangleComplex, constrains_the_border_only) {
  const TriangleComplex complex = fan();
  for (std::int32_t t = 0; t < 4; ++t) {
    EXPECT_TRUE(complex.is_constrained(t, 2));
    EXPECT_FALSE(complex.is_constrained(t, 0));
    EXPECT_FALSE(complex.is_constrained(t, 1));
  }
}

TEST(TriangleComplex, finds_every_edge_from_its_left) {
  const TriangleComplex complex = fan();
  for (std::int32_t t = 0; t < 4; ++t)
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(complex.find_edge(complex.node(t, next(i)), complex.node(t, previous(i))),
                edge_handle(t, i));
}

TEST(TriangleComplex, finds_no_edge_where_there_is_none) {
  const TriangleComplex complex = fan();
  EXPECT_EQ(complex.find_edge(0, 2), no_edge);
  EXPECT_EQ(complex.find_edge(1, 0), no_edge);
}

TEST(TriangleComplex, flips_the_diagonal_and_keeps_the_sides) {
  TriangleComplex complex =
      make_triangle_complex({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
  complex.flip(complex.find_edge(0, 2));
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_EQ(complex.find_edge(0, 2), no_edge);
  EXPECT_NE(complex.find_edge(1, 3), no_edge);
  EXPECT_NE(complex.find_edge(3, 1), no_edge);
  for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, 3}, {3, 0}}) {
    const EdgeHandle side = complex.find_edge(a, b);
    ASSERT_NE(side, no_edge);
    EXPECT_TRUE(complex.is_constrained(triangle_of(side), edge_of(side)));
  }
}

TEST(TriangleComplex, constrains_both_sides_of_an_edge) {
  TriangleComplex complex = fan();
  complex.constrain(complex.find_edge(0, 4), true);
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_TRUE(complex.is_constrained(3, 0));
  complex.constrain(complex.find_edge(4, 0), false);
  EXPECT_FALSE(complex.is_constrained(0, 1));
}

TEST(TriangleComplex, reports_a_clockwise_triangle) {
  TriangleComplex complex = fan();
  complex.points[4] = {2, 0.5};
  EXPECT_THAT(validate(complex),
              ::testing::ElementsAre(HasSubstr("triangle 1: not anticlockwise")));
}

TEST(TriangleComplex, reports_a_flat_triangle) {
  TriangleComplex complex = fan();
  complex.points[4] = {1, 0.5};
  EXPECT_THAT(validate(complex),
              ::testing::ElementsAre(HasSubstr("triangle 1: not anticlockwise")));
}

TEST(TriangleComplex, reports_a_neighbour_that_does_not_point_back) {
  TriangleComplex complex = fan();
  complex.neighbours[0][0] = edge_handle(2, 0);
  EXPECT_THAT(validate(complex), ::testing::Contains(HasSubstr("does not point back")));
}

TEST(TriangleComplex, reports_sides_that_disagree_on_a_constraint) {
  TriangleComplex complex = fan();
  complex.constrained[0] |= 1;
  EXPECT_THAT(validate(complex), ::testing::Contains(HasSubstr("sides disagree")));
}

TEST(TriangleComplex, reports_a_border_that_is_not_constrained) {
  TriangleComplex complex = fan();
  complex.constrained[2] = 0;
  EXPECT_THAT(validate(complex), ::testing::Contains(HasSubstr("border edge")));
}

TEST(TriangleComplex, reports_a_node_that_is_not_in_its_triangle) {
  TriangleComplex complex = fan();
  complex.node2triangle[0] = 1;
  EXPECT_THAT(validate(complex), ::testing::ElementsAre(HasSubstr("node 0 is not in")));
}

}  // namespace
}  // namespace tetfarm
