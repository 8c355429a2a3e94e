#include "mesh/remeshing/local_tolerance.h"

#include <gmock/gmock.h>

#include "mesh/inspect/surface_check.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::Each;
using ::testing::Ge;
using ::testing::Le;

/// A small box in a large ball.
SurfaceMesh body_in_far_field() {
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 100, 2);
  const SurfaceMesh body = shapes::box({-1, -1, -1}, {1, 1, 1}, 2);
  return check_surface(shapes::between(ball, body)).surface;
}

TEST(LocalTolerance, of_a_face_is_no_more_than_two_thousandths_of_it) {
  const SurfaceMesh surface = body_in_far_field();
  const SurfaceFeatures features = surface_features(surface, 30);
  const RemeshOptions options = with_defaults({}, surface);
  const std::vector<double> shares = shares_of_tolerance(surface, features, options);
  ASSERT_EQ(shares.size(), surface.triangles.size());
  std::size_t of_body = 0;
  for (std::size_t t = 0; t < shares.size(); ++t) {
    const Vec3& corner = surface.vertices[static_cast<std::size_t>(surface.triangles[t][0])];
    if (norm(corner) > 50) {
      EXPECT_EQ(shares[t], 1);
    } else {
      EXPECT_NEAR(shares[t] * options.tolerance, 2e-3 * std::sqrt(8), 1e-12);
      ++of_body;
    }
  }
  EXPECT_EQ(of_body, 48U);
}

TEST(LocalTolerance, that_was_asked_for_is_the_same_everywhere) {
  const SurfaceMesh surface = body_in_far_field();
  RemeshOptions options;
  options.tolerance = 0.25;
  options = with_defaults(options, surface);
  EXPECT_EQ(options.tolerance, 0.25);
  EXPECT_THAT(shares_of_tolerance(surface, surface_features(surface, 30), options), Each(1));
}

TEST(LocalTolerance, is_some_everywhere_and_never_more_than_all) {
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 2);
  const SurfaceFeatures features = surface_features(ball, 30);
  const std::vector<double> shares = face_shares(ball, features, 1e-9);
  EXPECT_THAT(shares, Each(1));
  EXPECT_THAT(face_shares(ball, features, 1e9), Each(Ge(1e-12)));
  EXPECT_THAT(face_shares(ball, features, 1e9), Each(Le(1e-6)));
}

}  // namespace
}  // namespace tetfarm
