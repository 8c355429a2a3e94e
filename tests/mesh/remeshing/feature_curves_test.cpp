#include "mesh/remeshing/feature_curves.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using enum VertexKind;

TEST(FeatureCurves, corners_end_curves_and_vertices_on_them_do_not) {
  SurfaceFeatures features;
  features.kind = {corner, on_curve, on_curve, corner, smooth, corner};
  features.edges = {{0, 1}, {1, 2}, {2, 3}, {3, 5}};
  const FeatureCurves curves = feature_curves(features);
  EXPECT_EQ(curves.count, 2);
  EXPECT_THAT(curves.curve_of_edge, ElementsAre(0, 0, 0, 1));
  EXPECT_THAT(curves.curve_of_vertex, ElementsAre(-1, 0, 0, -1, -1, -1));
}

TEST(FeatureCurves, a_closed_curve_needs_no_corner) {
  SurfaceFeatures features;
  features.kind.assign(4, on_curve);
  features.edges = {{0, 1}, {0, 3}, {1, 2}, {2, 3}};
  const FeatureCurves curves = feature_curves(features);
  EXPECT_EQ(curves.count, 1);
  EXPECT_THAT(curves.curve_of_edge, ElementsAre(0, 0, 0, 0));
}

}  // namespace
}  // namespace tetfarm
