#include "mesh/remeshing/changing_surface.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <tuple>

#include "mesh/remeshing/edge_collapse.h"
#include "mesh/remeshing/edge_split.h"
#include "tests/mesh/remeshing/remeshing_fixture.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

using Corners = std::array<Vec3, 3>;

/// By its corners, the first of them first, in whichever way it is numbered.
std::vector<std::pair<Corners, int>> listing(const ChangingSurface& surface) {
  const auto is_less = [](const Vec3& a, const Vec3& b) {
    return std::tuple(a.x, a.y, a.z) < std::tuple(b.x, b.y, b.z);
  };
  std::vector<std::pair<Corners, int>> all;
  for (std::int32_t t = 0; t < surface.triangle_end(); ++t) {
    if (!surface.is_there(t)) continue;
    Corners c = surface.points(surface.triangle(t).nodes);
    std::rotate(c.begin(), std::ranges::min_element(c, is_less), c.end());
    all.emplace_back(c, surface.triangle(t).face);
  }
  std::ranges::sort(all, [&](const auto& a, const auto& b) {
    return std::ranges::lexicographical_compare(a.first, b.first, is_less);
  });
  return all;
}

TEST(ChangingSurface, numbered_by_place_is_the_same_surface_without_gaps) {
  SurfaceToChange ball(shapes::sphere({0, 0, 0}, 1, 3), 0.2, 0.1);
  for (std::int32_t v = 0; v < 40; ++v) {
    if (ball.surface.ring(v).empty()) continue;
    const Triangle nodes = ball.surface.triangle(ball.surface.ring(v).front()).nodes;
    if (v < 10) split_edge(ball.work, nodes[0], nodes[1]);
    collapse_edge(ball.work, nodes[1], nodes[2], 10, 0.1);
  }
  const auto before = listing(ball.surface);
  ASSERT_LT(before.size(), static_cast<std::size_t>(ball.surface.triangle_end()));
  const double volume = volume_of(ball.surface);
  ball.surface.number_by_place();
  EXPECT_EQ(listing(ball.surface), before);
  EXPECT_EQ(ball.surface.triangle_count(), std::int64_t(before.size()));
  EXPECT_EQ(ball.surface.triangle_end(), std::int32_t(before.size()));
  EXPECT_NEAR(volume_of(ball.surface), volume, 1e-12);
  EXPECT_THAT(complaints_of(ball.surface), IsEmpty());
}

TEST(ChangingSurface, numbered_by_place_has_neighbours_near_in_numbers) {
  SurfaceToChange ball(shapes::sphere({0, 0, 0}, 1, 5), 0.2, 0.1);
  const auto mean_step = [&] {
    double sum = 0;
    for (std::int32_t t = 0; t < ball.surface.triangle_end(); ++t) {
      const Triangle& nodes = ball.surface.triangle(t).nodes;
      sum += std::abs(nodes[0] - nodes[1]);
    }
    return sum / ball.surface.triangle_end();
  };
  const double before = mean_step();
  ball.surface.number_by_place();
  EXPECT_LT(mean_step(), before / 3);
}

}  // namespace
}  // namespace tetfarm
