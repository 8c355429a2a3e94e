#include "mesh/filling/lattice_boundary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/array_index.h"
#include "mesh/filling/core_nodes.h"
#include "mesh/volume/volume_mesh.h"
#include "tests/mesh/filling/lattice_block.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {
namespace {

TEST(LatticeBoundary, of_lattice_tets_is_known_as_such) {
  const LatticeBlock block(4);
  ASSERT_THAT(validate(block.domain), testing::IsEmpty());
  const LatticeBoundary boundary = find_lattice_boundary(block.nodes, block.domain);
  EXPECT_THAT(boundary.is_lattice_face, testing::Each(1));
  std::set<std::int32_t> found;
  for (std::size_t i = 0; i < block.nodes.size(); ++i) {
    if (!boundary.has_vertex_at(i)) continue;
    EXPECT_EQ(block.domain.vertices[at(boundary.node2vertex[i])], block.nodes[i].at);
    found.insert(boundary.node2vertex[i]);
  }
  EXPECT_EQ(found.size(), block.domain.vertices.size());
}

TEST(LatticeBoundary, is_looked_for_in_cuts_only) {
  LatticeBlock block(4);
  for (Origin& origin : block.domain.node_origin) origin.owner = 0;
  const LatticeBoundary boundary = find_lattice_boundary(block.nodes, block.domain);
  EXPECT_THAT(boundary.is_lattice_face, testing::Each(0));
  EXPECT_FALSE(boundary.has_vertex_at(0));
}

TEST(LatticeBoundary, ends_where_a_node_lies_beside_the_lattice) {
  LatticeBlock block(4);
  block.domain.vertices[7].x += 1e-12;
  const LatticeBoundary boundary = find_lattice_boundary(block.nodes, block.domain);
  for (std::size_t t = 0; t < block.domain.triangles.size(); ++t) {
    const auto& [a, b, c] = block.domain.triangles[t];
    EXPECT_EQ(boundary.is_lattice_face[t], a != 7 && b != 7 && c != 7 ? 1 : 0);
  }
}

TEST(LatticeBoundary, lets_the_core_reach_a_cut_along_the_lattice) {
  const LatticeBlock block(4);
  const TetMesh mesh = mesh_volume(block.domain, block.field).mesh.value();
  expect_mesh_of(mesh, block.domain);
  EXPECT_EQ(mesh.tets.size(), at(block.core.tet_count()));
  const double edge = block.nodes.front().cell_edge;
  for (const Tet& t : mesh.tets) {
    const auto p = [&](std::size_t i) { return mesh.nodes[at(t[i])]; };
    EXPECT_NEAR(tet_volume(p(0), p(1), p(2), p(3)), edge * edge * edge / 12, 1e-12);
  }
}

TEST(LatticeBoundary, has_core_nodes_right_behind_it) {
  const LatticeBlock block(4);
  const LatticeBoundary boundary = find_lattice_boundary(block.nodes, block.domain);
  const BoxTree tree(triangle_boxes(block.domain.vertices, block.domain.triangles));
  const auto kinds =
      find_core_nodes(block.nodes, LatticeGrid(block.nodes), block.domain, tree, boundary);
  std::size_t at_cut = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const bool is_inside = block.core.is_core(static_cast<std::int32_t>(i));
    EXPECT_FALSE(boundary.has_vertex_at(i) && kinds[i] != not_core);
    EXPECT_FALSE(is_inside && kinds[i] == not_core);
    if (is_inside && kinds[i] == core_at_cut) ++at_cut;
  }
  EXPECT_GT(at_cut, 100U);
}

}  // namespace
}  // namespace tetfarm
