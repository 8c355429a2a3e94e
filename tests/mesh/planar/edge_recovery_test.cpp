#include "mesh/planar/edge_recovery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A band of triangles between the rows y = 0 and y = 1, in a large square (nodes 0 to 3), all
/// found by no Delaunay rule: node 4 + 2i is (i, 0), node 5 + 2i is (i + 0.5, 1).
TriangleComplex band(int n) {
  std::vector<Vec2> points{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}};
  std::vector<TriangleComplex::Nodes> triangles;
  for (int i = 0; i < n; ++i) {
    points.push_back({static_cast<double>(i), 0});
    points.push_back({i + 0.5, 1});
  }
  const std::int32_t last = 3 + 2 * n;
  for (std::int32_t v = 4; v + 2 <= last; ++v) {
    const bool is_low = v % 2 == 0;
    triangles.push_back(is_low ? TriangleComplex::Nodes{v, v + 2, v + 1}
                               : TriangleComplex::Nodes{v, v + 1, v + 2});
    triangles.push_back(is_low ? TriangleComplex::Nodes{v + 2, v, 0}
                               : TriangleComplex::Nodes{v, v + 2, 2});
  }
  triangles.push_back({4, 5, 3});
  triangles.push_back({4, 3, 0});
  triangles.push_back({5, 2, 3});
  triangles.push_back({last, last - 1, 1});
  triangles.push_back({last - 1, 0, 1});
  triangles.push_back({last, 1, 2});
  return make_triangle_complex(points, triangles);
}

TEST(EdgeRecovery, starts_from_a_valid_band) { EXPECT_THAT(validate(band(6)), IsEmpty()); }

TEST(EdgeRecovery, constrains_an_edge_that_is_there) {
  TriangleComplex complex = band(4);
  EXPECT_FALSE(recover_edge(complex, 4, 5));
  const EdgeHandle edge = complex.find_edge(4, 5);
  EXPECT_TRUE(complex.is_constrained(triangle_of(edge), edge_of(edge)));
}

TEST(EdgeRecovery, makes_an_edge_across_the_whole_band) {
  TriangleComplex complex = band(20);
  const std::int32_t far = 5 + 2 * 19;
  ASSERT_EQ(complex.find_edge(4, far), no_edge);
  EXPECT_FALSE(recover_edge(complex, 4, far));
  const EdgeHandle edge = complex.find_edge(4, far);
  ASSERT_NE(edge, no_edge);
  EXPECT_TRUE(complex.is_constrained(triangle_of(edge), edge_of(edge)));
  EXPECT_THAT(validate(complex), IsEmpty());
}

TEST(EdgeRecovery, refuses_an_edge_through_a_node_next_to_its_start) {
  TriangleComplex complex = band(6);
  const auto failure = recover_edge(complex, 4, 8);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->reason, "a point lies on an edge");
  EXPECT_THAT(failure->where, ElementsAre(Vec2{1, 0}));
}

TEST(EdgeRecovery, makes_an_edge_away_from_a_node_on_its_line) {
  TriangleComplex given = band(6);
  given.points[8] = {2, -0.25};
  ASSERT_THAT(validate(given), IsEmpty());
  const auto triangles = static_cast<std::int32_t>(given.triangles.size());
  for (std::int32_t t = 0; t < triangles; ++t) {
    if (given.node(t, 0) != 6 && given.node(t, 1) != 6 && given.node(t, 2) != 6) continue;
    TriangleComplex complex = given;
    complex.node2triangle[6] = t;  // whichever is looked at first
    EXPECT_FALSE(recover_edge(complex, 6, 10)) << "node 4 lies behind the first end";
    EXPECT_NE(complex.find_edge(6, 10), no_edge);
    EXPECT_THAT(validate(complex), IsEmpty());
  }
}

TEST(EdgeRecovery, refuses_an_edge_through_a_node_farther_on) {
  TriangleComplex complex = band(6);
  complex.points[9] = {2.25, 0.75};  // on the line from (0, 0) to (4.5, 1.5): see below
  complex.points[13] = {4.5, 1.5};
  ASSERT_THAT(validate(complex), IsEmpty());
  const auto failure = recover_edge(complex, 4, 13);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->reason, "a point lies on an edge");
  EXPECT_THAT(failure->where, ElementsAre(Vec2{2.25, 0.75}));
}

TEST(EdgeRecovery, refuses_to_cross_a_constrained_edge_and_changes_nothing) {
  TriangleComplex complex = band(6);
  complex.constrain(complex.find_edge(8, 9), true);
  const auto before = complex.triangles;
  const auto failure = recover_edge(complex, 4, 15);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->reason, "two edges cross");
  EXPECT_EQ(complex.triangles, before);
}

}  // namespace
}  // namespace tetfarm
