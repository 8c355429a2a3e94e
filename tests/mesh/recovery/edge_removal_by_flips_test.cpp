#include "mesh/recovery/edge_removal_by_flips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "mesh/recovery/edge_recovery.h"
#include "tests/mesh/recovery/random_tets.h"

namespace tetfarm {
namespace {

constexpr std::int32_t points = 60;

/// Calls visit(a, b) for each edge between two points, as long as it is there.
template <class Visit>
void for_each_edge(const LocalRemeshing& mesh, const Visit& visit) {
  for (std::int32_t a = 0; a < points; ++a) {
    for (std::int32_t b = a + 1; b < points; ++b) {
      if (mesh.find_edge(a, b) >= 0) visit(a, b);
    }
  }
}

TEST(EdgeRemoval, in_the_way_of_nothing_takes_the_edge_out_or_leaves_all_as_it_was) {
  std::array<int, 2> removed{};
  for (const int depth : {0, 2}) {
    RandomTets tets(points, 9);
    const double volume = volume_of(tets.complex);
    const RecoverySurface no_surface({}, points);
    EdgeRemoval removal(tets.mesh, no_surface);
    const auto guard = RecoveryGuard::of_nothing(tets.mesh);
    int failed = 0;
    for_each_edge(tets.mesh, [&](std::int32_t a, std::int32_t b) {
      const TetComplex before = tets.complex;
      removal.set_budget(50);
      if (removal.remove(a, b, guard, depth)) {
        ++removed[depth > 0 ? 1 : 0];
        EXPECT_LT(tets.mesh.find_edge(a, b), 0);
        return;
      }
      ++failed;
      EXPECT_EQ(tets.complex.nodes, before.nodes);
      EXPECT_EQ(tets.complex.neighbours, before.neighbours);
      EXPECT_EQ(tets.complex.free_tets, before.free_tets);
    });
    EXPECT_GT(failed, 10);
    EXPECT_TRUE(validate(tets.complex).empty());
    EXPECT_NEAR(volume_of(tets.complex), volume, 1e-9 * volume);
  }
  EXPECT_GT(removed[0], 20);
  EXPECT_GT(removed[1], 20);
}

/// Of the inner edges those that are removed, each from the same tets.
int removed_edges(const TetComplex& tets, int depth) {
  int removed = 0;
  for (std::int32_t a = 0; a < 30; ++a) {
    for (std::int32_t b = a + 1; b < 30; ++b) {
      TetComplex complex = tets;
      std::vector<std::uint8_t> constrained(complex.nodes.size(), 0);
      LocalRemeshing mesh(complex, constrained);
      if (!mesh.ring(a, b)) continue;
      const RecoverySurface no_surface({}, 30);
      EdgeRemoval removal(mesh, no_surface);
      removal.set_budget(1'000);
      const bool is_gone = removal.remove(a, b, RecoveryGuard::of_nothing(mesh), depth);
      EXPECT_EQ(is_gone, mesh.find_edge(a, b) < 0);
      EXPECT_TRUE(validate(complex).empty());
      removed += is_gone ? 1 : 0;
    }
  }
  return removed;
}

TEST(EdgeRemoval, goes_into_what_hides_an_apex_as_deep_as_it_is_told_to) {
  int shallow = 0;
  int deep = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const TetComplex tets = RandomTets(30, seed).complex;
    shallow += removed_edges(tets, 0);
    deep += removed_edges(tets, 2);
  }
  EXPECT_GT(shallow, 100);
  EXPECT_GT(deep, shallow);
}

TEST(EdgeRemoval, without_a_budget_tries_nothing) {
  RandomTets tets(points, 9);
  const RecoverySurface no_surface({}, points);
  EdgeRemoval removal(tets.mesh, no_surface);
  const auto guard = RecoveryGuard::of_nothing(tets.mesh);
  removal.set_budget(0);
  for_each_edge(tets.mesh, [&](std::int32_t a, std::int32_t b) {
    EXPECT_FALSE(removal.remove(a, b, guard, 2));
  });
}

TEST(EdgeRemoval, leaves_edges_of_the_surface_and_edges_that_are_not_there_alone) {
  RandomTets tets(points, 9);
  std::vector<Triangle> triangles;
  for (const std::int32_t t : tets.mesh.star(5)) {
    const Tet& n = tets.complex.nodes[static_cast<std::size_t>(t)];
    if (*std::max_element(n.begin(), n.end()) < points) triangles.push_back({n[0], n[1], n[2]});
  }
  const RecoverySurface surface(triangles, points);
  EdgeRemoval removal(tets.mesh, surface);
  const auto guard = RecoveryGuard::of_nothing(tets.mesh);
  ASSERT_GT(surface.edges().size(), 10U);
  for (const auto& [a, b] : surface.edges()) {
    removal.set_budget(50);
    EXPECT_FALSE(removal.remove(a, b, guard, 2));
  }
  for (const auto& [a, b] : surface.edges()) EXPECT_GE(tets.mesh.find_edge(a, b), 0);
  for (std::int32_t b = 1; b < points; ++b) {
    if (tets.mesh.find_edge(0, b) >= 0) continue;
    EXPECT_FALSE(removal.remove(0, b, guard, 2));
  }
}

/// Edges and faces of the complex that cross the segment from a to b.
int all_crossings(const RandomTets& tets, const RecoveryGuard& guard) {
  int sum = 0;
  for (const Tet& n : tets.complex.nodes) {
    if (n[0] < 0) continue;
    // Each face from the tet behind it only; enclosing nodes lie beyond all segments.
    for (const auto& f : tet_face_nodes) {
      const auto v = [&](std::size_t i) { return n[static_cast<std::size_t>(f[i])]; };
      sum += guard.crossings(v(0), v(1), v(2));
    }
  }
  return sum / 2;
}

TEST(EdgeRemoval, in_the_way_of_an_edge_always_leaves_less_in_its_way) {
  int removed = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    RandomTets tets(points, seed);
    const RecoverySurface no_surface({}, points);
    EdgeRemoval removal(tets.mesh, no_surface);
    for (std::int32_t goal = 1; goal < 10; ++goal) {
      const SegmentWalk walk = walk_segment(tets.mesh, 0, goal);
      if (walk.crossings.empty() || walk.crossings.front().face == no_face) continue;
      const auto guard = RecoveryGuard::of_edge(tets.mesh, 0, goal);
      const std::array<std::int32_t, 3> face = tets.complex.face_nodes(walk.crossings.front().face);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t a = face[k], b = face[(k + 1) % 3];
        const int before = all_crossings(tets, guard);
        removal.set_budget(100);
        const bool is_gone = removal.remove(a, b, guard, 2);
        const int after = all_crossings(tets, guard);
        if (is_gone) {
          ++removed;
          EXPECT_LT(after, before);
        } else {
          EXPECT_LE(after, before);
        }
      }
    }
    EXPECT_TRUE(validate(tets.complex).empty());
  }
  EXPECT_GT(removed, 15);
}

/// Two tets over one face, with their tips at (x, x, 1) and (1, 1, -1).
struct TwoTets {
  explicit TwoTets(double x)
      : complex(make_tet_complex({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {x, x, 1}, {1, 1, -1}},
                                  {{0, 1, 2, 3}, {0, 2, 1, 4}},
                                  5})) {}
  bool remove_face(const RecoveryGuard& guard) {
    EdgeRemoval removal(mesh, surface);
    return removal.remove_face(mesh.find_face(0, 1, 2), guard);
  }

  TetComplex complex;
  std::vector<std::uint8_t> constrained;
  LocalRemeshing mesh{complex, constrained};
  RecoverySurface surface{{}, 5};
};

TEST(EdgeRemoval, of_a_face_puts_three_tets_in_place_of_two) {
  TwoTets tets(1);
  const double volume = volume_of(tets.complex);
  EXPECT_TRUE(tets.remove_face(RecoveryGuard::of_nothing(tets.mesh)));
  EXPECT_EQ(tets.complex.live_tets(), 3U);
  EXPECT_GE(tets.mesh.find_edge(3, 4), 0);
  EXPECT_TRUE(validate(tets.complex).empty());
  EXPECT_NEAR(volume_of(tets.complex), volume, 1e-12);
}

TEST(EdgeRemoval, of_a_face_is_refused_when_it_is_constrained_or_not_convex_or_in_the_way) {
  TwoTets constrained(1);
  constrained.mesh.constrain(constrained.mesh.find_face(0, 1, 2), true);
  EXPECT_FALSE(constrained.remove_face(RecoveryGuard::of_nothing(constrained.mesh)));
  for (const double x : {3.0, 4.0}) {
    // The edge between the tips meets the side of the face, or passes it.
    TwoTets tets(x);
    EXPECT_FALSE(tets.remove_face(RecoveryGuard::of_nothing(tets.mesh)));
    EXPECT_EQ(tets.complex.live_tets(), 2U);
  }
  TwoTets guarded(1);
  EXPECT_FALSE(guarded.remove_face(RecoveryGuard::of_face(guarded.mesh, {0, 1, 2})));
  EXPECT_EQ(guarded.complex.live_tets(), 2U);
  EdgeRemoval removal(guarded.mesh, guarded.surface);
  EXPECT_FALSE(removal.remove_face(no_face, RecoveryGuard::of_nothing(guarded.mesh)));
}

}  // namespace
}  // namespace tetfarm
