#include "mesh/cosmetics/element_homes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "base/array_index.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm {
namespace {

/// A home of its own for each tet.
std::vector<ElementHome> homes_of_all(const TetMesh& mesh) {
  std::vector<ElementHome> homes;
  for (std::uint32_t t = 0; t < mesh.tets.size(); ++t) {
    homes.push_back({t, static_cast<std::uint8_t>(t % 3)});
  }
  return homes;
}

TEST(ElementHomes, of_tets_that_are_the_same_are_theirs_in_whatever_place_and_order_of_nodes) {
  const TetMesh before = trial::kuhn_box(3, 0.4);
  const std::vector<ElementHome> homes = homes_of_all(before);
  TetMesh now = before;
  EXPECT_EQ(find_homes(before, homes, make_tet_complex(now)), homes);
  std::reverse(now.tets.begin(), now.tets.end());
  for (Tet& tet : now.tets) std::rotate(tet.begin(), tet.begin() + 1, tet.begin() + 3);
  std::vector<ElementHome> reversed = homes;
  std::reverse(reversed.begin(), reversed.end());
  EXPECT_EQ(find_homes(before, homes, make_tet_complex(now)), reversed);
}

TEST(ElementHomes, of_tets_that_are_the_same_in_places_behind_the_old_ones_are_theirs) {
  const TetMesh before = trial::kuhn_box(3, 0.4);
  std::vector<ElementHome> homes = homes_of_all(before);
  TetMesh twice = before;
  std::reverse(twice.tets.begin(), twice.tets.end());
  twice.tets.insert(twice.tets.begin(), before.tets.begin(), before.tets.end());
  TetComplex now{twice.nodes, twice.tets, {}, {}, {}};
  now.neighbours.resize(twice.tets.size());
  now.node2tet.assign(twice.nodes.size(), -1);
  for (std::int32_t t = 0; t < std::ssize(before.tets); ++t) now.kill_tet(t);
  std::reverse(homes.begin(), homes.end());
  EXPECT_EQ(find_homes(before, homes_of_all(before), now), homes);
}

TEST(ElementHomes, of_tets_whose_nodes_have_moved_stay) {
  const TetMesh before = trial::kuhn_box(3);
  const TetMesh moved = trial::kuhn_box(3, 0.6, 4);
  const std::vector<ElementHome> homes = homes_of_all(before);
  EXPECT_EQ(find_homes(before, homes, make_tet_complex(moved)), homes);
}

bool holds(const TetMesh& mesh, const Tet& tet, const Vec3& p) {
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Vec3, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = k == i ? p : mesh.nodes[at(tet[k])];
    if (tet_volume(corners[0], corners[1], corners[2], corners[3]) < 0) return false;
  }
  return true;
}

TEST(ElementHomes, of_new_tets_are_those_of_the_tets_that_held_their_centroids) {
  // The same points with other tets between them.
  const TetMesh before = trial::kuhn_box(3, 0.3);
  TetMesh now = trial::delaunay_mesh(before.nodes, before.boundary_nodes);
  const std::vector<ElementHome> homes = homes_of_all(before);
  std::vector<Tet> known = before.tets;
  for (Tet& tet : known) std::sort(tet.begin(), tet.end());
  TetComplex complex = make_tet_complex(now);
  while (complex.nodes.size() < before.tets.size()) complex.kill_tet(complex.new_tet());
  const std::vector<ElementHome> found = find_homes(before, homes, complex);
  ASSERT_EQ(found.size(), complex.live_tets());
  int fresh = 0;
  std::size_t next = 0;
  for (const Tet& tet : complex.nodes) {
    if (tet[0] < 0) continue;
    const ElementHome& home = found[next++];
    const Tet& old = before.tets[home.section];
    Tet sorted = tet;
    std::sort(sorted.begin(), sorted.end());
    if (std::find(known.begin(), known.end(), sorted) != known.end()) {
      EXPECT_EQ(known[home.section], sorted);
      continue;
    }
    ++fresh;
    Vec3 centroid;
    for (const std::int32_t v : tet) centroid += 0.25 * complex.points[at(v)];
    EXPECT_TRUE(holds(before, old, centroid));
  }
  EXPECT_GT(fresh, 20);
}

TEST(ElementHomes, leave_out_places_of_tets_that_are_dead) {
  const TetMesh before = trial::kuhn_box(2);
  std::vector<ElementHome> homes = homes_of_all(before);
  TetComplex complex = make_tet_complex(before);
  complex.kill_tet(5);
  homes.erase(homes.begin() + 5);
  EXPECT_EQ(find_homes(before, homes_of_all(before), complex), homes);
}

}  // namespace
}  // namespace tetfarm
