#include "mesh/recovery/inside_tets.h"

#include <gtest/gtest.h>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/boundary_recovery.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {
namespace {

TEST(InsideTets, are_those_between_nested_spheres) {
  const Subdomain domain = root_subdomain(shapes::nested_spheres(2));
  DelaunayTets tets = bowyer_watson(domain.vertices);
  std::vector<std::uint8_t> constrained(tets.complex.nodes.size(), 0);
  const RecoveredBoundary recovered = recover_boundary(tets.complex, constrained, domain.triangles);
  ASSERT_TRUE(recovered.lost.empty());
  const RecoverySurface surface(domain.triangles,
                                static_cast<std::int32_t>(tets.complex.points.size()));
  const LocalRemeshing mesh(tets.complex, constrained);
  const auto inside = inside_tets(mesh, surface);
  const auto nodes = static_cast<std::int32_t>(domain.vertices.size());
  const InsideComplex kept = keep_inside(tets.complex, constrained, inside, nodes, 4);
  EXPECT_TRUE(validate(kept.complex).empty());
  expect_mesh_of(to_tet_mesh(kept.complex, nodes), domain);
}

TEST(InsideTets, are_none_when_the_boundary_leaks) {
  const Subdomain domain = root_subdomain(shapes::sphere({0, 0, 0}, 1, 1));
  DelaunayTets tets = bowyer_watson(domain.vertices);
  std::vector<std::uint8_t> constrained(tets.complex.nodes.size(), 0);
  recover_boundary(tets.complex, constrained, domain.triangles);
  const auto& [a, b, c] = domain.triangles.front();
  LocalRemeshing mesh(tets.complex, constrained);
  const RecoverySurface surface(domain.triangles,
                                static_cast<std::int32_t>(tets.complex.points.size()));
  EXPECT_FALSE(inside_tets(mesh, surface).empty());
  mesh.constrain(mesh.find_face(a, b, c), false);
  EXPECT_TRUE(inside_tets(mesh, surface).empty());
}

}  // namespace
}  // namespace tetfarm
