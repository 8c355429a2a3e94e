#include "mesh/formats/vtkhdf/read_vtkhdf.h"

#include <gtest/gtest.h>

#include <functional>

#include "base/error.h"
#include "mesh/formats/registry/export_mesh.h"
#include "mesh/formats/registry/open_mesh.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/every_kind_mesh.h"
#include "tests/mesh/formats/hdf5_edit.h"
#include "tests/mesh/formats/marked_grid.h"
#include "tests/mesh/formats/mesh_listing.h"

namespace tetfarm {
namespace {

using Edit = std::function<void(const std::string& path)>;
using Read = std::function<std::string(const std::string& path)>;

std::string opened(const std::string& path) { return mesh_listing(*open_mesh(path)); }

/// Of the mesh as one of tets in memory: how much it has.
std::string joined(const std::string& path) {
  const GlobalMesh mesh = read_vtkhdf(path);
  std::string text = "nodes";
  for (const Vec3& p : mesh.mesh.nodes) text += " " + digits_of(p.x + 10 * p.y + 100 * p.z);
  for (const Tet& tet : mesh.mesh.tets) text += "\ntet" + numbers_of(tet);
  text += "\nsub-domains" + numbers_of(mesh.subdomain_of_tet) + "; regions" +
          numbers_of(mesh.region_of_tet) + "; patches" + numbers_of(mesh.patch_of_triangle) +
          "; regions of triangles" + numbers_of(mesh.region_of_triangle) + "; ";
  for (const std::string& name : mesh.patch_names) text += name + ",";
  for (const std::string& name : mesh.region_names) text += name + ",";
  return text + " " + std::to_string(mesh.subdomains) + " sub-domains, " +
         std::to_string(mesh.mesh.boundary_nodes) + " on the boundary";
}

/// What is read of the mesh once its file was edited, or said of it.
std::string read_after(const MeshSource& mesh, const Edit& edit, const Read& read) {
  const TempFolder folder;
  const std::string path = folder.path() / "a.vtkhdf";
  export_mesh(mesh, find_mesh_format("vtkhdf", ""), path);
  edit(path);
  try {
    return read(path);
  } catch (const InvalidInput& error) {
    const std::string message = error.what();
    return message.substr(message.find("/a.vtkhdf") + 1);
  }
}

Edit number(const std::string& array, std::size_t index, std::int64_t value) {
  return [=](const std::string& path) { set_hdf5_number(path, "VTKHDF/" + array, index, value); };
}
Edit without(const std::string& name) {
  return [=](const std::string& path) { remove_from_hdf5(path, name); };
}
void leave(const std::string&) {}

struct WrongFile {
  Edit edit;
  std::string message;
};

TEST(ReadVtkhdf, says_what_is_wrong_with_a_partition) {
  const std::string types =
      "; only triangles (5), quads (9), tetrahedra (10), hexahedra (12), wedges (13) and pyramids "
      "(14) are read";
  const std::vector<WrongFile> table = {
      {number("NumberOfPoints", 0, -1), "a partition has a wrong number of points or cells"},
      {number("NumberOfCells", 1, -1), "a partition has a wrong number of points or cells"},
      {number("NumberOfConnectivityIds", 1, -8),
       "a partition has a wrong number of points or cells"},
      {number("NumberOfPoints", 1, std::int64_t{1} << 31U),
       "a partition has a wrong number of points or cells"},
      {number("NumberOfPoints", 1, 5), "VTKHDF/Points ends too early"},
      {number("NumberOfConnectivityIds", 1, 20), "VTKHDF/Connectivity ends too early"},
      {number("NumberOfConnectivityIds", 1, 10), "the offset of a cell is wrong"},
      {number("Types", 0, 1), "a cell of type 1" + types},
      {number("Types", 0, 14), "the offset of a cell is wrong"},
      {number("Offsets", 0, -4), "the offset of a cell is wrong"},
      {number("Offsets", 1, 5), "the offset of a cell is wrong"},
      {number("Connectivity", 0, 5), "a cell has a node that does not exist"},
      {number("Connectivity", 0, -1), "a cell has a node that does not exist"},
      {number("CellData/region", 0, 0), "a cell has the region 0"},
      {number("CellData/region", 9, 1'000'001), "a cell has the region 1000001"},
      {without("VTKHDF/PointData/GlobalNodeId"),
       "has several partitions, but no GlobalNodeId to join them by"},
      {without("VTKHDF/Types"), "no array VTKHDF/Types"},
      {without("VTKHDF/Offsets"), "no array VTKHDF/Offsets"},
      {without("VTKHDF/Connectivity"), "no array VTKHDF/Connectivity"},
      {without("VTKHDF/Points"), "no array VTKHDF/Points"},
      {without("VTKHDF/NumberOfCells"), "no array VTKHDF/NumberOfCells"},
      {without("VTKHDF"), "is not a VTKHDF file of type UnstructuredGrid"},
      {[](const std::string& path) {
         replace_in_hdf5<std::int64_t>(path, "VTKHDF/NumberOfCells", {8});
       },
       "the numbers of points and of cells have different numbers of partitions"},
      {[](const std::string& path) {
         replace_in_hdf5<std::int64_t>(path, "VTKHDF/NumberOfConnectivityIds", {8, 9, 10});
       },
       "the numbers of points and of cells have different numbers of partitions"}};
  for (const WrongFile& wrong : table) {
    EXPECT_EQ(read_after(TetsMesh(), wrong.edit, opened), "a.vtkhdf: " + wrong.message);
  }
}

TEST(ReadVtkhdf, takes_one_region_and_one_patch_where_the_file_says_nothing_of_them) {
  const auto edit = [](const std::string& path) {
    for (const char* name : {"VTKHDF/CellData/region", "VTKHDF/CellData/patch",
                             "Tetfarm/patch_names", "Tetfarm/region_names"}) {
      remove_from_hdf5(path, name);
    }
  };
  EveryKindMesh mesh;
  mesh.parts.resize(2);
  std::string expected = "sub-domains\n";
  for (NumberedPart part : mesh.parts) {
    part.region = 1;
    part.region_of_tet.clear();
    part.region_of_face.clear();
    std::fill(part.patch_of_face.begin(), part.patch_of_face.end(), 0);
    for_each_block(part.blocks, [](ElementType, ElementBlock& block) {
      std::fill(block.regions.begin(), block.regions.end(), 1);
      std::fill(block.patches.begin(), block.patches.end(), 0);
    });
    expected += part_listing(part);
  }
  EXPECT_EQ(read_after(mesh, edit, opened), expected);
}

TEST(ReadVtkhdf, of_one_partition_needs_no_numbers_of_nodes) {
  TetsMesh mesh;
  mesh.parts.resize(1);
  const std::string whole = read_after(mesh, leave, opened);
  EXPECT_EQ(read_after(mesh, without("VTKHDF/PointData/GlobalNodeId"), opened), whole);
}

TEST(ReadVtkhdf, joins_partitions_to_one_mesh) {
  EXPECT_EQ(read_after(TetsMesh(), leave, joined),
            "nodes 0 1 10 100 111 -1.5\ntet 0 1 2 3\ntet 1 2 3 4\ntet 1 2 4 5\n"
            "sub-domains 0 0 1; regions 1 2 2; patches 0 0 0 1 1 1 1 1; regions of triangles 1 1 1 "
            "2 2 2 2 2; low,high,water,air, 2 sub-domains, 6 on the boundary");
}

TEST(ReadVtkhdf, says_what_cannot_be_joined) {
  const std::vector<WrongFile> table = {
      {number("PointData/GlobalNodeId", 0, -1), "a GlobalNodeId is out of range"},
      {number("PointData/GlobalNodeId", 0, 9), "a GlobalNodeId is out of range"},
      {without("VTKHDF/PointData/GlobalNodeId"),
       "has several partitions, but no GlobalNodeId to join them by"}};
  for (const WrongFile& wrong : table) {
    EXPECT_EQ(read_after(TetsMesh(), wrong.edit, joined), "a.vtkhdf: " + wrong.message);
  }
  EXPECT_EQ(read_after(EveryKindMesh(), leave, joined),
            "a.vtkhdf: has cells other than tets and triangles");
}

/// So many of the same tet, so that its cells are read in blocks; the last is of another region.
class ManyTets : public MeshSource {
 public:
  explicit ManyTets(std::size_t tets) {
    part_.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    part_.local2global = {0, 1, 2, 3};
    part_.tets.assign(tets, {0, 1, 2, 3});
    part_.tets.back() = {1, 2, 0, 3};
    part_.region_of_tet.assign(tets, 1);
    part_.region_of_tet.back() = 2;
    part_.faces = {{0, 2, 1}, {0, 1, 3}};
    part_.patch_of_face = {1, 0};
    part_.region_of_face = {1, 2};
  }
  std::size_t size() const override { return 1; }
  NumberedPart part(std::size_t) const override { return part_; }
  std::vector<std::string> patch_names() const override { return {}; }
  std::vector<std::string> region_names() const override { return {}; }

 private:
  NumberedPart part_;
};

TEST(ReadVtkhdf, reads_cells_of_more_than_a_block) {
  constexpr std::size_t block = 16384;
  for (const std::size_t tets : {block - 1, block, block + 1}) {
    const TempFolder folder;
    const ManyTets mesh(tets);
    export_mesh(mesh, find_mesh_format("vtkhdf", ""), folder.path() / "a.vtkhdf");
    const NumberedPart read = VtkhdfParts(folder.path() / "a.vtkhdf").part(0);
    const NumberedPart written = mesh.part(0);
    EXPECT_EQ(read.tets, written.tets);
    EXPECT_EQ(read.region_of_tet, written.region_of_tet);
    EXPECT_EQ(read.faces, written.faces);
    EXPECT_EQ(read.patch_of_face, written.patch_of_face);
    EXPECT_EQ(read.region_of_face, written.region_of_face);
  }
}

TEST(ReadVtkhdf, counts_what_a_partition_has_without_reading_it) {
  const TempFolder folder;
  export_mesh(EveryKindMesh(), find_mesh_format("vtkhdf", ""), folder.path() / "a.vtkhdf");
  const VtkhdfParts parts(folder.path() / "a.vtkhdf");
  const CountedPart counted = parts.count(1);
  EXPECT_EQ(counted.tets, 1);
  EXPECT_EQ(counted.faces, 10);
  EXPECT_TRUE(counted.part.tets.empty());
  EXPECT_TRUE(counted.part.blocks[ElementType::pyramid].nodes.empty());
  EXPECT_EQ(counted.part.blocks[ElementType::pyramid].regions, (std::vector<std::int32_t>{2, 3}));
  EXPECT_EQ(counted.part.nodes, parts.part(1).nodes);
  EXPECT_EQ(counted.part.patch_of_face, parts.part(1).patch_of_face);
}

TEST(ReadVtkhdf, gives_back_the_marks_of_cells_and_the_feet_of_nodes) {
  const TempFolder folder;
  const MarkedGrid grid;
  const std::string path = folder.path() / "a.vtkhdf";
  export_mesh(grid, find_mesh_format("", path), path);
  const auto read = open_mesh(path);
  EXPECT_EQ(read->cell_marks(), grid.cell_marks());
  EXPECT_TRUE(read->has_feet());
  ASSERT_EQ(read->size(), grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    EXPECT_EQ(read->part(i).marks, grid.parts[i].marks);
    EXPECT_EQ(read->part(i).feet, grid.parts[i].feet);
  }
}

TEST(ReadVtkhdf, an_array_of_another_program_that_is_called_like_a_mark_is_none) {
  const TempFolder folder;
  const std::string path = folder.path() / "a.vtkhdf";
  export_mesh(MarkedGrid(), find_mesh_format("", path), path);
  remove_from_hdf5(path, "Tetfarm");
  const auto read = open_mesh(path);
  EXPECT_TRUE(read->cell_marks().empty());
  EXPECT_TRUE(read->part(0).marks.empty());
  EXPECT_FALSE(read->has_feet());
  EXPECT_TRUE(read->part(0).feet.empty());
}

TEST(ReadVtkhdf, knows_no_feet_where_one_of_their_arrays_or_the_numbers_of_nodes_are_missing) {
  for (const char* array : {"foot", "depth"}) {
    const TempFolder folder;
    const std::string path = folder.path() / "a.vtkhdf";
    export_mesh(MarkedGrid(), find_mesh_format("", path), path);
    remove_from_hdf5(path, std::string("VTKHDF/PointData/") + array);
    EXPECT_FALSE(open_mesh(path)->has_feet());
    EXPECT_TRUE(open_mesh(path)->part(0).feet.empty());
  }
}

TEST(ReadVtkhdf, nodes_of_a_part_without_feet_have_none_beside_those_with) {
  const TempFolder folder;
  MarkedGrid grid;
  grid.parts[1].feet = {};
  const std::string path = folder.path() / "a.vtkhdf";
  export_mesh(grid, find_mesh_format("", path), path);
  const auto read = open_mesh(path);
  EXPECT_EQ(read->part(0).feet, grid.parts[0].feet);
  const std::size_t nodes = grid.parts[1].nodes.size();
  EXPECT_EQ(read->part(1).feet.foot, (std::vector<std::int64_t>(nodes, no_foot)));
  EXPECT_EQ(read->part(1).feet.depth, (std::vector<std::int32_t>(nodes, no_foot)));
}

}  // namespace
}  // namespace tetfarm
