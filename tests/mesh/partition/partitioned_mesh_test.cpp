#include "mesh/partition/partitioned_mesh.h"

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "base/error.h"
#include "mesh/formats/communication/communication_table.h"
#include "mesh/formats/node_records.h"
#include "mesh/formats/openfoam/seam_faces.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/partition/dual_graph.h"
#include "mesh/partition/renumbered_mesh.h"
#include "mesh/quality/mesh_check.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/mesh/formats/marked_grid.h"
#include "tests/support/hybrid_grid.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

/// Clusters of many tets, as a large mesh has them.
PartitionOptions options_for(std::int32_t parts) { return {parts, 256}; }

/// The last sub-domain becomes a region of its own, with the triangles between it and the others.
GridSource grid_of_two_regions(int n) {
  GridSource grid(cut_grid(n));
  const TempFolder folder;
  SeamFaces seams(grid, outline_of(grid), folder.path());
  for (std::int32_t i = 0; i < std::ssize(grid.parts); ++i) {
    NumberedPart& part = grid.parts[static_cast<std::size_t>(i)];
    const auto last = static_cast<std::int32_t>(std::ssize(grid.parts)) - 1;
    part.region = i == last ? 2 : 1;
    std::map<std::int64_t, std::int32_t> local;
    for (std::size_t v = 0; v < part.nodes.size(); ++v) {
      local[part.local2global[v]] = static_cast<std::int32_t>(v);
    }
    for (const SeamFace& seam : seams.next_part()) {
      if ((seam.neighbour == last) == (i == last)) continue;
      part.faces.push_back({local[seam.nodes[0]], local[seam.nodes[1]], local[seam.nodes[2]]});
      part.patch_of_face.push_back(0);
    }
  }
  return grid;
}

/// Pieces of parts and faces between them, found from the written parts alone.
struct Found {
  std::vector<std::int32_t> pieces_of_part;
  std::int64_t cut_faces = 0;
};

Found found_in(const MeshSource& mesh) {
  Found found;
  const TempFolder folder;
  SeamFaces seams(mesh, outline_of(mesh), folder.path());
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const NumberedPart part = mesh.part(i);
    const WeightedGraph graph =
        dual_graph(cell_faces(part), static_cast<std::size_t>(cells_of(part)));
    const std::vector<std::int32_t> pieces = pieces_of_parts(
        graph, std::vector<std::int32_t>(static_cast<std::size_t>(cells_of(part)), 0));
    found.pieces_of_part.push_back(*std::max_element(pieces.begin(), pieces.end()) + 1);
    for (const SeamFace& seam : seams.next_part()) found.cut_faces += seam.neighbour > seam.part;
  }
  return found;
}

TEST(PartitionedMesh, has_the_marks_and_feet_of_the_mesh_in_the_files_that_hold_them) {
  const TempFolder folder;
  const MarkedGrid grid;
  const PartitionedMesh mesh(grid, {3}, folder.path());
  EXPECT_EQ(mesh.cell_marks(), grid.cell_marks());
  const auto file = folder.path() / "parts.vtkhdf";
  export_mesh(mesh, find_mesh_format("", file), file);
  const std::unique_ptr<MeshSource> written = open_mesh(file);
  EXPECT_TRUE(written->has_feet());
  std::multiset<std::int32_t> before;
  std::multiset<std::int32_t> after;
  for (const NumberedPart& part : grid.parts) {
    before.insert(part.marks[CellMark::layer].begin(), part.marks[CellMark::layer].end());
  }
  for (std::size_t i = 0; i < written->size(); ++i) {
    const NumberedPart part = written->part(i);
    after.insert(part.marks[CellMark::layer].begin(), part.marks[CellMark::layer].end());
    for (std::size_t v = 0; v < part.nodes.size(); ++v) {
      const std::int64_t node = part.local2global[v];
      EXPECT_EQ(part.feet.foot.at(v), node % 5 < 4 ? node - node % 5 : no_foot);
    }
  }
  EXPECT_EQ(after, before);
}

TEST(PartitionedMesh, parts_are_even_of_one_piece_and_together_the_mesh) {
  const TempFolder folder;
  const GridSource grid(cut_grid(10));
  for (const std::int32_t parts : {1, 2, 5, 16}) {
    SCOPED_TRACE(parts);
    const PartitionedMesh mesh(grid, options_for(parts), folder.path());
    ASSERT_EQ(mesh.size(), static_cast<std::size_t>(parts));
    EXPECT_EQ(content_of(mesh), content_of(grid));
    EXPECT_LE(mesh.figures().largest_over_mean(), 1.03);
    const Found found = found_in(mesh);
    EXPECT_THAT(found.pieces_of_part, testing::Each(1));
    EXPECT_EQ(found.cut_faces, mesh.figures().cut_faces);
    std::int64_t tets = 0;
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      EXPECT_EQ(std::ssize(mesh.part(i).tets), mesh.figures().cells[i]);
      tets += mesh.figures().cells[i];
    }
    EXPECT_EQ(tets, outline_of(grid).tets);
  }
}

TEST(PartitionedMesh, has_even_parts_rather_than_a_shorter_cut) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  // Of the ways to divide 384 tets there is one with a shorter cut and a part of 25.
  EXPECT_THAT(PartitionedMesh(grid, options_for(16), folder.path()).figures().cells,
              testing::Each(24));
}

TEST(PartitionedMesh, is_the_same_every_time) {
  const TempFolder folder;
  const GridSource grid(cut_grid(8));
  const PartitionedMesh once(grid, options_for(6), folder.path());
  const PartitionedMesh again(grid, options_for(6), folder.path());
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(once.part(i).local2global, again.part(i).local2global);
    EXPECT_EQ(once.part(i).tets, again.part(i).tets);
  }
}

TEST(PartitionedMesh, does_not_follow_the_sub_domains) {
  const TempFolder folder;
  const GridSource grid(cut_grid(8));
  const PartitionedMesh mesh(grid, options_for(2), folder.path());
  // One of the three sub-domains is half of the mesh or more: two even parts need a cut through it
  // or through both others.
  EXPECT_LT(mesh.figures().cut_faces, 2 * 2 * 8 * 8 + 64);
  EXPECT_LE(mesh.figures().largest_over_mean(), 1.03);
}

TEST(PartitionedMesh, communication_tables_are_right_and_all_nodes_are_owned_once) {
  const TempFolder folder;
  for (const GridSource& grid : {GridSource(cut_grid(8)), grid_of_two_regions(8)}) {
    const PartitionedMesh mesh(grid, options_for(7), folder.path());
    std::vector<CommunicationTable> tables;
    for_each_communication_table(mesh, outline_of(mesh), folder.path(),
                                 [&](const CommunicationTable& table) { tables.push_back(table); });
    EXPECT_THAT(communication_complaints(
                    7, [&](std::int32_t i) { return tables.at(static_cast<std::size_t>(i)); }),
                IsEmpty());
    EXPECT_EQ(tables.front().nodes_of_mesh, grid.nodes);
  }
}

std::vector<std::int64_t> tets_of_regions(const MeshSource& mesh) {
  return outline_of(mesh).tets_of_region;
}

TEST(PartitionedMesh, a_part_may_have_tets_of_several_regions_in_order) {
  const TempFolder folder;
  const GridSource grid = grid_of_two_regions(8);
  const PartitionedMesh mesh(grid, options_for(3), folder.path());
  EXPECT_EQ(content_of(mesh), content_of(grid));
  EXPECT_EQ(tets_of_regions(mesh), tets_of_regions(grid));
  EXPECT_THAT(found_in(mesh).pieces_of_part, testing::Each(1));
  int mixed = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const NumberedPart part = mesh.part(i);
    mixed += part.region_of_tet.empty() ? 0 : 1;
    EXPECT_TRUE(std::is_sorted(part.region_of_tet.begin(), part.region_of_tet.end()));
    EXPECT_EQ(part.region_of_face.size(), part.region_of_tet.empty() ? 0 : part.faces.size());
  }
  EXPECT_GT(mixed, 0);
}

TEST(PartitionedMesh, regions_are_the_same_in_files_that_are_read_back) {
  const TempFolder folder;
  const GridSource grid = grid_of_two_regions(6);
  const PartitionedMesh mesh(grid, options_for(3), folder.path());
  for (const char* name : {"mesh.vtkhdf", "mesh.lb8.ugrid"}) {
    SCOPED_TRACE(name);
    export_mesh(mesh, find_mesh_format("", name), folder.path() / name);
    const auto again = open_mesh(folder.path() / name);
    EXPECT_EQ(content_of(*again), content_of(grid));
    EXPECT_EQ(tets_of_regions(*again), tets_of_regions(grid));
  }
}

TEST(PartitionedMesh, every_format_takes_parts_of_several_regions) {
  const TempFolder folder;
  const GridSource grid = grid_of_two_regions(4);
  const PartitionedMesh mesh(grid, options_for(3), folder.path());
  for (const Format& format : written_formats()) {
    SCOPED_TRACE(format.name);
    const std::string name = "of-" + std::string(format.name) + std::string(format.endings[0]);
    EXPECT_EQ(export_mesh(mesh, format, folder.path() / name).parts, 3u);
  }
}

TEST(PartitionedMesh, parts_of_all_types_of_cells_are_the_mesh_each_of_one_piece) {
  const HybridGrid grid(7, 3);
  const MeshCheckResult wanted = check_mesh(grid);
  ASSERT_THAT(wanted.complaints, IsEmpty());
  const MeshOutline outline = outline_of(grid);
  for (const std::int32_t parts : {1, 2, 3, 5, 17}) {
    SCOPED_TRACE(parts);
    const TempFolder folder;
    const PartitionedMesh mesh(grid, options_for(parts), folder.path());
    ASSERT_EQ(mesh.size(), static_cast<std::size_t>(parts));
    const MeshCheckResult check = check_mesh(mesh);
    EXPECT_THAT(check.complaints, IsEmpty());
    EXPECT_EQ(check.nodes, wanted.nodes);
    EXPECT_NEAR(check.volume, grid.volume(), 1e-9);
    for (const ElementType type : all_element_types) {
      EXPECT_EQ(outline_of(mesh).elements()[type], outline.elements()[type])
          << element(type).plural;
    }
    for (std::size_t patch = 0; patch < 2; ++patch) {
      EXPECT_EQ(outline_of(mesh).boundary_faces_of(patch), outline.boundary_faces_of(patch));
    }
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      EXPECT_EQ(cells_of(mesh.part(i)), mesh.figures().cells[i]);
    }
    const Found found = found_in(mesh);
    EXPECT_EQ(found.cut_faces, mesh.figures().cut_faces);
    EXPECT_THAT(found.pieces_of_part, testing::Each(1));
    EXPECT_LT(mesh.figures().largest_over_mean(), 1.25);
  }
}

TEST(PartitionedMesh, cells_of_every_type_keep_their_regions_in_parts_and_with_other_numbers) {
  const HybridGrid mesh(5, 3, true);
  ASSERT_THAT(check_mesh(mesh).complaints, IsEmpty());
  const MeshOutline wanted = outline_of(mesh);
  const TempFolder folder;
  auto parts = std::make_unique<PartitionedMesh>(mesh, options_for(1), folder.path());
  const RenumberedMesh renumbered(std::move(parts), NodeNumbering::hilbert);
  EXPECT_THAT(check_mesh(renumbered).complaints, IsEmpty());
  const MeshOutline found = outline_of(renumbered);
  EXPECT_EQ(found.tets_of_region, wanted.tets_of_region);
  for (const ElementType type : cell_block_types) {
    EXPECT_EQ(found.blocks[type].of_group, wanted.blocks[type].of_group) << element(type).plural;
  }
}

TEST(PartitionedMesh, a_part_of_one_region_says_which_and_has_no_lists_of_regions) {
  const TempFolder folder;
  const GridSource grid = grid_of_two_regions(8);
  const PartitionedMesh mesh(grid, options_for(9), folder.path());
  std::map<std::int32_t, int> parts_of_region;
  for (std::size_t i = 0; i < mesh.size(); ++i) {
    const NumberedPart part = mesh.part(i);
    std::set<std::int32_t> regions;
    for (std::size_t t = 0; t < part.tets.size(); ++t) regions.insert(part.region_of(t));
    if (regions.size() > 1) continue;
    EXPECT_TRUE(part.region_of_tet.empty());
    EXPECT_TRUE(part.region_of_face.empty());
    ++parts_of_region[part.region];
  }
  EXPECT_GT(parts_of_region[1], 0);
  EXPECT_GT(parts_of_region[2], 0);
}

TEST(PartitionedMesh, may_have_as_many_parts_as_tets_and_no_more) {
  const TempFolder folder;
  const GridSource grid(cut_grid(2));
  const PartitionedMesh mesh(grid, options_for(48), folder.path());
  EXPECT_THAT(mesh.figures().cells, testing::Each(1));
  EXPECT_THROW(PartitionedMesh(grid, options_for(49), folder.path()), UsageError);
}

}  // namespace
}  // namespace tetfarm
