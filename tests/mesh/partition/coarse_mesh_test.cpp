#include "mesh/partition/coarse_mesh.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/formats/cell_faces.h"
#include "mesh/formats/node_records.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/support/hybrid_grid.h"
#include "tests/support/whole_dual_graph.h"

namespace tetfarm {
namespace {

std::vector<InterfaceSide> sides_of(CoarseMesh& mesh) {
  std::vector<InterfaceSide> sides;
  InterfaceSide side;
  while (mesh.sides.next(side)) sides.push_back(side);
  return sides;
}

/// Who has each face that two sub-domains share: sub-domain and cell.
using Owners = std::vector<std::pair<std::int32_t, std::int32_t>>;

std::vector<Owners> shared_faces(const MeshSource& source) {
  std::map<FaceNodes<std::int64_t>, Owners> owners;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    for (const OuterFace& face : cell_faces(part).outer) {
      const auto nodes =
          face.nodes.renumbered([&](std::int32_t v) { return global_node(part, v); });
      owners[nodes.sorted()].emplace_back(static_cast<std::int32_t>(i), face.owner);
    }
  }
  std::vector<Owners> shared;
  for (const auto& [nodes, of_face] : owners) {
    if (of_face.size() == 2) shared.push_back(of_face);
  }
  std::sort(shared.begin(), shared.end());
  return shared;
}

TEST(CoarseMesh, weighs_the_cells_of_each_sub_domain_in_no_more_clusters_than_asked_for) {
  const TempFolder folder;
  const HybridGrid grid(6, 3);
  const CoarseMesh mesh = coarsen(grid, 60, true, folder.path());
  ASSERT_EQ(mesh.first_cluster.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto first = mesh.graph.weight.begin() + mesh.first_cluster[i];
    const auto last =
        i == 2 ? mesh.graph.weight.end() : mesh.graph.weight.begin() + mesh.first_cluster[i + 1];
    EXPECT_EQ(std::accumulate(first, last, 0), cells_of(grid.parts[i]));
    EXPECT_EQ(mesh.wanted_clusters[i], 20);
    EXPECT_GE(last - first, 2);
    EXPECT_LE(last - first, 40);
  }
}

TEST(CoarseMesh, with_a_cluster_for_each_cell_is_the_graph_of_the_cells) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  const CoarseMesh mesh = coarsen(grid, 1'000'000, true, folder.path());
  const WeightedGraph whole = test::whole_dual_graph(grid);
  ASSERT_EQ(mesh.graph.weight, whole.weight);
  EXPECT_EQ(mesh.graph.first, whole.first);
  for (std::size_t v = 0; v < whole.size(); ++v) {
    const auto neighbours = [v](const WeightedGraph& graph) {
      std::vector<std::int32_t> row(graph.neighbour.begin() + graph.first[v],
                                    graph.neighbour.begin() + graph.first[v + 1]);
      std::sort(row.begin(), row.end());
      return row;
    };
    EXPECT_EQ(neighbours(mesh.graph), neighbours(whole));
  }
  EXPECT_THAT(mesh.graph.edge_weight, testing::Each(1));
}

TEST(CoarseMesh, sides_are_those_of_each_face_between_sub_domains) {
  const TempFolder folder;
  const HybridGrid grid(5, 4);
  CoarseMesh mesh = coarsen(grid, 40, false, folder.path());
  const std::vector<InterfaceSide> sides = sides_of(mesh);
  EXPECT_TRUE(std::is_sorted(sides.begin(), sides.end()));
  std::vector<Owners> faces(sides.size() / 2);
  for (const InterfaceSide& side : sides) {
    faces.at(at(side.side / 2)).emplace_back(side.subdomain, side.column);
  }
  for (Owners& face : faces) std::sort(face.begin(), face.end());
  std::sort(faces.begin(), faces.end());
  const std::vector<Owners> expected = shared_faces(grid);
  EXPECT_GE(expected.size(), 75U);
  EXPECT_EQ(faces, expected);
}

TEST(CoarseMesh, edges_between_sub_domains_weigh_as_many_faces_as_their_clusters_share) {
  const TempFolder folder;
  const GridSource grid(cut_grid(5));
  CoarseMesh mesh = coarsen(grid, 30, true, folder.path());
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> expected;
  ASSERT_EQ(mesh.cluster_of_side.size(), 2 * shared_faces(grid).size());
  for (std::size_t i = 0; i < mesh.cluster_of_side.size(); i += 2) {
    ++expected[{mesh.cluster_of_side[i], mesh.cluster_of_side[i + 1]}];
    ++expected[{mesh.cluster_of_side[i + 1], mesh.cluster_of_side[i]}];
  }
  for (const InterfaceSide& side : sides_of(mesh)) {
    const std::int32_t cluster = mesh.cluster_of_side[at(side.side)];
    EXPECT_GE(cluster, mesh.first_cluster[at(side.subdomain)]);
    if (at(side.subdomain) + 1 < mesh.first_cluster.size()) {
      EXPECT_LT(cluster, mesh.first_cluster[at(side.subdomain) + 1]);
    }
  }
  const auto subdomain_of = [&](std::size_t cluster) {
    return std::upper_bound(mesh.first_cluster.begin(), mesh.first_cluster.end(),
                            static_cast<std::int32_t>(cluster)) -
           mesh.first_cluster.begin();
  };
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> found;
  for (std::size_t v = 0; v < mesh.graph.size(); ++v) {
    for (std::size_t e = mesh.graph.begin(v); e < mesh.graph.end(v); ++e) {
      const std::int32_t other = mesh.graph.neighbour[e];
      if (subdomain_of(v) == subdomain_of(at(other))) continue;
      found[{static_cast<std::int32_t>(v), other}] = mesh.graph.edge_weight[e];
    }
  }
  EXPECT_EQ(found, expected);
}

TEST(CoarseMesh, refuses_a_face_of_three_cells) {
  const TempFolder folder;
  GridSource grid(cut_grid(4));
  grid.parts.push_back(grid.parts[1]);
  EXPECT_THROW(coarsen(grid, 10, true, folder.path()), InvalidInput);
}

}  // namespace
}  // namespace tetfarm
