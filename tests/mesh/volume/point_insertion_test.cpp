#include "mesh/volume/point_insertion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/volume/boundary_recovery.h"
#include "mesh/volume/inside_tets.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {
namespace {

/// A sphere's tets with the boundary recovered, ready for points.
struct RecoveredSphere {
  explicit RecoveredSphere(int levels) {
    const Subdomain domain = root_subdomain(shapes::sphere({0, 0, 0}, 1, levels));
    triangles = domain.triangles;
    boundary_nodes = static_cast<std::int32_t>(domain.vertices.size());
    complex = bowyer_watson(domain.vertices).complex;
    constrained.assign(complex.nodes.size(), 0);
    EXPECT_TRUE(recover_boundary(complex, constrained, triangles).lost.empty());
  }
  std::vector<std::uint8_t> inside() {
    return inside_tets(
        LocalRemeshing(complex, constrained),
        RecoverySurface(triangles, static_cast<std::int32_t>(complex.points.size())));
  }

  std::vector<Triangle> triangles;
  std::int32_t boundary_nodes = 0;
  TetComplex complex;
  std::vector<std::uint8_t> constrained;
};

TEST(PointInsertion, keeps_lattice_nodes_of_the_inside_only) {
  RecoveredSphere sphere(3);
  const Box3 box = bounding_box(shapes::sphere({0, 0, 0}, 1, 1).vertices);
  const SpacingField spacing(0.2);
  const auto nodes = nodes_inside(sphere.complex, sphere.inside(), spacing, box);
  std::size_t within = 0;
  for (const LatticeNode& node : spacing.lattice_nodes(box))
    within += norm(node.at) < 0.985 ? 1 : 0;
  for (const LatticeNode& node : nodes) EXPECT_LE(norm(node.at), 1.0);
  EXPECT_GE(nodes.size(), within);
}

TEST(PointInsertion, keeps_clear_of_boundary_faces_and_nodes) {
  RecoveredSphere sphere(3);
  const SpacingField spacing(0.15);
  Box3 box;
  box.add(Vec3{-1, -1, -1});
  box.add(Vec3{1, 1, 1});
  const auto nodes = nodes_inside(sphere.complex, sphere.inside(), spacing, box);
  const auto first = static_cast<std::int32_t>(sphere.complex.points.size());
  insert_lattice(sphere.complex, sphere.constrained, first, nodes);
  EXPECT_TRUE(validate(sphere.complex).empty());
  std::size_t inserted = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (sphere.complex.node2tet[static_cast<std::size_t>(first) + i] < 0) continue;
    ++inserted;
    const double h = 0.92 * nodes[i].cell_edge;
    // The faces of the icosphere lie a little inside the unit sphere.
    EXPECT_LT(norm(nodes[i].at), 1 - 0.45 * h);
  }
  EXPECT_GT(inserted, nodes.size() / 2);
  EXPECT_LT(inserted, nodes.size());
  EXPECT_FALSE(sphere.inside().empty());
}

TEST(PointInsertion, leaves_the_boundary_as_it_is) {
  RecoveredSphere sphere(2);
  Box3 box;
  box.add(Vec3{-1, -1, -1});
  box.add(Vec3{1, 1, 1});
  const auto nodes = nodes_inside(sphere.complex, sphere.inside(), SpacingField(0.2), box);
  insert_lattice(sphere.complex, sphere.constrained, sphere.boundary_nodes, nodes);
  const LocalRemeshing mesh(sphere.complex, sphere.constrained);
  for (const auto& [a, b, c] : sphere.triangles) {
    const FaceHandle face = mesh.find_face(a, b, c);
    ASSERT_NE(face, no_face);
    EXPECT_TRUE(mesh.is_constrained(face));
  }
}

}  // namespace
}  // namespace tetfarm
