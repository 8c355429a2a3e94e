// CGNS files of other programs, and wrong ones.
#include <gtest/gtest.h>

#include <functional>

#include "base/error.h"
#include "mesh/formats/cgns/cgns_source.h"
#include "mesh/formats/registry/export_mesh.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/every_kind_mesh.h"
#include "tests/mesh/formats/hdf5_edit.h"
#include "tests/mesh/formats/mesh_listing.h"

namespace tetfarm {
namespace {

using Edit = std::function<void(const std::string& path)>;

/// What is read of the mesh once its file was edited, or said of it.
std::string read_after(const MeshSource& mesh, const Edit& edit) {
  const TempFolder folder;
  const std::string path = folder.path() / "a.cgns";
  export_mesh(mesh, find_mesh_format("cgns", ""), path);
  edit(path);
  try {
    return mesh_listing(*open_cgns(path, {}));
  } catch (const InvalidInput& error) {
    const std::string message = error.what();
    return message.substr(message.find("/a.cgns") + 1);
  }
}

Edit number(const std::string& node, std::size_t index, std::int64_t value) {
  return [=](const std::string& path) {
    set_hdf5_number(path, "Base/Zone1" + node + "/ data", index, value);
  };
}
Edit without(const std::string& node) {
  return [=](const std::string& path) { remove_from_hdf5(path, "Base/Zone1" + node); };
}

struct WrongFile {
  Edit edit;
  std::string message;
};

TEST(CgnsRefusals, say_what_is_missing_or_unfit) {
  const std::string zone = "Base/Zone1/";
  const std::vector<WrongFile> table = {
      {without(""), "is not a CGNS file with the zone Base/Zone1"},
      {without("/ data"), "the zone has no size"},
      {number("", 0, -1), "the zone has no size"},
      {number("", 1, -1), "the zone has no size"},
      {number("", 0, 7), zone + "GridCoordinates/CoordinateX/ data ends too early"},
      {number("", 1, 4), "does not have one section with all tets"},
      {number("", 1, 2), "does not have one section with all tets"},
      {without("/GridCoordinates/CoordinateY"),
       "no array " + zone + "GridCoordinates/CoordinateY/ data"},
      {without("/GridElements"), "has no section of tets"},
      {number("/GridElements", 0, 99),
       "the section GridElements has elements that are not supported"},
      {number("/GridElements", 0, 12),
       zone + "GridElements/ElementConnectivity/ data ends too early"},
      {number("/GridElements/ElementRange", 0, 0), "the section GridElements has no type or range"},
      {number("/low/ElementRange", 1, 3), "the section low has no type or range"},
      {number("/low/ElementRange", 1, 9), zone + "low/ElementConnectivity/ data ends too early"},
      {without("/low/ElementRange"), "no array " + zone + "low/ElementRange/ data"},
      {number("/GridElements/ElementConnectivity", 3, 7), "tet 0 has node 6 of 6"},
      {number("/GridElements/ElementConnectivity", 3, 0), "tet 0 has node -1 of 6"},
      {number("/low/ElementConnectivity", 3, 7), "boundary triangle 1 has node 6 of 6"},
      {number("/CellData/Region", 2, 0), "a tet has the region 0"}};
  for (const WrongFile& wrong : table) {
    EXPECT_EQ(read_after(TetsMesh(), wrong.edit), "a.cgns: " + wrong.message);
  }
}

TEST(CgnsRefusals, are_of_a_second_section_of_one_type) {
  const auto pyramids_as_prisms = number("/GridPyramids", 0, 14);
  EXPECT_EQ(read_after(EveryKindMesh(), pyramids_as_prisms),
            "a.cgns: Base/Zone1/GridPyramids/ElementConnectivity/ data ends too early");
  EXPECT_EQ(read_after(EveryKindMesh(), number("/GridHexes", 0, 14)),
            "a.cgns: does not have one section with all prisms");
  EXPECT_EQ(read_after(EveryKindMesh(), number("/GridHexes", 0, 12)),
            "a.cgns: does not have one section with all pyramids");
  const Edit first = number("/GridElements/ElementRange", 0, 2);
  const Edit last = number("/GridElements/ElementRange", 1, 4);
  EXPECT_EQ(read_after(TetsMesh(),
                       [&](const auto& file) {
                         first(file);
                         last(file);
                       }),
            "a.cgns: does not have one section with all tets")
      << "behind the cells that there are";
}

TEST(CgnsRefusals, are_of_no_file_that_knows_neither_sub_domains_nor_regions) {
  const std::string text = read_after(TetsMesh(), without("/CellData"));
  EXPECT_EQ(text.substr(0, 53), "pieces\npatch \"low\"\npatch \"high\"\npart 0 region 1\n node");
  EXPECT_NE(text.find(" tet 0 1 2 3 region 1\n tet 1 2 3 4 region 1\n tet 1 2 4 5 region 1\n"),
            text.npos);
  EXPECT_EQ(text.find("part 1"), text.npos);
}

TEST(CgnsRefusals, are_of_no_file_that_knows_sub_domains_without_regions) {
  const std::string text = read_after(TetsMesh(), without("/CellData/Region"));
  EXPECT_EQ(text.substr(0, 12), "sub-domains\n");
  EXPECT_EQ(text.find("part 1"), text.npos) << "cells of no region are told of no sub-domain";
}

}  // namespace
}  // namespace tetfarm
