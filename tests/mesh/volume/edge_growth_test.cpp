// Edges of the mesh against the spacing asked for, where it grows.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "mesh/core/tet_mesh.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/volume/volume_mesh.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {
namespace {

constexpr double growth = 0.3;

/// Edges whose spacing lies within one factor of two.
struct EdgesOfSize {
  int count = 0;
  int fitting = 0;  // 0.7 to 1.4 times the spacing
  double sum_of_ratios = 0;
  double largest_ratio = 0;
};

/// By the power of two of the spacing in the middle of the edge. Edges of the boundary are given,
/// and do not count.
std::map<int, EdgesOfSize> edges_by_size(const TetMesh& mesh, const SpacingField& spacing,
                                         std::int32_t boundary_nodes) {
  std::set<std::array<std::int32_t, 2>> edges;
  for (const Tet& t : mesh.tets) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        edges.insert({std::min(t[i], t[j]), std::max(t[i], t[j])});
      }
    }
  }
  std::map<int, EdgesOfSize> sizes;
  for (const auto& [a, b] : edges) {
    if (b < boundary_nodes) continue;
    const Vec3& from = mesh.nodes[static_cast<std::size_t>(a)];
    const Vec3& to = mesh.nodes[static_cast<std::size_t>(b)];
    const double wanted = spacing.at(0.5 * (from + to));
    const double ratio = distance(from, to) / wanted;
    EdgesOfSize& size = sizes[std::ilogb(wanted)];
    ++size.count;
    if (ratio >= 0.7 && ratio <= 1.4) ++size.fitting;
    size.sum_of_ratios += ratio;
    size.largest_ratio = std::max(size.largest_ratio, ratio);
  }
  return sizes;
}

class EdgesWhereSpacingGrows : public testing::TestWithParam<InteriorPoints> {};

TEST_P(EdgesWhereSpacingGrows, are_as_long_as_asked_at_every_size) {
  const SurfaceMesh surface = make_shape("wing", {.spacing = 0.05, .growth = growth});
  const Subdomain domain = root_subdomain(surface);
  SpacingOptions options;
  options.growth = growth;
  const SpacingField spacing = make_spacing_field(surface, options);
  VolumeMeshOptions how;
  how.points = GetParam();
  const TetMesh mesh = mesh_volume(domain, spacing, how).mesh.value();
  expect_mesh_of(mesh, domain);
  int sizes = 0;
  EdgesOfSize all;
  for (const auto& [exponent, edges] :
       edges_by_size(mesh, spacing, static_cast<std::int32_t>(domain.vertices.size()))) {
    all.count += edges.count;
    all.fitting += edges.fitting;
    all.sum_of_ratios += edges.sum_of_ratios;
    constexpr int enough = 500;
    if (edges.count < enough) continue;
    ++sizes;
    EXPECT_NEAR(edges.sum_of_ratios / edges.count, 1, 0.15) << "spacing 2^" << exponent;
    EXPECT_LT(edges.largest_ratio, 2.1) << "spacing 2^" << exponent;
  }
  EXPECT_GE(sizes, 4) << "the spacing does not grow enough to tell";
  EXPECT_NEAR(all.sum_of_ratios / all.count, 1, 0.05);
  EXPECT_GE(all.fitting, 0.8 * all.count);
}

INSTANTIATE_TEST_SUITE_P(By, EdgesWhereSpacingGrows,
                         testing::Values(InteriorPoints::lattice, InteriorPoints::sweeps),
                         [](const auto& parameter) {
                           return parameter.param == InteriorPoints::lattice ? "lattice" : "sweeps";
                         });

}  // namespace
}  // namespace tetfarm
