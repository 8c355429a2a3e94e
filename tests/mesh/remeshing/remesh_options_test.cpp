#include "mesh/remeshing/remesh_options.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(RemeshOptions, left_out_follow_from_the_size_of_the_surface) {
  const SurfaceMesh box = shapes::box({0, 0, 0}, {3, 4, 12}, 1);
  const RemeshOptions options = with_defaults({}, box);
  EXPECT_DOUBLE_EQ(options.size, 13.0 / 20);
  EXPECT_DOUBLE_EQ(options.min_size, 13.0 / 20 / 16);
  EXPECT_DOUBLE_EQ(options.tolerance, 0.013);
  RemeshOptions sized;
  sized.size = 8;
  EXPECT_DOUBLE_EQ(with_defaults(sized, box).min_size, 0.5);
}

TEST(RemeshOptions, that_cannot_be_meant_are_refused_by_name) {
  const auto refusal = [](const RemeshOptions& options) -> std::string {
    try {
      with_defaults(options, shapes::unit_cube());
    } catch (const UsageError& error) {
      return error.what();
    }
    return "none";
  };
  RemeshOptions options;
  options.size = -1;
  EXPECT_EQ(refusal(options), "--size: must be a length, and positive");
  options = {};
  options.size = 1;
  options.min_size = 2;
  EXPECT_EQ(refusal(options), "--min-size: is larger than --size");
  options = {};
  options.angle_deg = 180;
  EXPECT_EQ(refusal(options), "--angle: must lie between 0 and 180 degrees");
  options = {};
  options.growth = 0;
  EXPECT_EQ(refusal(options), "--growth: must be positive");
}

}  // namespace
}  // namespace tetfarm
