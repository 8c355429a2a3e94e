#include "mesh/filling/sweep_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/mesh/recovery/recovered_sphere.h"

namespace tetfarm {
namespace {

/// Every edge of tets inside, once, as node numbers.
std::set<std::array<std::int32_t, 2>> edges_inside(const TetComplex& complex,
                                                   const std::vector<std::uint8_t>& inside) {
  std::set<std::array<std::int32_t, 2>> edges;
  for (std::size_t t = 0; t < complex.nodes.size(); ++t) {
    if (inside[t] == 0) continue;
    const Tet& n = complex.nodes[t];
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        edges.insert({std::min(n[i], n[j]), std::max(n[i], n[j])});
      }
    }
  }
  return edges;
}

TEST(SweepPoints, make_edges_as_long_as_the_spacing) {
  RecoveredSphere sphere(3);
  const double h = 0.15;
  sweep_points(sphere.complex, sphere.constrained, sphere.inside(), SpacingField(h));
  double sum = 0;
  int fitting = 0;
  const auto edges = edges_inside(sphere.complex, sphere.inside());
  for (const auto& [a, b] : edges) {
    const double ratio = distance(sphere.complex.points[static_cast<std::size_t>(a)],
                                  sphere.complex.points[static_cast<std::size_t>(b)]) /
                         h;
    sum += ratio;
    if (ratio >= 0.7 && ratio <= 1.4) ++fitting;
  }
  const auto count = static_cast<double>(edges.size());
  EXPECT_NEAR(sum / count, 1, 0.05);
  EXPECT_GT(fitting, 0.8 * count);
}

TEST(SweepPoints, keep_their_distance_from_all_nodes) {
  RecoveredSphere sphere(2);
  const double h = 0.2;
  const SweepOptions options;
  const auto first = static_cast<std::int32_t>(sphere.complex.points.size());
  sweep_points(sphere.complex, sphere.constrained, sphere.inside(), SpacingField(h), options);
  int looked_at = 0;
  for (const auto& [a, b] : edges_inside(sphere.complex, sphere.inside())) {
    if (b < first) continue;  // an edge between nodes of the boundary
    ++looked_at;
    EXPECT_GE(distance(sphere.complex.points[static_cast<std::size_t>(a)],
                       sphere.complex.points[static_cast<std::size_t>(b)]),
              options.other_clearance * h * (1 - 1e-12));
  }
  EXPECT_GT(looked_at, 300) << "of some hundred points inside";
}

TEST(SweepPoints, stay_inside_and_leave_the_boundary_as_it_is) {
  RecoveredSphere sphere(2);
  const auto first = sphere.complex.points.size();
  const SweepReport report =
      sweep_points(sphere.complex, sphere.constrained, sphere.inside(), SpacingField(0.2));
  EXPECT_GT(report.points, 50);
  EXPECT_EQ(sphere.complex.points.size(), first + static_cast<std::size_t>(report.points));
  for (std::size_t v = first; v < sphere.complex.points.size(); ++v) {
    EXPECT_LT(norm(sphere.complex.points[v]), 1);
    EXPECT_GE(sphere.complex.node2tet[v], 0);
  }
  EXPECT_TRUE(validate(sphere.complex).empty());
  EXPECT_FALSE(sphere.inside().empty());
  sphere.expect_boundary_as_it_was();
}

TEST(SweepPoints, end_when_there_is_nothing_to_add) {
  RecoveredSphere sphere(2);
  const SpacingField spacing(0.2);
  EXPECT_GT(sweep_points(sphere.complex, sphere.constrained, sphere.inside(), spacing).sweeps, 1);
  const SweepReport again =
      sweep_points(sphere.complex, sphere.constrained, sphere.inside(), spacing);
  EXPECT_EQ(again.sweeps, 0);
  EXPECT_EQ(again.points, 0);
}

TEST(SweepPoints, are_none_where_the_mesh_is_fine_enough_or_not_inside) {
  RecoveredSphere sphere(2);
  EXPECT_EQ(
      sweep_points(sphere.complex, sphere.constrained, sphere.inside(), SpacingField(3)).points, 0);
  const std::vector<std::uint8_t> nowhere(sphere.complex.nodes.size(), 0);
  EXPECT_EQ(sweep_points(sphere.complex, sphere.constrained, nowhere, SpacingField(0.2)).points, 0);
}

/// Flat tets on a coarse boundary are what the height over its faces is there to prevent.
TEST(SweepPoints, keep_off_coarse_boundary_faces) {
  RecoveredSphere sphere(1);
  const double h = 0.1;
  const SweepOptions options;
  const auto first = static_cast<std::int32_t>(sphere.complex.points.size());
  sweep_points(sphere.complex, sphere.constrained, sphere.inside(), SpacingField(h), options);
  const auto at = [&](std::int32_t v) {
    return sphere.complex.points[static_cast<std::size_t>(v)];
  };
  const LocalRemeshing mesh(sphere.complex, sphere.constrained);
  for (const auto& [a, b, c] : sphere.triangles) {
    const FaceHandle face = mesh.find_face(a, b, c);
    ASSERT_NE(face, no_face);
    // Behind the triangle, which points out.
    const Tet& n = sphere.complex.nodes[static_cast<std::size_t>(tet_of(face))];
    const std::int32_t apex = n[static_cast<std::size_t>(face_of(face))];
    if (apex < first) continue;
    const Vec3 normal = normalized(cross(at(b) - at(a), at(c) - at(a)));
    EXPECT_GE(-dot(normal, at(apex) - at(a)), options.face_clearance * h * (1 - 1e-9));
  }
}

TEST(VolumeMesh, by_sweeps_holds_all_invariants_where_the_spacing_grows) {
  const SurfaceMesh surface =
      shapes::between(shapes::sphere({0, 0, 0}, 4, 2), shapes::sphere({0, 0, 0}, 0.5, 2));
  const Subdomain domain = root_subdomain(surface);
  const SpacingField spacing = make_spacing_field(surface, {});
  VolumeMeshOptions options;
  options.points = InteriorPoints::sweeps;
  const TetMesh mesh = mesh_volume(domain, spacing, options).mesh.value();
  expect_mesh_of(mesh, domain);
  EXPECT_GT(mesh.nodes.size(), 2 * domain.vertices.size());
}

}  // namespace
}  // namespace tetfarm
