/// A ball's tets with the boundary recovered, ready for points inside.
#pragma once

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/boundary_recovery.h"
#include "mesh/recovery/inside_tets.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {

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
  void expect_boundary_as_it_was() {
    const LocalRemeshing mesh(complex, constrained);
    for (const auto& [a, b, c] : triangles) {
      const FaceHandle face = mesh.find_face(a, b, c);
      ASSERT_NE(face, no_face);
      EXPECT_TRUE(mesh.is_constrained(face));
    }
  }

  std::vector<Triangle> triangles;
  std::int32_t boundary_nodes = 0;
  TetComplex complex;
  std::vector<std::uint8_t> constrained;
};

}  // namespace tetfarm
