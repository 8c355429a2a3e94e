#include "mesh/cosmetics/edge_removal.h"

#include <gmock/gmock.h>

#include "base/array_index.h"
#include "mesh/cosmetics/quality.h"
#include "tests/mesh/cosmetics/spindle.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm::cosmetics {
namespace {

using testing::IsEmpty;

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

/// The best that the ring's corners from `first` to `last` can be cut into, by every way to cut
/// them.
double best_cut(const WorkMesh& work, const EdgeRing& ring, std::size_t first, std::size_t last) {
  if (last - first < 2) return 1;
  double best = -1;
  for (std::size_t k = first + 1; k < last; ++k) {
    const std::int32_t a = ring.nodes[first], b = ring.nodes[k], c = ring.nodes[last];
    const double here = std::min(quality(work.complex, {a, b, c, ring.to}),
                                 quality(work.complex, {a, c, b, ring.from}));
    best = std::max(
        best, std::min({here, best_cut(work, ring, first, k), best_cut(work, ring, k, last)}));
  }
  return best;
}

TEST(EdgeRemoval, finds_the_best_of_all_ways_where_one_is_worth_it_and_nothing_elsewhere) {
  TetComplex complex = make_tet_complex(trial::random_ball(2, 150, 5));
  const WorkMesh work(complex, 162);
  int found = 0;
  int none = 0;
  for (std::int32_t t = 0; t < std::ssize(complex.nodes); t += 3) {
    for (const auto& [i, j] : {std::array{0, 1}, std::array{2, 3}, std::array{0, 3}}) {
      const auto ring = ring_of_edge(work, t, i, j, 8);
      if (!ring) continue;
      const double before = worst_of(work, ring->tets);
      const double best = best_cut(work, *ring, 0, ring->nodes.size() - 1);
      for (const double beat : {0.0, 0.5 * best, best + 1e-6}) {
        const auto removal = find_edge_removal(work, t, i, j, beat);
        const bool is_wanted = best > beat && is_worth(before, best);
        ASSERT_EQ(removal.has_value(), is_wanted);
        ++(is_wanted ? found : none);
        if (!removal) continue;
        EXPECT_NEAR(removal->new_worst, best, 1e-12);
        EXPECT_EQ(removal->old_worst, before);
        double worst = 1;
        for (const Tet& tet : removal->new_tets) worst = std::min(worst, quality(complex, tet));
        EXPECT_NEAR(worst, best, 1e-12);
      }
    }
  }
  EXPECT_GT(found, 50);
  EXPECT_GT(none, 50);
}

TEST(EdgeRemoval, is_nothing_round_more_than_ten_tets) {
  for (const int n : {10, 11}) {
    TetMesh mesh = spindle(n, 0.6);
    mesh.nodes[0].x = mesh.nodes[1].x = 0.93;
    TetComplex complex = make_tet_complex(mesh);
    const WorkMesh work(complex, n + 2);
    EXPECT_EQ(find_edge_removal(work, 0, 0, 1, 0).has_value(), n == 10);
  }
}

}  // namespace
}  // namespace tetfarm::cosmetics
