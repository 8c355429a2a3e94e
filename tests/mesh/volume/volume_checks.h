/// Checks and shapes that the tests of mesh/volume share.
#pragma once

#include <gtest/gtest.h>

#include <random>

#include "mesh/core/subdomain.h"
#include "mesh/core/validate.h"
#include "mesh/geometry/predicates.h"
#include "mesh/volume/volume_mesh.h"
#include "tests/support/shapes.h"

namespace tetfarm {

/// Every invariant of TetMesh: exactly positive tets, the boundary triangles as faces, the same
/// nodes.
inline void expect_mesh_of(const TetMesh& mesh, const Subdomain& subdomain) {
  ASSERT_EQ(mesh.boundary_nodes, static_cast<std::int32_t>(subdomain.vertices.size()));
  for (std::size_t v = 0; v < subdomain.vertices.size(); ++v) {
    ASSERT_EQ(mesh.nodes[v], subdomain.vertices[v]);
  }
  const auto complaints = validate(mesh, subdomain.triangles);
  EXPECT_TRUE(complaints.empty()) << complaints.front();
  for (const Tet& t : mesh.tets) {
    const auto p = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(t[i])]; };
    ASSERT_GT(orient3d(p(0), p(1), p(2), p(3)), 0);
  }
}

namespace shapes {

/// Schönhardt's polyhedron: a prism twisted by 30 degrees, which has no tets without an added
/// point.
inline SurfaceMesh schoenhardt() {
  SurfaceMesh mesh;
  const double c = 0.86602540378443864676;
  mesh.vertices = {{1, 0, 0}, {-0.5, c, 0}, {-0.5, -c, 0}, {c, 0.5, 1}, {-c, 0.5, 1}, {0, -1, 1}};
  mesh.triangles = {{2, 1, 0}, {3, 4, 5}};
  for (std::int32_t k = 0; k < 3; ++k) {
    const std::int32_t next = (k + 1) % 3;
    // The reflex diagonal runs from the lower corner k + 1 to the upper corner k turned away from
    // it.
    mesh.triangles.push_back({k, next, 3 + next});
    mesh.triangles.push_back({k, 3 + next, 3 + k});
  }
  return mesh;
}

/// A sphere with random radii: spikes and pits, still star-shaped, so it does not cut itself.
inline SurfaceMesh random_star(int levels, double shortest, double longest, std::uint64_t seed) {
  SurfaceMesh mesh = sphere({0, 0, 0}, 1, levels);
  std::mt19937_64 random(seed);
  for (Vec3& p : mesh.vertices) {
    const double share = static_cast<double>(random() >> 11) / 9007199254740992.0;
    p *= shortest + share * (longest - shortest);
  }
  return mesh;
}

}  // namespace shapes
}  // namespace tetfarm
