#include "mesh/filling/point_insertion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/mesh/recovery/recovered_sphere.h"

namespace tetfarm {
namespace {

std::vector<LatticeNode> nodes_inside(const TetComplex& complex,
                                      const std::vector<std::uint8_t>& inside,
                                      const SpacingField& spacing, const Box3& box) {
  const std::vector<LatticeNode> nodes = spacing.lattice_nodes(box);
  const auto is_inside =
      find_inside_nodes(complex, inside, nodes, std::vector<std::uint8_t>(nodes.size()));
  std::vector<LatticeNode> chosen;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (is_inside[i] != 0) chosen.push_back(nodes[i]);
  }
  return chosen;
}

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
  sphere.expect_boundary_as_it_was();
}

}  // namespace
}  // namespace tetfarm
