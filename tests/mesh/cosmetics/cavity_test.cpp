#include "mesh/cosmetics/cavity.h"

#include <gmock/gmock.h>

#include "tests/mesh/cosmetics/spindle.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

TEST(BallOfNode, is_all_tets_that_hold_the_node) {
  TetComplex complex = make_tet_complex(trial::kuhn_box(3));
  WorkMesh work(complex, 56);
  for (std::int32_t v = 0; v < 64; ++v) {
    const std::vector<std::int32_t> ball = ball_of_node(work, v);
    std::size_t holders = 0;
    for (std::int32_t t = 0; t < 162; ++t) holders += complex.local_node(t, v) >= 0;
    EXPECT_EQ(ball.size(), holders);
    for (const std::int32_t t : ball) EXPECT_GE(complex.local_node(t, v), 0);
  }
}

TEST(EdgeRing, goes_round_an_inner_edge_in_order) {
  TetComplex complex = make_tet_complex(spindle(7, 1));
  const WorkMesh work(complex, 9);
  for (std::int32_t t = 0; t < 7; ++t) {
    for (const bool turned : {false, true}) {
      const auto ring = ring_of_edge(work, t, turned ? 1 : 0, turned ? 0 : 1, 8);
      ASSERT_TRUE(ring.has_value());
      ASSERT_EQ(ring->tets.size(), 7u);
      EXPECT_EQ(ring->from, turned ? 1 : 0);
      for (std::size_t i = 0; i < 7; ++i) {
        const Tet tet = {ring->from, ring->to, ring->nodes[i], ring->nodes[(i + 1) % 7]};
        EXPECT_TRUE(is_positive(complex, tet));
        for (const std::int32_t v : tet) EXPECT_GE(complex.local_node(ring->tets[i], v), 0);
      }
    }
  }
}

TEST(EdgeRing, is_nothing_on_the_boundary_or_beyond_the_limit) {
  TetComplex complex = make_tet_complex(spindle(7, 1));
  const WorkMesh work(complex, 9);
  EXPECT_FALSE(ring_of_edge(work, 0, 0, 2, 8).has_value());
  EXPECT_FALSE(ring_of_edge(work, 0, 2, 3, 8).has_value());
  EXPECT_FALSE(ring_of_edge(work, 0, 0, 1, 6).has_value());
}

TEST(ReplaceTets, refuses_other_outer_faces_and_changes_nothing) {
  TetComplex complex = make_tet_complex(trial::kuhn_box(2));
  const TetComplex before = complex;
  WorkMesh work(complex, 26);
  EXPECT_THAT(replace_tets(work, {{0, 1}, {work.tet(0)}, 0, 0, std::nullopt}), IsEmpty());
  EXPECT_THAT(replace_tets(work, {{0}, {work.tet(0), work.tet(0)}, 0, 0, std::nullopt}), IsEmpty());
  EXPECT_EQ(complex.nodes, before.nodes);
  EXPECT_EQ(complex.neighbours, before.neighbours);
}

TEST(ReplaceTets, refuses_flat_tets) {
  // Four coplanar ring nodes: both diagonals give flat pairs with an apex in their plane.
  TetMesh mesh = spindle(4, 1);
  mesh.nodes[1].z = 0;
  mesh.nodes[1].x = 0.1;
  TetComplex complex = make_tet_complex(mesh);
  WorkMesh work(complex, 6);
  const Replacement flat{
      {0, 1, 2, 3}, {{2, 3, 4, 1}, {2, 4, 3, 0}, {2, 4, 5, 1}, {2, 5, 4, 0}}, 0, 0, std::nullopt};
  EXPECT_THAT(replace_tets(work, flat), IsEmpty());
}

TEST(IsInner, of_nodes_that_are_free_and_on_no_boundary_face) {
  TetComplex complex = make_tet_complex(trial::kuhn_box(3));
  WorkMesh work(complex, 57);  // one of the eight inner nodes is fixed
  WorkMesh free(complex, 0);
  for (std::int32_t v = 0; v < 64; ++v) {
    EXPECT_EQ(is_inner(work, ball_of_node(work, v), v), v >= 57);
    EXPECT_EQ(is_inner(free, ball_of_node(free, v), v), v >= 56);
  }
}

/// The four tets from a new point to the faces of tet 0.
Replacement split_of_first_tet(const TetComplex& complex, const Vec3& point) {
  const auto node = static_cast<std::int32_t>(complex.points.size());
  Replacement split{{0}, {}, 0, 0, point};
  for (std::size_t i = 0; i < 4; ++i) {
    Tet part = complex.nodes[0];
    part[i] = node;
    split.new_tets.push_back(part);
  }
  return split;
}

Vec3 centroid_of_first_tet(const TetComplex& complex) {
  Vec3 sum;
  for (const std::int32_t v : complex.nodes[0]) sum += complex.points[at(v)];
  return 0.25 * sum;
}

TEST(ReplaceTets, brings_a_new_point_and_tells_which_nodes_saw_a_change) {
  TetComplex complex = make_tet_complex(trial::kuhn_box(2));
  WorkMesh work(complex, 26);
  const Tet old = work.tet(0);
  const double whole = volume(complex);
  const auto tets = replace_tets(work, split_of_first_tet(complex, centroid_of_first_tet(complex)));
  ASSERT_THAT(tets, SizeIs(4));
  ASSERT_THAT(complex.points, SizeIs(28));
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_NEAR(volume(complex), whole, 1e-13);
  EXPECT_EQ(work.changes, 1);
  for (std::int32_t v = 0; v < 27; ++v) {
    EXPECT_EQ(work.change_of(v), std::count(old.begin(), old.end(), v));
  }
  EXPECT_EQ(work.change_of(27), 1);
  for (std::int32_t t = 0; t < std::ssize(complex.nodes); ++t) {
    const Tet& tet = work.tet(t);
    const bool holds_one = std::any_of(tet.begin(), tet.end(), [&](std::int32_t v) {
      return v == 27 || std::count(old.begin(), old.end(), v) > 0;
    });
    EXPECT_EQ(work.is_untouched(t), !holds_one);
  }
}

TEST(ReplaceTets, takes_a_point_back_that_does_not_see_all_faces) {
  TetComplex complex = make_tet_complex(trial::kuhn_box(2));
  WorkMesh work(complex, 26);
  const TetComplex before = complex;
  const Vec3 beyond = centroid_of_first_tet(complex) + Vec3{3, 0, 0};
  EXPECT_THAT(replace_tets(work, split_of_first_tet(complex, beyond)), IsEmpty());
  EXPECT_EQ(complex.points, before.points);
  EXPECT_EQ(complex.nodes, before.nodes);
  EXPECT_EQ(complex.node2tet, before.node2tet);
  EXPECT_THAT(work.node2change, SizeIs(27));
  EXPECT_EQ(work.changes, 0);
}

TEST(WorkMesh, keeps_no_quality_of_tets_that_were_replaced) {
  TetComplex complex = make_tet_complex(trial::kuhn_box(2));
  WorkMesh work(complex, 26);
  for (std::int32_t t = 0; t < 48; ++t)
    EXPECT_EQ(work.quality_of(t), quality(complex, work.tet(t)));
  const auto tets = replace_tets(work, split_of_first_tet(complex, centroid_of_first_tet(complex)));
  double worst = 1;
  for (const std::int32_t t : tets) {
    EXPECT_EQ(work.quality_of(t), quality(complex, work.tet(t)));
    worst = std::min(worst, quality(complex, work.tet(t)));
  }
  EXPECT_EQ(worst_of(work, tets), worst);
  EXPECT_EQ(worst_of(work, {}), 1);
}

}  // namespace
}  // namespace tetfarm::cosmetics
