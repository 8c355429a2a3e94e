#include <gmock/gmock.h>

#include "base/array_index.h"
#include "mesh/cosmetics/edge_removal.h"
#include "mesh/cosmetics/face_swapping.h"
#include "mesh/cosmetics/quality.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;

/// Nodes 0 and 1 far apart on the z axis, n ring nodes round it: n tets on the edge 0-1.
TetMesh spindle(int n, double half_height) {
  TetMesh mesh;
  mesh.nodes = {{0, 0, -half_height}, {0, 0, half_height}};
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * i / n;
    mesh.nodes.push_back({std::cos(angle), std::sin(angle), 0});
    mesh.tets.push_back({0, 1, 2 + i, 2 + (i + 1) % n});
  }
  mesh.boundary_nodes = n + 2;
  return mesh;
}

double volume(const TetComplex& complex) {
  double sum = 0;
  for (const Tet& tet : complex.nodes) {
    if (tet[0] < 0) continue;
    sum += tet_volume(complex.points[at(tet[0])], complex.points[at(tet[1])],
                      complex.points[at(tet[2])], complex.points[at(tet[3])]);
  }
  return sum;
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

TEST(EdgeRemoval, replaces_n_needles_by_two_fans) {
  for (int n = 3; n <= 10; ++n) {
    TetComplex complex = make_tet_complex(spindle(n, n < 5 ? 0.3 : 0.6));
    WorkMesh work(complex, n + 2);
    const double before = volume(complex);
    const auto found = find_edge_removal(work, 1, 0, 1, 0);
    if (!found) continue;
    EXPECT_EQ(found->new_tets.size(), at(2 * (n - 2)));
    EXPECT_GT(found->new_worst, found->old_worst);
    EXPECT_EQ(replace_tets(work, *found).size(), found->new_tets.size());
    EXPECT_THAT(validate(complex), IsEmpty());
    EXPECT_NEAR(volume(complex), before, 1e-12);
  }
}

TEST(EdgeRemoval, swaps_three_needles_for_two_tets) {
  TetComplex complex = make_tet_complex(spindle(3, 1));
  WorkMesh work(complex, 5);
  const auto found = find_edge_removal(work, 0, 0, 1, 0);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(replace_tets(work, *found).size(), 2u);
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_EQ(complex.live_tets(), 2u);
}

TEST(EdgeRemoval, leaves_good_tets_alone) {
  TetComplex complex = make_tet_complex(spindle(5, 0.7));
  const WorkMesh work(complex, 7);
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      EXPECT_FALSE(find_edge_removal(work, 0, i, j, 0).has_value());
    }
  }
}

TEST(EdgeRemoval, edges_come_with_the_largest_angle_first) {
  for (std::uint64_t i = 0; i < 200; ++i) {
    TetMesh mesh;
    for (std::uint64_t k = 0; k < 4; ++k) mesh.nodes.push_back(trial::random_vector(3, 4 * i + k));
    mesh.tets = {{0, 1, 2, 3}};
    if (tet_volume(mesh.nodes[0], mesh.nodes[1], mesh.nodes[2], mesh.nodes[3]) < 0) {
      mesh.tets = {{1, 0, 2, 3}};
    }
    mesh.boundary_nodes = 4;
    TetComplex complex = make_tet_complex(mesh);
    const WorkMesh work(complex, 4);
    double last = -2;
    for (const auto& [p, q] : edges_by_angle(work, 0)) {
      // The cosine of the angle between the faces at the edge, from the two heights above it.
      const Tet& tet = work.tet(0);
      const Vec3 edge = normalized(work.point(tet[at(q)]) - work.point(tet[at(p)]));
      std::vector<Vec3> heights;
      for (int v = 0; v < 4; ++v) {
        if (v == p || v == q) continue;
        const Vec3 to = work.point(tet[at(v)]) - work.point(tet[at(p)]);
        heights.push_back(normalized(to - dot(to, edge) * edge));
      }
      const double cosine = dot(heights[0], heights[1]);
      EXPECT_GE(cosine, last - 1e-9);
      last = cosine;
    }
  }
}

TEST(FaceSwapping, replaces_two_fans_by_needles) {
  for (int n = 3; n <= 4; ++n) {
    const double half_height = 0.15;
    TetMesh mesh = spindle(n, half_height);
    mesh.tets.clear();
    for (int i = 1; i + 1 < n; ++i) {
      mesh.tets.push_back({2, 2 + i, 3 + i, 1});
      mesh.tets.push_back({2, 3 + i, 2 + i, 0});
    }
    TetComplex complex = make_tet_complex(mesh);
    ASSERT_THAT(validate(complex), IsEmpty());
    WorkMesh work(complex, n + 2);
    const auto found = find_face_removal(work, 0, 3, 0);
    ASSERT_TRUE(found.has_value()) << n;
    EXPECT_EQ(found->old_tets.size(), at(2 * (n - 2)));
    EXPECT_EQ(found->new_tets.size(), at(n));
    EXPECT_EQ(replace_tets(work, *found).size(), at(n));
    EXPECT_THAT(validate(complex), IsEmpty());
    EXPECT_EQ(complex.live_tets(), at(n));
  }
}

TEST(FaceSwapping, leaves_the_boundary_and_hollow_pairs_alone) {
  TetMesh mesh;
  // The segment between the apexes 3 and 4 passes outside the common face: no swap.
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}, {2, 2, -1}};
  mesh.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  TetComplex complex = make_tet_complex(mesh);
  ASSERT_THAT(validate(complex), IsEmpty());
  const WorkMesh work(complex, 5);
  for (int face = 0; face < 4; ++face) {
    EXPECT_FALSE(find_face_removal(work, 0, face, 0).has_value());
  }
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

}  // namespace
}  // namespace tetfarm::cosmetics
