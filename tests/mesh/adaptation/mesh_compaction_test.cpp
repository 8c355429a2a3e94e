#include "mesh/adaptation/mesh_compaction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "mesh/adaptation/edge_collapse.h"
#include "mesh/adaptation/edge_refinement.h"
#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

/// With nodes that have gone, triangles that are unused, and some that came.
MetricMesh worn_mesh(const PlaneMesh& plane, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> size(0.05, 0.3);
  const double fine = size(random);
  const double coarse = size(random);
  const auto metrics = plane_test::metrics_of(plane, [&](const Vec2& p) {
    return plane_test::round_metric(p.x < 0.5 ? fine : 4 * coarse);
  });
  MetricMesh mesh = plane_test::metric_mesh(plane, metrics);
  const MetricField field = plane_test::field_of(plane, metrics);
  EllipseCavity cavity;
  collapse_edges(mesh, {}, EdgesToVisit::all);
  refine_edges(mesh, field, cavity, {}, EdgesToVisit::all);
  for (std::int32_t t = 0; t < mesh.complex.size(); t += 2) {
    if (mesh.is_used(t)) known_energy(mesh, t);
  }
  return mesh;
}

/// The mean diagonal of the boxes of 32 nodes that follow each other.
double mean_spread(const MetricMesh& mesh) {
  double sum = 0;
  int boxes = 0;
  for (std::int32_t first = 0; first + 32 <= mesh.nodes(); first += 32, ++boxes) {
    Vec2 low = mesh.complex.point(first);
    Vec2 high = low;
    for (std::int32_t v = first; v < first + 32; ++v) {
      const Vec2& p = mesh.complex.point(v);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    sum += std::hypot(high.x - low.x, high.y - low.y);
  }
  return sum / boxes;
}

using PatchedEdge = std::array<std::int32_t, 3>;

/// Edges with their patches; which way one inside is written follows from the numbers.
std::vector<PatchedEdge> patched_edges(const PlaneMesh& mesh) {
  std::vector<PatchedEdge> edges;
  for (std::size_t k = 0; k < mesh.edges.size(); ++k) {
    const auto [a, b] = mesh.edges[k];
    edges.push_back({std::min(a, b), std::max(a, b), mesh.patches[k]});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

TEST(MeshCompaction, leaves_the_mesh_and_takes_out_what_is_not_in_use) {
  for (const PlaneMesh& plane :
       {plane_test::square(12), plane_test::disc(9), plane_test::two_regions(10)}) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      MetricMesh mesh = worn_mesh(plane, seed);
      const MeshWithMetrics before = plane_mesh_of(mesh);
      const auto known_before = std::count_if(mesh.energies.begin(), mesh.energies.end(),
                                              [](float energy) { return energy >= 0; });
      compact(mesh);
      ASSERT_THAT(validate(mesh), IsEmpty());
      EXPECT_THAT(mesh.unused, IsEmpty());
      EXPECT_EQ(at(mesh.nodes()), before.mesh.points.size());
      EXPECT_EQ(mesh.complex.triangles.size(), before.mesh.triangles.size());
      EXPECT_GE(known_before, std::count_if(mesh.energies.begin(), mesh.energies.end(),
                                            [](float energy) { return energy >= 0; }));
      EXPECT_EQ(
          std::count(mesh.complex.node2triangle.begin(), mesh.complex.node2triangle.end(), -1), 0);
      const MeshWithMetrics after = plane_mesh_of(mesh);
      EXPECT_EQ(after.mesh.points.size(), before.mesh.points.size());
      EXPECT_EQ(plane_test::region_areas(after.mesh), plane_test::region_areas(before.mesh));
      EXPECT_EQ(after.mesh.points, before.mesh.points);
      EXPECT_EQ(after.metrics, before.metrics);
      EXPECT_EQ(after.mesh.triangles, before.mesh.triangles);
      EXPECT_EQ(patched_edges(after.mesh), patched_edges(before.mesh));
      EXPECT_EQ(after.mesh.corners, before.mesh.corners);
    }
  }
}

TEST(MeshCompaction, puts_nodes_in_memory_as_they_lie_in_the_plane) {
  MetricMesh mesh = plane_test::metric_mesh(
      plane_test::square(32),
      plane_test::constant_metrics(plane_test::square(32), plane_test::round_metric(1)));
  EXPECT_GT(mean_spread(mesh), 0.9);
  compact(mesh);
  EXPECT_LT(mean_spread(mesh), 0.4);
}

TEST(MeshCompaction, of_a_compact_mesh_changes_nothing) {
  MetricMesh mesh = worn_mesh(plane_test::square(12), 3);
  compact(mesh);
  const MetricMesh once = mesh;
  compact(mesh);
  EXPECT_EQ(mesh.complex.points, once.complex.points);
  EXPECT_EQ(mesh.complex.triangles, once.complex.triangles);
  EXPECT_EQ(mesh.complex.neighbours, once.complex.neighbours);
  EXPECT_EQ(mesh.energies, once.energies);
  EXPECT_EQ(mesh.curve_of_edge, once.curve_of_edge);
}

}  // namespace
}  // namespace tetfarm
