#include "mesh/formats/cgns/cgns_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "mesh/formats/registry/export_mesh.h"
#include "tests/mesh/formats/grid_source.h"
#include "tests/mesh/formats/refusal.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

TEST(CgnsSource, an_hdf5_file_of_something_else_is_refused) {
  const TempFolder folder;
  export_mesh(GridSource(cut_grid(3)), find_mesh_format("vtkhdf", ""), folder.path() / "a.vtkhdf");
  EXPECT_THAT(refusal_of("a.cgns", read_file(folder.path() / "a.vtkhdf")), HasSubstr("Base/Zone1"));
  EXPECT_THAT(refusal_of("a.cgns", "no HDF5"), HasSubstr("a.cgns"));
}

TEST(CgnsSource, patches_are_in_their_order_and_subdomains_known) {
  const TempFolder folder;
  GridSource grid(cut_grid(4));
  grid.parts[1].region = 2;
  export_mesh(grid, find_mesh_format("cgns", ""), folder.path() / "a.cgns");
  const auto read = open_mesh(folder.path() / "a.cgns");
  EXPECT_THAT(read->patch_names(), testing::ElementsAre("low_x", "elsewhere"));
  EXPECT_TRUE(read->knows_subdomains());
  ASSERT_EQ(read->size(), 3U);
  EXPECT_EQ(read->part(1).region, 2);
}

TEST(CgnsSource, refuses_a_node_that_is_not_there) {
  const TempFolder folder;
  export_mesh(GridSource(cut_grid(3)), find_mesh_format("cgns", ""), folder.path() / "a.cgns");
  std::string bytes = read_file(folder.path() / "a.cgns");
  // The nodes of the first tet, from 1 and with 8 bytes each: made 4 thousand million.
  const NumberedPart first = GridSource(cut_grid(3)).part(0);
  std::string wanted;
  for (const std::int32_t v : first.tets[0]) {
    const std::int64_t number = first.local2global[static_cast<std::size_t>(v)] + 1;
    wanted.append(reinterpret_cast<const char*>(&number), 8);
  }
  const std::size_t place = bytes.find(wanted);
  ASSERT_NE(place, bytes.npos);
  bytes[place + 4] = 1;
  EXPECT_THAT(refusal_of("a.cgns", bytes), HasSubstr("tet 0 has node"));
}

// Some of these end the HDF5 library by a signal.
TEST(CgnsSource, a_damaged_byte_of_the_structure_ends_in_a_refusal_or_a_mesh) {
  const TempFolder folder;
  export_mesh(GridSource(cut_grid(3)), find_mesh_format("cgns", ""), folder.path() / "a.cgns");
  const std::string bytes = read_file(folder.path() / "a.cgns");
  std::mt19937 random(1);
  int refused = 0;
  for (int i = 0; i < 150; ++i) {
    std::string damaged = bytes;
    for (int k = 0; k < 8; ++k) damaged[random() % damaged.size()] = static_cast<char>(random());
    EXPECT_NO_THROW(refused += !refusal_of("a.cgns", damaged).empty());
  }
  EXPECT_GT(refused, 100) << "eight wrong bytes hardly ever leave a mesh";
}

}  // namespace
}  // namespace tetfarm
