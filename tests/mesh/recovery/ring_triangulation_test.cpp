#include "mesh/recovery/ring_triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "tests/mesh/recovery/random_tets.h"

namespace tetfarm {
namespace {

TEST(RingTriangulation, of_an_octahedron_axis_counts_what_crosses_a_missing_edge) {
  const std::vector<Vec3> points = {{0, 0, -1}, {0, 0, 1},  {1, 0, 0},
                                    {0, 1, 0},  {-1, 0, 0}, {0, -1, 0}};
  TetComplex complex = bowyer_watson(points).complex;
  std::vector<std::uint8_t> constrained;
  LocalRemeshing mesh(complex, constrained);
  // Whichever diagonal is there has a ring of four.
  for (const auto& [a, b] : {std::array{0, 1}, std::array{2, 4}, std::array{3, 5}}) {
    const auto ring = mesh.ring(a, b);
    if (!ring) continue;
    ASSERT_EQ(ring->apexes.size(), 4U);
    const auto free = RecoveryGuard::of_nothing(mesh);
    const auto triangles = ring_triangulation(mesh, *ring, a, b, -1, free);
    ASSERT_TRUE(triangles.has_value());
    EXPECT_EQ(triangles->triangles.size(), 2U);
    EXPECT_EQ(triangles->crossings, 0);
    // Both other diagonals cross this one.
    const auto own = RecoveryGuard::of_edge(mesh, a, b);
    EXPECT_GT(ring_triangulation(mesh, *ring, a, b, -1, own)->crossings, 0);
  }
}

using RingTriangle = std::array<std::size_t, 3>;
using Cut = std::vector<RingTriangle>;

/// Every way to cut the polygon of the corners `first` to `last` into triangles.
std::vector<Cut> all_cuts(std::size_t first, std::size_t last) {
  if (last - first < 2) return {{}};
  std::vector<Cut> cuts;
  for (std::size_t k = first + 1; k < last; ++k) {
    for (const Cut& left : all_cuts(first, k)) {
      for (const Cut& right : all_cuts(k, last)) {
        Cut cut = {{first, k, last}};
        cut.insert(cut.end(), left.begin(), left.end());
        cut.insert(cut.end(), right.begin(), right.end());
        cuts.push_back(cut);
      }
    }
  }
  return cuts;
}

/// What of the triangles, and of the chords with the faces from them to both ends, is in the way.
int crossings_of(const EdgeRing& ring, const Cut& cut, std::int32_t a, std::int32_t b,
                 const RecoveryGuard& guard) {
  int sum = 0;
  const auto apex = [&](std::size_t i) { return ring.apexes[i]; };
  std::map<std::array<std::size_t, 2>, int> edges;
  for (const auto& [i, j, k] : cut) {
    sum += guard.crossings(apex(i), apex(j), apex(k));
    for (const auto& [p, q] : {std::minmax(i, j), std::minmax(j, k), std::minmax(i, k)}) {
      ++edges[{p, q}];
    }
  }
  for (const auto& [edge, uses] : edges) {
    if (uses < 2) continue;
    const std::int32_t p = apex(edge[0]), q = apex(edge[1]);
    sum += guard.crossings(p, q) + guard.crossings(p, q, a) + guard.crossings(p, q, b);
  }
  return sum;
}

bool are_positive(const LocalRemeshing& mesh, const std::vector<Tet>& tets) {
  return std::all_of(tets.begin(), tets.end(),
                     [&](const Tet& t) { return mesh.orient(t[0], t[1], t[2], t[3]) > 0; });
}

/// The fewest crossings of all cuts with positive tets; nothing when there are none. The ear, if
/// any, is in one triangle.
std::optional<int> fewest_crossings(const LocalRemeshing& mesh, const EdgeRing& ring,
                                    std::int32_t a, std::int32_t b, std::int32_t ear,
                                    const RecoveryGuard& guard) {
  std::optional<int> fewest;
  for (const Cut& cut : all_cuts(0, ring.apexes.size() - 1)) {
    const auto at_ear = std::count_if(cut.begin(), cut.end(), [&](const RingTriangle& t) {
      return ring.apexes[t[0]] == ear || ring.apexes[t[1]] == ear || ring.apexes[t[2]] == ear;
    });
    if (ear >= 0 && at_ear != 1) continue;
    if (!are_positive(mesh, tets_of({cut, 0}, ring, a, b))) continue;
    const int crossings = crossings_of(ring, cut, a, b, guard);
    if (!fewest || crossings < *fewest) fewest = crossings;
  }
  return fewest;
}

TEST(RingTriangulation, has_the_fewest_crossings_of_all_that_there_are) {
  const RandomTets tets(60, 3);
  std::array<int, 2> found{};
  int crossed = 0;
  for (std::int32_t a = 0; a < 60; ++a) {
    for (std::int32_t b = a + 1; b < 60; ++b) {
      const auto ring = tets.mesh.ring(a, b);
      if (!ring || ring->apexes.size() > 7) continue;
      for (std::int32_t i = 0; i < 8; ++i) {
        const auto guard = RecoveryGuard::of_edge(tets.mesh, ring->apexes[0], (a + 7 * i + 1) % 60);
        const std::int32_t ear = i % 2 == 0 ? -1 : ring->apexes[2];
        const auto expected = fewest_crossings(tets.mesh, *ring, a, b, ear, guard);
        const auto cut = ring_triangulation(tets.mesh, *ring, a, b, ear, guard);
        ASSERT_EQ(cut.has_value(), expected.has_value());
        ++found[cut ? 1 : 0];
        if (!cut) continue;
        EXPECT_EQ(cut->crossings, *expected);
        EXPECT_EQ(crossings_of(*ring, cut->triangles, a, b, guard), *expected);
        EXPECT_TRUE(are_positive(tets.mesh, tets_of(*cut, *ring, a, b)));
        EXPECT_EQ(cut->triangles.size(), ring->apexes.size() - 2);
        crossed += *expected > 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(found[0], 50);
  EXPECT_GT(found[1], 50);
  EXPECT_GT(crossed, 10);
}

TEST(RingTriangulation, of_a_ring_that_is_too_long_or_without_the_ear_is_none) {
  const auto triangulated = [](std::int32_t apexes, std::int32_t ear) {
    TetComplex complex = tets_round_an_edge(apexes, 1);
    std::vector<std::uint8_t> constrained;
    const LocalRemeshing mesh(complex, constrained);
    return ring_triangulation(mesh, *mesh.ring(0, 1), 0, 1, ear, RecoveryGuard::of_nothing(mesh))
        .has_value();
  };
  constexpr auto longest = static_cast<std::int32_t>(longest_ring);
  EXPECT_TRUE(triangulated(3, -1));
  EXPECT_TRUE(triangulated(longest, -1));
  EXPECT_FALSE(triangulated(longest + 1, -1));
  EXPECT_TRUE(triangulated(5, 4));
  EXPECT_FALSE(triangulated(5, 7));
}

}  // namespace
}  // namespace tetfarm
