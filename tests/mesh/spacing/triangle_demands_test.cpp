#include "mesh/spacing/triangle_demands.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "mesh/geometry/nearest_point.h"
#include "tests/support/error_text.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

constexpr double far_limit = std::numeric_limits<double>::infinity();

/// The triangles of a sphere, with `sizes` in turn.
std::vector<TriangleDemand> demands_on(const SurfaceMesh& surface,
                                       const std::vector<double>& sizes) {
  std::vector<TriangleDemand> demands;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const double size = sizes[t % sizes.size()];
    TriangleDemand& demand = demands.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      demand.corners[k] = surface.vertices[static_cast<std::size_t>(surface.triangles[t][k])];
    }
    demand.spacing = size;
    demand.growth = size > 0.02 ? 0.5 : 0.2;
  }
  return demands;
}

/// One after the other.
double asked_by_all(const std::vector<TriangleDemand>& demands, const Vec3& p, double radius) {
  double least = far_limit;
  for (const TriangleDemand& d : demands) {
    const double away =
        distance(nearest_on_triangle(p, d.corners[0], d.corners[1], d.corners[2]), p);
    const double beyond = std::max(0.0, away - radius - triangle_plateau * d.spacing);
    least = std::min(least, d.spacing + d.growth * beyond);
  }
  return least;
}

std::vector<Vec3> scattered_places(int count) {
  std::vector<Vec3> places = {{0, 0, 0}, {1, 0, 0}, {0, 0, -3}};
  std::uint64_t state = 7;
  const auto next = [&state] {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return 3 * (static_cast<double>(state >> 11U) / 9007199254740992.0) - 1.5;
  };
  while (count-- > 0) {
    const double x = next();
    const double y = next();
    places.push_back({x, y, next()});
  }
  return places;
}

TEST(TriangleDemands, are_the_least_of_all_triangles_to_the_last_bit) {
  for (const std::vector<double>& sizes :
       {std::vector<double>{0.05}, std::vector<double>{0.01, 0.3, 0.04}}) {
    const auto demands = demands_on(shapes::sphere({0, 0, 0}, 1, 3), sizes);
    const TriangleDemandTree tree(demands);
    for (const Vec3& p : scattered_places(300)) {
      for (const double radius : {0.0, 0.25}) {
        EXPECT_EQ(tree.lowest(p, radius, far_limit), asked_by_all(demands, p, radius)) << p.x;
      }
    }
  }
}

TEST(TriangleDemands, are_the_same_whatever_was_asked_before) {
  const auto demands = demands_on(shapes::sphere({0, 0, 0}, 1, 3), {0.01, 0.3, 0.04});
  const TriangleDemandTree there(demands);
  const TriangleDemandTree back(demands);
  std::vector<Vec3> places = scattered_places(100);
  std::vector<double> found;
  for (const Vec3& p : places) found.push_back(there.lowest(p, 0, far_limit));
  for (std::size_t i = places.size(); i-- > 0;) {
    EXPECT_EQ(back.lowest(places[i], 0, far_limit), found[i]) << i;
  }
}

TEST(TriangleDemands, within_a_ball_are_never_below_what_is_said_of_it) {
  const TriangleDemandTree tree(demands_on(shapes::sphere({0, 0, 0}, 1, 2), {0.03, 0.1}));
  for (const Vec3& centre : scattered_places(50)) {
    const double lowest = tree.lowest(centre, 0.2, far_limit);
    for (const Vec3& way : scattered_places(20)) {
      const Vec3 p = centre + (0.2 / std::max(1.0, norm(way))) * way;
      if (distance(p, centre) > 0.2) continue;
      EXPECT_GE(tree.lowest(p, 0, far_limit), (1 - 1e-12) * lowest);
    }
  }
}

TEST(TriangleDemands, are_no_more_than_the_limit_and_none_without_triangles) {
  const TriangleDemandTree tree(demands_on(shapes::unit_cube(), {0.1}));
  EXPECT_EQ(tree.lowest({0.5, 0.5, 1}, 0, 0.05), 0.05);
  EXPECT_EQ(tree.lowest({0.5, 0.5, 1}, 0, 0.2), 0.1);
  EXPECT_NEAR(tree.lowest({0.5, 0.5, 2}, 0, 10), 0.1 + 0.5 * (1 - 0.06), 1e-15);
  EXPECT_EQ(TriangleDemandTree().lowest({0, 0, 0}, 0, 0.2), 0.2);
  EXPECT_TRUE(TriangleDemandTree().empty());
  EXPECT_EQ(tree.size(), 12U);
}

TEST(TriangleDemands, near_a_few_of_many_look_at_these_alone) {
  const auto demands = demands_on(shapes::sphere({0, 0, 0}, 1, 5), {0.01});
  ASSERT_EQ(demands.size(), 20480U);
  const TriangleDemandTree tree(demands);
  std::uint64_t most = 0;
  for (Vec3 p : scattered_places(200)) {
    if (norm(p) < 0.5) continue;
    p *= 1.05 / norm(p);
    const std::uint64_t before = tree.looked_at();
    tree.lowest(p, 0, far_limit);
    most = std::max(most, tree.looked_at() - before);
  }
  EXPECT_GT(most, 10U);
  EXPECT_LT(most, 600U);
}

TEST(TriangleDemands, that_make_no_sense_are_refused) {
  const auto refusal = [](const TriangleDemand& demand) {
    return error_text_of<InvalidInput>([&] { check_triangle_demands({demand}); });
  };
  TriangleDemand demand{{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}}, 0.1, 0.3};
  check_triangle_demands({demand});
  demand.spacing = 0;
  EXPECT_THAT(refusal(demand), HasSubstr("the spacing at a patch is not positive"));
  demand.spacing = 0.1;
  demand.growth = -1;
  EXPECT_THAT(refusal(demand), HasSubstr("the growth at a patch is not positive"));
  demand.growth = 1;
  demand.corners[1].y = far_limit;
  EXPECT_THAT(refusal(demand), HasSubstr("a corner of a patch is not finite"));
}

/// A cube of edge 1 with edges of 0.01 wanted on the face z = 1.
SpacingOptions fine_on_top(double growth) {
  SpacingOptions options;
  options.background = 0.3;
  options.inherit_surface = false;
  for (const TriangleDemand& demand : demands_on(shapes::unit_cube(), {0.01})) {
    const bool is_top = std::all_of(demand.corners.begin(), demand.corners.end(),
                                    [](const Vec3& corner) { return corner.z == 1; });
    if (is_top) options.triangles.push_back({demand.corners, 0.01, growth});
  }
  return options;
}

TEST(SpacingFieldWithTriangles, has_their_spacing_at_them_and_grows_away_from_them) {
  const SpacingField field = make_spacing_field(shapes::unit_cube(), fine_on_top(0.3));
  for (const double x : {0.05, 0.33, 0.7}) {
    EXPECT_NEAR(field.at({x, 0.4, 1}), 0.01, 0.0015) << x;
    for (const double away : {0.05, 0.2, 0.6}) {
      const double asked = 0.01 + 0.3 * (away - 0.006);
      EXPECT_NEAR(field.at({x, 0.4, 1 - away}), asked, 0.12 * asked) << x << " " << away;
    }
  }
  EXPECT_LT(make_spacing_field(shapes::unit_cube(), fine_on_top(0.1)).at({0.5, 0.5, 0.5}), 0.07);
}

TEST(SpacingFieldWithTriangles, grows_no_faster_than_the_field) {
  const SpacingField slow = make_spacing_field(shapes::unit_cube(), fine_on_top(0.3));
  const SpacingField fast = make_spacing_field(shapes::unit_cube(), fine_on_top(20));
  EXPECT_EQ(fast.to_bytes(), slow.to_bytes());
}

TEST(SpacingFieldWithTriangles, is_the_one_without_where_they_ask_for_nothing_smaller) {
  SpacingOptions options = fine_on_top(0.3);
  const std::vector<TriangleDemand> triangles = options.triangles;
  options.triangles.clear();
  const std::string plain = make_spacing_field(shapes::unit_cube(), options).to_bytes();
  options.triangles = triangles;
  for (TriangleDemand& demand : options.triangles) demand.spacing = 0.3;
  EXPECT_EQ(make_spacing_field(shapes::unit_cube(), options).to_bytes(), plain);
}

}  // namespace
}  // namespace tetfarm
