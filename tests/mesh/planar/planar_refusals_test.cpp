// What is wrong with a region, word by word and with its places.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "mesh/planar/constrained_delaunay.h"
#include "tests/mesh/planar/regions.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string text_of(const std::optional<PlanarFailure>& failure) {
  if (!failure) return "none";
  std::ostringstream text;
  text << failure->reason;
  for (const Vec2& p : failure->where) text << " (" << p.x << ", " << p.y << ")";
  return text.str();
}

std::string refusal(const PlanarRegion& region, const PlanarOptions& options = {}, double h = 0.3) {
  const PlanarResult result = mesh_region(
      region, [h](const Vec2&) { return h; }, options);
  const std::string text = text_of(result.failure);
  if (result.failure) {
    EXPECT_TRUE(result.mesh.points.empty() && result.mesh.triangles.empty()) << text;
  }
  return text;
}

PlanarRegion square() { return planar_test::rectangle({0, 0}, {1, 1}, 1); }

TEST(PlanarRefusals, say_what_is_wrong_with_a_region_and_where) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal(square()), "none");
  EXPECT_EQ(refusal({}), "the region has no edges (0, 0)");
  PlanarRegion region = square();
  region.points[2].y = inf;
  region.points[1].x = -inf;
  EXPECT_EQ(refusal(region), "a coordinate is not finite (-inf, 0) (1, inf)");
  region = square();
  region.edges.push_back({1, 4});
  region.edges.push_back({-1, 2});
  EXPECT_EQ(refusal(region), "an edge names a point that does not exist (0, 0) (0, 0)");
  region = square();
  region.edges.push_back({2, 2});
  EXPECT_EQ(refusal(region), "an edge begins and ends at the same point (1, 1)");
  region = square();
  region.edges.pop_back();
  EXPECT_EQ(refusal(region), "a loop does not close (0, 0) (0, 1)");
  region = square();
  region.edges.insert(region.edges.end(), {{0, 2}, {2, 0}});
  EXPECT_EQ(refusal(region), "an edge is used twice (0, 0) (1, 1)");
  region = square();
  region.edges.insert(region.edges.end(), region.edges.begin(), region.edges.begin() + 4);
  EXPECT_EQ(refusal(region), "an edge is used twice (0, 0) (1, 0) (1, 1) (0, 1)");
}

TEST(PlanarRefusals, say_where_points_and_edges_meet) {
  PlanarRegion region = square();
  region.points.push_back({1, 0});
  EXPECT_EQ(refusal(region), "two points coincide (1, 0)");
  region = square();
  planar_test::add_loop(region, planar_test::rectangle_loop({0.25, -0.5}, {0.75, 0.5}, 1));
  EXPECT_EQ(refusal(region), "two edges cross (0.75, 0) (0.25, 0)");
  region = square();
  planar_test::add_loop(region, {{0.5, 0}, {0.75, 0.5}, {0.25, 0.5}});
  EXPECT_EQ(refusal(region), "a point lies on an edge (0.5, 0)");
}

TEST(PlanarRefusals, say_which_loops_do_not_agree) {
  PlanarRegion region = square();
  for (auto& [a, b] : region.edges) std::swap(a, b);
  EXPECT_EQ(refusal(region).substr(0, 33), "the outermost loop runs clockwise");
  region = square();
  planar_test::add_loop(region, planar_test::rectangle_loop({0.25, 0.25}, {0.75, 0.75}, 1));
  EXPECT_EQ(refusal(region).substr(0, 43), "loops disagree about which side is inside (");
}

TEST(PlanarRefusals, of_a_spacing_name_a_point_of_the_region) {
  EXPECT_EQ(refusal(square(), {}, 0), "the spacing is not positive and finite (0, 0)");
  EXPECT_EQ(refusal(square(), {}, -1), "the spacing is not positive and finite (0, 0)");
  EXPECT_EQ(refusal(square(), {}, HUGE_VAL), "the spacing is not positive and finite (0, 0)");
  const auto at_one_corner = [](const Vec2& p) { return p.x > 0.5 && p.y > 0.5 ? 0.0 : 0.3; };
  EXPECT_EQ(text_of(mesh_region(square(), at_one_corner).failure),
            "the spacing is not positive and finite (1, 1)");
  PlanarOptions options;
  options.max_triangles = 100;
  EXPECT_EQ(refusal(square(), options, 0.01), "the spacing asks for too many triangles (0, 0)");
  EXPECT_EQ(refusal(square(), options, 0.5), "none");
}

TEST(PlanarRefusals, name_a_hundred_places_at_most) {
  PlanarRegion region = planar_test::rectangle({0, 0}, {1, 1}, 60);
  region.edges.insert(region.edges.end(), region.edges.begin(), region.edges.begin() + 240);
  const ConstrainedDelaunay result = constrained_delaunay(region);
  ASSERT_TRUE(result.failure);
  EXPECT_EQ(result.failure->where.size(), 100U);
}

TriangleComplex two_triangles() {
  return make_triangle_complex({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}});
}

std::vector<std::string> complaints_of(void (*break_it)(TriangleComplex&)) {
  TriangleComplex complex = two_triangles();
  break_it(complex);
  return validate(complex);
}

TEST(TriangleComplexValidate, says_what_breaks_it_word_by_word) {
  EXPECT_THAT(complaints_of([](TriangleComplex&) {}), IsEmpty());
  EXPECT_THAT(complaints_of([](TriangleComplex& c) { c.triangles[1][2] = 4; }),
              testing::Contains("triangle 1: a node does not exist"));
  EXPECT_THAT(complaints_of([](TriangleComplex& c) {
                c.points[3] = {0.5, 0.5};
              }),
              ElementsAre("triangle 1: not anticlockwise"));
  EXPECT_THAT(complaints_of([](TriangleComplex& c) { c.constrained[0] = 0; }),
              ElementsAre("triangle 0: border edge is not constrained",
                          "triangle 0: border edge is not constrained"));
  EXPECT_THAT(complaints_of([](TriangleComplex& c) { c.neighbours[0][1] = edge_handle(2, 0); }),
              testing::Contains("triangle 0: neighbour does not exist"));
  EXPECT_THAT(complaints_of([](TriangleComplex& c) { c.neighbours[0][0] = edge_handle(1, 0); }),
              ElementsAre("triangle 0: neighbour does not point back"));
  EXPECT_THAT(complaints_of([](TriangleComplex& c) {
                c.neighbours[0][0] = edge_handle(1, 0);
                c.neighbours[1][0] = edge_handle(0, 0);
              }),
              ElementsAre("triangle 0: neighbour has another edge",
                          "triangle 1: neighbour has another edge"));
  EXPECT_THAT(complaints_of([](TriangleComplex& c) {
                c.constrained[0] = static_cast<std::uint8_t>(c.constrained[0] | 2);
              }),
              ElementsAre("triangle 0: sides disagree on a constrained edge",
                          "triangle 1: sides disagree on a constrained edge"));
  EXPECT_THAT(complaints_of([](TriangleComplex& c) { c.node2triangle[1] = 1; }),
              ElementsAre("triangle 1: node 1 is not in its triangle"));
  EXPECT_THAT(complaints_of([](TriangleComplex& c) { c.node2triangle[1] = -1; }), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
