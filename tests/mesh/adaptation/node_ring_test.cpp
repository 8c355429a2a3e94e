#include "mesh/adaptation/node_ring.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/mesh/adaptation/plane_shapes.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

MetricMesh varying_mesh(const PlaneMesh& plane) {
  return plane_test::metric_mesh(plane, plane_test::metrics_of(plane, [](const Vec2& p) {
                                   return metric_of_sizes({0.2 + 0.1 * p.x, 0.1, 0.3 * p.y});
                                 }));
}

TEST(NodeRing, has_the_triangles_of_the_ball_and_the_nodes_opposite_in_their_order) {
  const MetricMesh mesh = varying_mesh(plane_test::square(4));
  NodeRing ring;
  Ball ball;
  for (std::int32_t v = 0; v < mesh.nodes(); ++v) {
    ring.gather(mesh, v);
    collect_ball(mesh.complex, v, ball);
    ASSERT_EQ(at(ring.triangles()), ball.corners.size());
    ASSERT_EQ(ring.places().size(), ball.corners.size() + 1);
    for (std::int32_t k = 0; k < ring.triangles(); ++k) {
      EXPECT_EQ(ring.triangle(k), triangle_of(ball.corners[at(k)]));
      const OppositeEdge edge = opposite_edge(mesh.complex, ball.corners[at(k)]);
      EXPECT_EQ(ring.places()[at(k)].node, edge.before);
      EXPECT_EQ(ring.places()[at(k) + 1].node, edge.after);
      EXPECT_EQ(ring.places()[at(k)].point, mesh.complex.point(edge.before));
      EXPECT_EQ(ring.places()[at(k)].metric, mesh.metrics[at(edge.before)]);
    }
  }
}

TEST(NodeRing, energies_are_those_of_the_triangles_once_the_node_is_there) {
  const PlaneMesh plane = plane_test::square(5);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(-0.15, 0.15);
  NodeRing ring;
  for (int i = 0; i < 200; ++i) {
    MetricMesh mesh = varying_mesh(plane);
    const auto node = static_cast<std::int32_t>(random() % at(mesh.nodes()));
    if (!mesh.is_inside(node)) continue;
    ring.gather(mesh, node);
    NodePlace place = place_of(mesh, node);
    EXPECT_NEAR(ring.energies_at(place).sum, ring.noted_sum(mesh), 1e-5 * ring.noted_sum(mesh));
    place.point = {place.point.x + share(random), place.point.y + share(random)};
    place.metric = {70, 3, 40};
    const RingEnergies energies = ring.energies_at(place);
    EXPECT_EQ(std::isfinite(energies.sum), ring.sees_all(mesh, place.point));
    EXPECT_EQ(energies.is_certain, ring.sees_all(mesh, place.point));
    if (!std::isfinite(energies.sum)) continue;
    move_node(mesh, node, place);
    ring.note(mesh);
    EXPECT_NEAR(energies.sum, ring.noted_sum(mesh), 1e-5 * energies.sum);
    EXPECT_THAT(validate(mesh), IsEmpty());
    EXPECT_NE(mesh.unchecked[at(ring.triangle(0))], 0);
    ring.activate(mesh);
    EXPECT_EQ(mesh.active[at(ring.places()[1].node)], 1);
    EXPECT_EQ(mesh.active[at(node)], 0);
  }
}

TEST(NodeRing, is_certain_of_no_triangle_that_is_flat_but_for_rounding) {
  MetricMesh mesh = varying_mesh(plane_test::square(3));
  NodeRing ring;
  ring.gather(mesh, 5);
  NodePlace place = place_of(mesh, 5);
  const Vec2& a = ring.places()[0].point;
  const Vec2& b = ring.places()[1].point;
  for (const double shift : {0.0, 1e-17, -1e-17}) {
    place.point = {(a.x + b.x) / 2 + shift, (a.y + b.y) / 2 - shift};
    EXPECT_FALSE(ring.energies_at(place).is_certain);
  }
}

}  // namespace
}  // namespace tetfarm
