#include "mesh/recovery/facet_flips.h"

#include <gtest/gtest.h>

#include <random>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/edge_recovery.h"
#include "mesh/recovery/steiner_settling.h"

namespace tetfarm {
namespace {

constexpr std::int32_t nodes_in_plane = 80;

/// Nodes of the plane z = 0 first, so dense that their triangles are in the complex, then nodes on
/// both sides of it, on heights of `levels`.
std::vector<Vec3> plane_between_layers(std::uint64_t seed, int levels) {
  std::mt19937_64 random(seed);
  const auto draw = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<Vec3> points;
  for (int i = 0; i < nodes_in_plane; ++i) points.push_back({draw(0, 10), draw(0, 10), 0});
  for (int i = 0; i < 60; ++i) {
    const double height = 1.5 + i / 2 % levels;
    points.push_back({draw(-2, 12), draw(-2, 12), i % 2 == 0 ? height : -height});
  }
  return points;
}

std::size_t live_tets(const TetComplex& complex) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    if (complex.is_live(static_cast<std::int32_t>(t))) ++count;
  }
  return count;
}

struct Tried {
  int recovered = 0;
  std::size_t points = 0;
  int refused = 0;
};

/// Random edges of the plane, one after the other; the last ones cross those of before.
Tried recover_random_edges(std::uint64_t seed, int levels) {
  TetComplex complex = bowyer_watson(plane_between_layers(seed, levels)).complex;
  std::vector<std::uint8_t> constrained(complex.nodes.size(), 0);
  LocalRemeshing mesh(complex, constrained);
  const RecoverySurface no_surface({}, static_cast<std::int32_t>(complex.points.size()));
  std::mt19937_64 random(seed);
  Tried tried;
  std::vector<std::int32_t> all_inside;
  for (int i = 0; i < 60; ++i) {
    const auto a = static_cast<std::int32_t>(random() % nodes_in_plane);
    const auto b = static_cast<std::int32_t>(random() % nodes_in_plane);
    if (a == b || mesh.find_edge(a, b) >= 0) continue;
    const std::size_t before = live_tets(complex);
    std::vector<std::int32_t> inside;
    const bool is_there = recover_edge_in_facet(mesh, no_surface, a, b, inside);
    EXPECT_EQ(is_there, mesh.find_edge(a, b) >= 0);
    EXPECT_TRUE(is_there || inside.empty());
    EXPECT_TRUE(is_there || live_tets(complex) == before);
    for (const std::int32_t v : inside) EXPECT_NE(mesh.fine_point(v).high.z, 0);
    tried.recovered += is_there ? 1 : 0;
    tried.refused += is_there ? 0 : 1;
    tried.points += inside.size();
    all_inside.insert(all_inside.end(), inside.begin(), inside.end());
  }
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    if (!complex.is_live(static_cast<std::int32_t>(t))) continue;
    const auto& [p, q, r, s] = complex.nodes[t];
    EXPECT_GT(mesh.orient(p, q, r, s), 0);
  }
  // Its volumes are those of plain doubles.
  EXPECT_TRUE(settle_steiner_points(mesh, all_inside).unsettled.empty());
  const auto wrong = validate(complex);
  EXPECT_TRUE(wrong.empty()) << wrong.front();
  return tried;
}

TEST(FacetFlips, bring_random_edges_of_a_plane_by_swaps_in_it_and_points_beside_it) {
  Tried sum;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const Tried tried = recover_random_edges(seed, 1);
    sum.recovered += tried.recovered;
    sum.points += tried.points;
    sum.refused += tried.refused;
  }
  EXPECT_GT(sum.recovered, 3 * sum.refused);
  EXPECT_GT(sum.points, 0U);
}

TEST(FacetFlips, go_through_stars_of_uneven_tets) {
  Tried sum;
  for (std::uint64_t seed = 20; seed < 22; ++seed) {
    sum.recovered += recover_random_edges(seed, 7).recovered;
  }
  EXPECT_GT(sum.recovered, 8);
}

TEST(FacetFlips, leave_edges_of_the_surface_alone) {
  TetComplex complex = bowyer_watson(plane_between_layers(3, 1)).complex;
  std::vector<std::uint8_t> constrained(complex.nodes.size(), 0);
  LocalRemeshing mesh(complex, constrained);
  const auto nodes = static_cast<std::int32_t>(complex.points.size());
  int kept = 0;
  for (std::int32_t b = 1; b < nodes_in_plane && kept == 0; ++b) {
    if (mesh.find_edge(0, b) >= 0) continue;
    // What crosses the edge is of the surface.
    const SegmentWalk walk = walk_segment(mesh, 0, b);
    if (walk.crossings.size() != 1 || walk.crossings[0].face != no_face) continue;
    const auto [u, v] = walk.crossings[0].edge;
    const std::vector<Triangle> triangles = {{u, v, b}};
    std::vector<std::int32_t> inside;
    EXPECT_FALSE(recover_edge_in_facet(mesh, RecoverySurface(triangles, nodes), 0, b, inside));
    EXPECT_GE(mesh.find_edge(u, v), 0);
    ++kept;
  }
  EXPECT_EQ(kept, 1);
}

}  // namespace
}  // namespace tetfarm
