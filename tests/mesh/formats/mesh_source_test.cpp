#include "mesh/formats/mesh_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "mesh/formats/hdf5/hdf5_file.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/formats/ugrid/ugrid_source.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {
namespace {

std::filesystem::path exported(const MeshSource& source, const TempFolder& folder,
                               const std::string& name) {
  const std::filesystem::path file = folder.path() / name;
  export_mesh(source, find_mesh_format("", file), file);
  return file;
}

TEST(MeshSource, outline_counts_what_the_parts_have) {
  const GridSource grid(cut_grid(4));
  const MeshOutline outline = outline_of(grid);
  EXPECT_EQ(outline.nodes, 125);
  EXPECT_EQ(outline.tets, 6 * 64);
  EXPECT_EQ(outline.boundary_triangles, 6 * 16 * 2);
  ASSERT_EQ(outline.parts.size(), 3u);
  std::int64_t owned = 0;
  for (const PartOutline& part : outline.parts) owned += part.owned_nodes;
  EXPECT_EQ(owned, 125);
  EXPECT_EQ(outline.parts[2].first_tet, outline.parts[0].tets + outline.parts[1].tets);
  EXPECT_THAT(outline.faces_of_patch, testing::ElementsAre(32, 160));
  EXPECT_THAT(outline.patch_names, testing::ElementsAre("low x", "elsewhere"));
  EXPECT_THAT(outline.region_names, testing::ElementsAre("domain"));
}

TEST(MeshOutline, is_of_tets_alone_when_it_has_no_other_cells_and_no_quads_on_its_boundary) {
  MeshOutline outline;
  outline.tets = 5;
  outline.boundary_triangles = 8;
  EXPECT_TRUE(outline.has_tets_alone());
  MeshOutline with_quads = outline;
  with_quads.blocks[ElementType::quad].count = 1;
  EXPECT_FALSE(with_quads.has_tets_alone());
  MeshOutline with_prisms = outline;
  with_prisms.blocks[ElementType::prism].count = 1;
  EXPECT_FALSE(with_prisms.has_tets_alone());
}

TEST(MeshSource, refuses_a_node_number_that_is_missing) {
  GridSource grid(cut_grid(4));
  for (NumberedPart& part : grid.parts) {
    for (std::int64_t& number : part.local2global) number += number > 50 ? 1 : 0;
  }
  EXPECT_THROW(outline_of(grid), InvalidInput);
}

TEST(MeshSource, a_vtkhdf_file_of_more_partitions_than_there_can_be_is_refused_unread) {
  const TempFolder folder;
  const std::filesystem::path path = folder.path() / "a.vtkhdf";
  Hdf5Output file(path.string());
  file.make_group("VTKHDF");
  file.add_text_attribute("VTKHDF", "Type", "UnstructuredGrid");
  for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"}) {
    file.room_for<std::int64_t>("VTKHDF/" + std::string(name), std::int64_t{1} << 26);
  }
  file.close();
  try {
    open_mesh(path);
    ADD_FAILURE() << "taken";
  } catch (const InvalidInput& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("VTKHDF/NumberOfPoints has 67108864 numbers"));
  }
}

TEST(MeshSource, vtkhdf_gives_the_parts_back) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  const auto read = open_mesh(exported(grid, folder, "a.vtkhdf"));
  ASSERT_EQ(read->size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read->part(i).nodes, grid.part(i).nodes);
    EXPECT_EQ(read->part(i).tets, grid.part(i).tets);
    EXPECT_EQ(read->part(i).faces, grid.part(i).faces);
    EXPECT_EQ(read->part(i).local2global, grid.part(i).local2global);
  }
  EXPECT_EQ(read->patch_names(), grid.patch_names());
}

TEST(MeshSource, ugrid_comes_in_pieces_that_are_the_same_mesh) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  const auto file = exported(grid, folder, "a.lb8.ugrid");
  for (const std::int64_t tets : {50, 10'000}) {
    const auto read = open_ugrid(file, {}, tets);
    EXPECT_EQ(read->size(), tets == 50 ? 8u : 1u);
    EXPECT_EQ(content_of(*read), content_of(grid));
    EXPECT_EQ(read->patch_names(), grid.patch_names());
    EXPECT_EQ(outline_of(*read).nodes, 125);
  }
}

TEST(MeshSource, ugrid_regions_come_from_the_file_beside) {
  const TempFolder folder;
  GridSource grid(cut_grid(4));
  grid.parts[1].region = grid.parts[2].region = 2;
  const auto read = open_mesh(exported(grid, folder, "a.lb8.ugrid"));
  ASSERT_EQ(read->size(), 2u);
  EXPECT_EQ(read->part(1).region, 2);
  EXPECT_THAT(read->region_names(), testing::ElementsAre("region 1", "region 2"));
}

TEST(MeshSource, a_cut_short_file_is_refused) {
  const TempFolder folder;
  const auto file = exported(GridSource(cut_grid(4)), folder, "a.lb8.ugrid");
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
  EXPECT_THROW(open_mesh(file), InvalidInput);
}

TEST(MeshSource, the_outline_of_a_file_is_that_of_the_parts_with_all_their_nodes) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  export_mesh(grid, find_mesh_format("", "a.vtkhdf"), folder.path() / "a.vtkhdf");
  const auto file = open_mesh(folder.path() / "a.vtkhdf");
  const MeshOutline of_file = outline_of(*file);
  const MeshOutline of_grid = outline_of(grid);
  EXPECT_EQ(of_file.tets, of_grid.tets);
  EXPECT_EQ(of_file.nodes, of_grid.nodes);
  EXPECT_EQ(of_file.boundary_triangles, of_grid.boundary_triangles);
  EXPECT_EQ(of_file.faces_of_patch, of_grid.faces_of_patch);
  for (std::size_t i = 0; i < grid.size(); ++i) {
    EXPECT_EQ(of_file.parts[i].owned_nodes, of_grid.parts[i].owned_nodes);
    EXPECT_EQ(of_file.parts[i].faces_of_patch, of_grid.parts[i].faces_of_patch);
    EXPECT_EQ(of_file.parts[i].tets_of_region, of_grid.parts[i].tets_of_region);
  }
}

}  // namespace
}  // namespace tetfarm
