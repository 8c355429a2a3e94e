#include "mesh/recovery/face_recovery.h"

#include <gmock/gmock.h>

#include <random>
#include <set>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/recovery_guard.h"

namespace tetfarm {
namespace {

using Edges = std::set<std::array<std::int32_t, 2>>;

/// A large triangle, the first three points, with others close to its middle on both sides.
std::vector<Vec3> pierced_triangle(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> aside(-1, 1);
  std::vector<Vec3> points = {{10, 0, 0}, {-5, 9, 0}, {-5, -9, 0}};
  for (int i = 0; i < 40; ++i) {
    points.push_back(
        {aside(random), aside(random), (i % 2 == 0 ? 0.5 : -0.5) + 0.1 * aside(random)});
  }
  return points;
}

Edges all_edges_through(const LocalRemeshing& mesh, const Triangle& face) {
  Edges edges;
  for (const Tet& tet : mesh.complex().nodes) {
    for (std::size_t i = 0; i < 4 && tet[0] >= 0; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (segment_crosses_triangle(mesh, tet[i], tet[j], face)) {
          edges.insert({std::min(tet[i], tet[j]), std::max(tet[i], tet[j])});
        }
      }
    }
  }
  return edges;
}

TEST(PiercingEdges, are_all_edges_through_the_face_and_each_once) {
  const Triangle face = {0, 1, 2};
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    TetComplex complex = bowyer_watson(pierced_triangle(seed)).complex;
    std::vector<std::uint8_t> constrained(complex.nodes.size(), 0);
    const LocalRemeshing mesh(complex, constrained);
    for (std::size_t k = 0; k < 3; ++k) ASSERT_GE(mesh.find_edge(face[k], face[(k + 1) % 3]), 0);
    const auto found = piercing_edges(mesh, face);
    const Edges wanted = all_edges_through(mesh, face);
    EXPECT_GT(wanted.size(), 10U);
    EXPECT_EQ(Edges(found.begin(), found.end()), wanted) << seed;
    EXPECT_EQ(found.size(), wanted.size()) << seed;
  }
}

}  // namespace
}  // namespace tetfarm
