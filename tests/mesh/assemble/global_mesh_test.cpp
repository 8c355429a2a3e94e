#include "mesh/assemble/global_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "mesh/core/validate.h"
#include "tests/mesh/assemble/cut_grid.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

GlobalMeshSummary assemble(const CutGrid& grid) {
  return assemble_global_mesh(grid.surface, grid.numbering(), grid.reader(), {});
}

void expect_refused(const CutGrid& grid, const std::string& why) {
  EXPECT_THAT([&] { assemble(grid); }, ThrowsMessage<Error>(HasSubstr(why)));
}

/// Of a right grid whose last portion was changed.
template <class Change>
void expect_refused_portion(const Change& change, const std::string& why) {
  const CutGrid grid = cut_grid(4);
  const ReadPortion read = [&](const LeafNumbers& leaf) {
    Portion portion = grid.reader()(leaf);
    if (leaf.path.heap == 7) change(portion);
    return portion;
  };
  EXPECT_THAT([&] { assemble_global_mesh(grid.surface, grid.numbering(), read, {}); },
              ThrowsMessage<Error>(HasSubstr(why)));
}

/// Keeps what it gets.
class Listener : public GlobalMeshWriter {
 public:
  void add(const NumberedPart& part) override { parts.push_back(part); }
  void finish() override { ++finished; }

  std::vector<NumberedPart> parts;
  int finished = 0;
};

TEST(GlobalMesh, the_parts_that_are_tested_with_are_right) {
  for (const auto& [heap, part] : cut_grid(4).parts) {
    EXPECT_THAT(validate(part.subdomain), testing::IsEmpty()) << heap;
    EXPECT_THAT(validate(part.mesh, part.subdomain.triangles), testing::IsEmpty()) << heap;
  }
}

TEST(GlobalMesh, has_every_node_and_tet_once) {
  const GlobalMeshSummary summary = assemble(cut_grid(4));
  EXPECT_EQ(summary.nodes, 125);
  EXPECT_EQ(summary.tets, 6 * 64);
  EXPECT_EQ(summary.boundary_triangles, 6 * 16 * 2);
  EXPECT_EQ(summary.subdomains, 3);
  EXPECT_NEAR(summary.volume, 1, 1e-12);
  EXPECT_NEAR(summary.enclosed_volume, 1, 1e-12);
}

TEST(GlobalMesh, figures_of_shape_are_those_of_the_tets) {
  const GlobalMeshSummary summary = assemble(cut_grid(3));
  EXPECT_EQ(summary.shapes.all.tets, summary.tets);
  EXPECT_NEAR(summary.shapes.all.min_dihedral_deg, 45, 1e-9);
  EXPECT_NEAR(summary.shapes.all.max_dihedral_deg, 90, 1e-9);
  std::int64_t angles = 0;
  for (const std::int64_t count : summary.shapes.all.dihedral_histogram) angles += count;
  EXPECT_EQ(angles, 6 * summary.tets);
}

TEST(GlobalMesh, writers_get_the_parts_in_tree_order_with_global_numbers) {
  const CutGrid grid = cut_grid(4);
  Listener listener;
  GlobalMeshWriter* writer = &listener;
  assemble_global_mesh(grid.surface, grid.numbering(), grid.reader(), {&writer, 1});
  ASSERT_EQ(listener.parts.size(), 3u);
  EXPECT_EQ(listener.finished, 1);
  std::map<std::int64_t, Vec3> nodes;
  for (const NumberedPart& part : listener.parts) {
    ASSERT_EQ(part.local2global.size(), part.nodes.size());
    for (std::size_t v = 0; v < part.nodes.size(); ++v) {
      const auto [it, is_new] = nodes.try_emplace(part.local2global[v], part.nodes[v]);
      EXPECT_EQ(it->second, part.nodes[v]);
    }
  }
  EXPECT_EQ(nodes.size(), 125u);
  EXPECT_EQ(nodes.rbegin()->first, 124);
  EXPECT_EQ(nodes.at(0), grid.surface.vertices[0]);
  EXPECT_EQ(nodes.at(1), grid.surface.vertices[2]) << "vertex 1 is unused";
}

TEST(GlobalMesh, digest_sees_coordinates_tets_and_patches) {
  const Hash128 digest = assemble(cut_grid(4)).digest;
  EXPECT_EQ(assemble(cut_grid(4)).digest, digest);
  CutGrid moved = cut_grid(4);
  moved.parts[7].mesh.nodes.back().x += 1e-9;
  EXPECT_NE(assemble(moved).digest, digest);
  CutGrid turned = cut_grid(4);
  Tet& tet = turned.parts[7].mesh.tets.front();
  std::rotate(tet.begin(), tet.begin() + 1, tet.begin() + 3);
  EXPECT_NE(assemble(turned).digest, digest);
  CutGrid painted = cut_grid(4);
  painted.surface.patch_of_triangle[3] ^= 1;
  EXPECT_NE(assemble(painted).digest, digest);
}

TEST(GlobalMesh, refuses_a_shared_node_that_differs_in_one_bit) {
  CutGrid grid = cut_grid(4);
  for (std::size_t v = 0;; ++v) {
    MeshPart& part = grid.parts[6];
    if (part.subdomain.node_origin[v].owner != 1) continue;
    part.mesh.nodes[v].y = std::nextafter(part.mesh.nodes[v].y, 9);
    break;
  }
  expect_refused(grid, "faces of neighbours differ, or their nodes");
}

TEST(GlobalMesh, refuses_a_surface_node_that_moved) {
  CutGrid grid = cut_grid(4);
  grid.parts[2].mesh.nodes[0].x += 1e-9;
  expect_refused(grid, "a node is not where the input surface has it");
}

TEST(GlobalMesh, refuses_sides_of_a_cut_that_differ) {
  CutGrid grid = cut_grid(4);
  MeshPart& part = grid.parts[6];
  // Two nodes of a cut change names and places: the tets of this side are other ones then.
  std::vector<std::size_t> on_cut;
  for (std::size_t v = 0; v < part.subdomain.node_origin.size(); ++v) {
    if (part.subdomain.node_origin[v].owner == 1) on_cut.push_back(v);
  }
  ASSERT_GE(on_cut.size(), 2U);
  std::swap(part.subdomain.node_origin[on_cut[0]], part.subdomain.node_origin[on_cut[1]]);
  std::swap(part.mesh.nodes[on_cut[0]], part.mesh.nodes[on_cut[1]]);
  expect_refused(grid, "faces of neighbours differ, or their nodes");
}

TEST(GlobalMesh, takes_parts_whose_nodes_come_from_anywhere) {
  const GlobalMeshSummary expected = assemble(cut_grid(4));
  CutGrid grid = cut_grid(4);
  for (auto& [heap, part] : grid.parts) {
    Subdomain& subdomain = part.subdomain;
    const std::size_t boundary = subdomain.vertices.size();
    for (std::size_t v = boundary; v < part.mesh.nodes.size(); ++v) {
      subdomain.node_origin.push_back({heap, static_cast<std::uint32_t>(v - boundary)});
    }
    subdomain.vertices = part.mesh.nodes;
    part.mesh.boundary_nodes = static_cast<std::int32_t>(part.mesh.nodes.size());
    for (std::size_t t = subdomain.triangles.size(); t-- > 0;) {
      if (subdomain.triangle_origin[t].owner == 0) continue;
      subdomain.triangles.erase(subdomain.triangles.begin() + static_cast<std::ptrdiff_t>(t));
      subdomain.triangle_origin.erase(subdomain.triangle_origin.begin() +
                                      static_cast<std::ptrdiff_t>(t));
    }
  }
  EXPECT_EQ(assemble(grid).digest, expected.digest);
}

TEST(GlobalMesh, refuses_a_surface_triangle_that_is_missing_or_there_twice) {
  CutGrid grid = cut_grid(4);
  Subdomain& subdomain = grid.parts[6].subdomain;
  ASSERT_EQ(subdomain.triangle_origin[0].owner, 0u);
  const Origin first = subdomain.triangle_origin[0];
  subdomain.triangle_origin[0] = grid.parts[7].subdomain.triangle_origin[0];
  expect_refused(grid, "a surface triangle has other nodes than in the input");
  subdomain.triangle_origin[0] = first;
  subdomain.triangles.erase(subdomain.triangles.begin());
  subdomain.triangle_origin.erase(subdomain.triangle_origin.begin());
  expect_refused(grid, "a triangle of the surface is in no sub-domain");
  expect_refused_portion([](Portion& last) { last.surface_triangles.push_back(0); },
                         "a surface triangle is in two sub-domains");
  expect_refused_portion([](Portion& last) { last.surface_triangles.push_back(1'000'000); },
                         "unknown triangle of the surface");
  expect_refused_portion([](Portion& last) { last.part.region = 2; },
                         "a surface triangle of another region");
}

TEST(GlobalMesh, refuses_other_counts_than_the_numbering_has) {
  CutGrid grid = cut_grid(4);
  grid.parts[7].mesh.tets.pop_back();
  expect_refused(grid, "different counts from the numbering");
  grid = cut_grid(4);
  grid.parts[7].mesh.nodes.push_back({});
  expect_refused(grid, "different counts from the numbering");
  grid = cut_grid(4);
  std::swap(grid.parts[6], grid.parts[7]);
  expect_refused(grid, "another portion, or different counts");
  expect_refused_portion([](Portion& last) { --last.tets; },
                         "another portion, or different counts");
}

TEST(GlobalMesh, refuses_a_node_that_is_unknown_or_in_no_part) {
  expect_refused_portion([](Portion& last) { last.part.local2global[0] = 125; }, "unknown node");
  expect_refused_portion([](Portion& last) { last.part.local2global[0] = -1; }, "unknown node");
  const CutGrid grid = cut_grid(4);
  Numbering numbering = grid.numbering();
  ++numbering.nodes;
  EXPECT_THAT([&] { assemble_global_mesh(grid.surface, numbering, grid.reader(), {}); },
              ThrowsMessage<Error>(HasSubstr("a node is in no sub-domain")));
}

TEST(GlobalMesh, refuses_faces_that_do_not_fit) {
  expect_refused_portion([](Portion& last) { ++last.face_sum; },
                         "faces of neighbours differ, or their nodes");
}

TEST(GlobalMesh, refuses_volumes_that_do_not_add_up) {
  for (const double factor : {0.5, 1 - 1e-7, 1 + 1e-7}) {
    expect_refused_portion([factor](Portion& last) { last.shapes.regions.at(0).volume *= factor; },
                           "the volumes of the elements do not add up");
  }
  CutGrid grid = cut_grid(4);
  std::swap(grid.parts[7].mesh.tets[0][1], grid.parts[7].mesh.tets[0][2]);
  expect_refused(grid, "faces of neighbours differ, or their nodes");
}

TEST(GlobalMesh, refuses_a_surface_triangle_whose_front_no_sub_domain_has) {
  CutGrid grid = cut_grid(4);
  grid.surface.sides.assign(grid.surface.triangles.size(), Sides{1, 0});
  EXPECT_EQ(assemble(grid).digest, assemble(cut_grid(4)).digest);
  grid.surface.sides[5] = {1, 2};
  expect_refused(grid, "a triangle of the surface is in no sub-domain");
}

TEST(GlobalMesh, takes_surface_triangles_that_have_the_region_in_front) {
  CutGrid grid = cut_grid(4);
  grid.surface.sides.assign(grid.surface.triangles.size(), Sides{0, 1});
  for (Triangle& triangle : grid.surface.triangles) std::swap(triangle[1], triangle[2]);
  EXPECT_EQ(assemble(grid).digest, assemble(cut_grid(4)).digest);
}

TEST(GlobalMesh, digest_sees_other_elements_than_tets) {
  const CutGrid grid = cut_grid(4);
  const ReadPortion read = [&grid](const LeafNumbers& leaf) {
    Portion portion = grid.reader()(leaf);
    ++portion.other_digest.count;
    return portion;
  };
  EXPECT_NE(assemble_global_mesh(grid.surface, grid.numbering(), read, {}).digest,
            assemble(grid).digest);
}

}  // namespace
}  // namespace tetfarm
