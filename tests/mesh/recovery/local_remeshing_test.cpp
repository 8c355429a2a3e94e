#include "mesh/recovery/local_remeshing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>

#include "mesh/core/sorted_face.h"
#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/edge_removal_by_flips.h"

namespace tetfarm {
namespace {

std::vector<Vec3> random_points(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Vec3> points(count);
  for (Vec3& p : points) p = {coordinate(random), coordinate(random), coordinate(random)};
  return points;
}

class LocalRemeshingOfRandomPoints : public testing::Test {
 protected:
  LocalRemeshingOfRandomPoints()
      : complex_(bowyer_watson(random_points(60, 4)).complex), mesh_(complex_, constrained_) {}

  /// Removes as many edges as it can; returns how many.
  int remove_edges(int most) {
    const RecoverySurface no_surface({}, 60);
    EdgeRemoval removal(mesh_, no_surface);
    const auto guard = RecoveryGuard::of_nothing(mesh_);
    int removed = 0;
    for (std::int32_t a = 0; a < 60 && removed < most; ++a) {
      for (std::int32_t b = a + 1; b < 60 && removed < most; ++b) {
        if (mesh_.find_edge(a, b) < 0) continue;
        removal.set_budget(100);
        removed += removal.remove(a, b, guard, 1) ? 1 : 0;
      }
    }
    return removed;
  }

  TetComplex complex_;
  std::vector<std::uint8_t> constrained_;
  LocalRemeshing mesh_;
};

TEST_F(LocalRemeshingOfRandomPoints, stays_valid_through_removals) {
  EXPECT_GT(remove_edges(30), 10);
  EXPECT_TRUE(validate(complex_).empty());
}

TEST_F(LocalRemeshingOfRandomPoints, is_exactly_as_before_after_rolling_back) {
  const auto nodes = complex_.nodes;
  const auto neighbours = complex_.neighbours;
  const auto free_tets = complex_.free_tets;
  const std::size_t mark = mesh_.mark();
  ASSERT_GT(remove_edges(30), 10);
  ASSERT_NE(complex_.nodes, nodes);
  mesh_.add_point(fine({0.5, 0.5, 0.5}));
  mesh_.roll_back(mark);
  EXPECT_EQ(complex_.nodes, nodes);
  EXPECT_EQ(complex_.neighbours, neighbours);
  EXPECT_EQ(complex_.free_tets, free_tets);
  EXPECT_TRUE(validate(complex_).empty());
}

TEST_F(LocalRemeshingOfRandomPoints, rings_turn_round_their_edge) {
  int rings = 0;
  for (std::int32_t b = 1; b < 60; ++b) {
    const auto ring = mesh_.ring(0, b);
    ASSERT_EQ(ring.has_value(), mesh_.find_edge(0, b) >= 0);
    if (!ring) continue;
    ++rings;
    const std::size_t n = ring->tets.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (const std::int32_t v : {0, b, ring->apexes[i], ring->apexes[(i + 1) % n]}) {
        EXPECT_GE(complex_.local_node(ring->tets[i], v), 0);
      }
      EXPECT_GT(tet_volume(mesh_.point(0), mesh_.point(b), mesh_.point(ring->apexes[i]),
                           mesh_.point(ring->apexes[(i + 1) % n])),
                0);
    }
  }
  EXPECT_GT(rings, 3);
}

TEST_F(LocalRemeshingOfRandomPoints, constrained_faces_outlive_the_tets_beside_them) {
  const auto star = mesh_.star(0);
  std::vector<std::array<std::int32_t, 3>> faces;
  for (const std::int32_t t : star) {
    const FaceHandle face = face_handle(t, complex_.local_node(t, 0));
    const Tet& n = complex_.nodes[static_cast<std::size_t>(t)];
    const auto& f = tet_face_nodes[static_cast<std::size_t>(face_of(face))];
    faces.push_back({n[static_cast<std::size_t>(f[0])], n[static_cast<std::size_t>(f[1])],
                     n[static_cast<std::size_t>(f[2])]});
    mesh_.constrain(face, true);
  }
  remove_edges(1000);
  for (const auto& [a, b, c] : faces) {
    const FaceHandle face = mesh_.find_face(a, b, c);
    ASSERT_NE(face, no_face);
    EXPECT_TRUE(mesh_.is_constrained(face));
  }
}

TEST_F(LocalRemeshingOfRandomPoints, finds_faces_that_are_there_and_no_others) {
  const Tet& n = complex_.nodes[static_cast<std::size_t>(complex_.node2tet[7])];
  EXPECT_NE(mesh_.find_face(n[0], n[1], n[2]), no_face);
  EXPECT_NE(mesh_.find_face(n[3], n[2], n[1]), no_face);
  // Of all triples, against those that a tet has.
  std::set<std::array<std::int32_t, 3>> there;
  for (const Tet& t : complex_.nodes) {
    if (t[0] < 0) continue;
    for (int face = 0; face < 4; ++face) there.insert(sorted_face(t, face));
  }
  std::size_t found = 0;
  for (std::int32_t a = 0; a < 60; ++a) {
    for (std::int32_t b = a + 1; b < 60; ++b) {
      for (std::int32_t c = b + 1; c < 60; ++c) {
        const bool is_found = mesh_.find_face(a, b, c) != no_face;
        EXPECT_EQ(is_found, there.contains({a, b, c})) << a << " " << b << " " << c;
        found += is_found ? 1U : 0U;
      }
    }
  }
  EXPECT_GT(found, 100U);
}

}  // namespace
}  // namespace tetfarm
