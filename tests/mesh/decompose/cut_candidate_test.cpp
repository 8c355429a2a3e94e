#include "mesh/decompose/cut_candidate.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/decompose/cut_check.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

struct Trial {
  Trial(const SurfaceMesh& surface, double h)
      : subdomain(root_subdomain(surface)),
        spacing(h),
        parent{subdomain, spacing, make_surface_topology(subdomain)} {}

  Subdomain subdomain;
  SpacingField spacing;
  Parent parent;
};

Candidate candidate_at(const CutPlane& plane) {
  Candidate candidate;
  candidate.place.plane = plane;
  return candidate;
}

Trial long_box() { return {shapes::box({0, 0, 0}, {1, 1, 2}, 8), 0.15}; }

TEST(CutCandidate, straight_across_a_box_passes_at_right_angles_with_a_checked_mesh) {
  const Trial trial = long_box();
  Candidate candidate = candidate_at(make_cut_plane({0, 0, 1}, 1));
  EXPECT_TRUE(passes(candidate, trial.parent, cosine_of_degrees(80)));
  EXPECT_EQ(candidate.stage, Stage::has_mesh);
  EXPECT_EQ(candidate.problem, "");
  EXPECT_EQ(candidate.loops.loops.size(), 1U);
  EXPECT_EQ(candidate.corners.size(), candidate.mesh.rim.size());
  EXPECT_LE(candidate.cosine, cosine_of_degrees(80));
  const std::vector<double> cosines =
      cosines_at_rim(candidate.mesh, trial.subdomain, candidate.corners);
  EXPECT_EQ(candidate.cosine, *std::max_element(cosines.begin(), cosines.end()));
  EXPECT_LE(cosine_of_smallest_triangle_angle(candidate.mesh, trial.subdomain),
            cosine_of_degrees(8));
}

TEST(CutCandidate, beside_the_subdomain_crosses_nothing_and_stays_refused) {
  const Trial trial = long_box();
  for (const double height : {-1.0, 3.0}) {
    Candidate candidate = candidate_at(make_cut_plane({0, 0, 1}, height));
    EXPECT_FALSE(passes(candidate, trial.parent, 1));
    EXPECT_EQ(candidate.stage, Stage::refused);
    EXPECT_EQ(candidate.problem, "no crossing");
    EXPECT_FALSE(passes(candidate, trial.parent, 1));
  }
}

TEST(CutCandidate, is_taken_no_farther_than_the_limit_asks_and_goes_on_from_there) {
  const Trial trial(shapes::sphere({0, 0, 0}, 1, 3), 0.15);
  Candidate candidate = candidate_at(make_cut_plane(normalized(Vec3{1, 2, 3}), 0.6));
  EXPECT_FALSE(passes(candidate, trial.parent, -0.99));
  EXPECT_EQ(candidate.stage, Stage::has_loops);
  EXPECT_TRUE(candidate.mesh.planar.triangles.empty());
  const double possible = candidate.cosine;
  EXPECT_FALSE(passes(candidate, trial.parent, possible - 1e-9));
  EXPECT_EQ(candidate.stage, Stage::has_loops);
  EXPECT_TRUE(passes(candidate, trial.parent, cosine_of_degrees(20)));
  EXPECT_EQ(candidate.stage, Stage::has_mesh);
  EXPECT_GE(candidate.cosine, possible - 1e-9) << "no better than what the bisector allows";
  Candidate at_once = candidate_at(candidate.place.plane);
  EXPECT_TRUE(passes(at_once, trial.parent, cosine_of_degrees(20)));
  EXPECT_EQ(at_once.mesh.heights, candidate.mesh.heights);
}

TEST(CutCandidate, that_is_refused_keeps_nothing_but_its_plane_and_the_reason) {
  const Trial trial = long_box();
  Candidate candidate = candidate_at(make_cut_plane({0, 0, 1}, 1));
  candidate.place.penalty = 3;
  ASSERT_TRUE(passes(candidate, trial.parent, 0.5));
  refuse(candidate, "too late");
  EXPECT_EQ(candidate.stage, Stage::refused);
  EXPECT_EQ(candidate.problem, "too late");
  EXPECT_EQ(candidate.place.penalty, 3);
  EXPECT_EQ(candidate.place.plane.offset, 1);
  EXPECT_TRUE(candidate.colours.empty());
  EXPECT_TRUE(candidate.loops.loops.empty());
  EXPECT_TRUE(candidate.mesh.planar.points.empty());
  EXPECT_EQ(candidate.cosine, -1);
}

}  // namespace
}  // namespace tetfarm
