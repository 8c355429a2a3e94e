#include <gmock/gmock.h>

#include "mesh/decompose/planar_cut.h"
#include "mesh/inspect/surface_check.h"
#include "tests/support/generated_surfaces.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

/// The shells of both surfaces in one, as they are.
SurfaceMesh together(SurfaceMesh a, const SurfaceMesh& b) {
  const auto first = static_cast<std::int32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [i, j, k] : b.triangles) {
    a.triangles.push_back({first + i, first + j, first + k});
  }
  return a;
}

SurfaceMesh turned_inside_out(SurfaceMesh surface) {
  for (Triangle& t : surface.triangles) std::swap(t[1], t[2]);
  return surface;
}

double volume(const Subdomain& s) { return enclosed_volume(s.vertices, s.triangles); }

/// Nodes of the cut that the input surface gave it, at a distance from the centre.
int rim_nodes_at(const Subdomain& half, double radius) {
  std::vector<bool> is_on_cut(half.vertices.size(), false);
  for (std::size_t t = 0; t < half.triangles.size(); ++t) {
    if (half.triangle_origin[t].owner == 0) continue;
    for (const std::int32_t v : half.triangles[t]) is_on_cut[static_cast<std::size_t>(v)] = true;
  }
  int count = 0;
  for (std::size_t v = 0; v < half.vertices.size(); ++v) {
    const bool is_rim = is_on_cut[v] && half.node_origin[v].owner == 0;
    if (is_rim && std::abs(norm(half.vertices[v]) - radius) < 1e-9) ++count;
  }
  return count;
}

class NestedLoops : public testing::TestWithParam<CutPlanes> {};

// Box, hole in it, ball in the hole, hole in the ball: four loops, each within the one before.
TEST_P(NestedLoops, four_deep_bound_one_cut) {
  SurfaceMesh surface = shapes::box({-1, -1, -1}, {1, 1, 1}, 12);
  surface = together(surface, turned_inside_out(shapes::sphere({0, 0, 0}, 0.8, 3)));
  surface = together(surface, shapes::sphere({0, 0, 0}, 0.6, 3));
  surface = together(surface, turned_inside_out(shapes::sphere({0, 0, 0}, 0.3, 2)));
  const Subdomain root = root_subdomain(surface);
  CutOptions options;
  options.planes = GetParam();
  const CutOutcome outcome = planar_cut(root, SpacingField(0.12), options);
  ASSERT_TRUE(outcome.cut) << outcome.reason;
  for (const Subdomain* half : {&outcome.cut->left, &outcome.cut->right}) {
    EXPECT_THAT(validate(*half), IsEmpty());
    EXPECT_NEAR(volume(*half), volume(root) / 2, 0.1 * volume(root));
    for (const double radius : {0.8, 0.6, 0.3}) EXPECT_GE(rim_nodes_at(*half, radius), 8) << radius;
  }
  EXPECT_NEAR(volume(outcome.cut->left) + volume(outcome.cut->right), volume(root),
              1e-12 * volume(root));
}

TEST_P(NestedLoops, beside_each_other_bound_one_cut) {
  SurfaceMesh surface = shapes::box({-2, -1, -1}, {2, 1, 1}, 16);
  for (const double x : {-1.2, 0.0, 1.2}) {
    surface = together(surface, turned_inside_out(shapes::sphere({x, 0.05, 0}, 0.45, 2)));
  }
  const Subdomain root = root_subdomain(surface);
  CutOptions options;
  options.planes = GetParam();
  const CutOutcome outcome = planar_cut(root, SpacingField(0.18), options);
  ASSERT_TRUE(outcome.cut) << outcome.reason;
  EXPECT_THAT(validate(outcome.cut->left), IsEmpty());
  EXPECT_THAT(validate(outcome.cut->right), IsEmpty());
  EXPECT_NEAR(volume(outcome.cut->left) + volume(outcome.cut->right), volume(root),
              1e-12 * volume(root));
}

/// Nearly coplanar, so that a plane between them may touch neither.
TEST(FlatShells, a_cavity_stays_with_the_body_round_it) {
  const auto generators = shapes::surface_generators();
  const shapes::SurfaceGenerator& near_shells = *std::find_if(
      generators.begin(), generators.end(),
      [](const shapes::SurfaceGenerator& g) { return std::string(g.name) == "near_shells"; });
  int cuts = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const CheckedSurface checked =
        check_surface(shapes::moved_by_chance(near_shells.make(seed, 1), seed));
    if (!checked.report.defects.empty()) continue;
    const Subdomain root = root_subdomain(checked.surface);
    const SpacingField spacing(0.1 * norm(bounding_box(root.vertices).size()));
    const CutOutcome first = planar_cut(root, spacing);
    if (!first.cut) continue;
    for (const Subdomain* half : {&first.cut->left, &first.cut->right}) {
      const CutOutcome second = planar_cut(*half, spacing);
      if (!second.cut) continue;
      ++cuts;
      EXPECT_GT(volume(second.cut->left), 0) << seed;
      EXPECT_GT(volume(second.cut->right), 0) << seed;
    }
  }
  EXPECT_GT(cuts, 10);
}

std::string name_of_planes(const testing::TestParamInfo<CutPlanes>& info) {
  switch (info.param) {
    case CutPlanes::lattice:
      return "lattice";
    case CutPlanes::axis:
      return "axis";
    case CutPlanes::inertia:
      return "inertia";
    case CutPlanes::automatic:
      break;
  }
  return "automatic";
}

INSTANTIATE_TEST_SUITE_P(OfAllKinds, NestedLoops,
                         testing::Values(CutPlanes::automatic, CutPlanes::lattice, CutPlanes::axis,
                                         CutPlanes::inertia),
                         name_of_planes);

}  // namespace
}  // namespace tetfarm
