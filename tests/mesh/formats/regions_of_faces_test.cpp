#include "mesh/formats/regions_of_faces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Two tets on a face and a pyramid apart; among the boundary faces the one between the tets once
/// for each, one that no cell has, and the base of the pyramid.
NumberedPart part_of_regions(std::vector<std::int32_t> tets, std::int32_t pyramid) {
  NumberedPart part;
  part.region = 9;
  part.nodes.resize(10);
  part.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  part.region_of_tet = std::move(tets);
  part.faces = {{1, 2, 3}, {2, 1, 0}, {0, 1, 2}, {7, 8, 9}, {2, 1, 4}};
  part.patch_of_face = {0, 0, 0, 0, 0};
  ElementBlock& pyramids = part.blocks[ElementType::pyramid];
  pyramids.nodes = {5, 6, 7, 8, 9};
  pyramids.regions = {pyramid};
  ElementBlock& quads = part.blocks[ElementType::quad];
  quads.nodes = {8, 7, 6, 5};
  quads.regions = {9};
  quads.patches = {0};
  return part;
}

TEST(RegionsOfFaces, are_those_of_the_cells_that_have_them_turned_the_same_way) {
  NumberedPart part = part_of_regions({1, 2}, 3);
  set_regions_of_faces(part);
  EXPECT_THAT(part.region_of_face, ElementsAre(1, 1, 2, 3, 2));
  EXPECT_THAT(part.blocks[ElementType::quad].regions, ElementsAre(3));
}

TEST(RegionsOfFaces, of_faces_that_no_cell_has_are_the_part_s) {
  NumberedPart part = part_of_regions({1, 2}, 3);
  part.faces[0] = {1, 3, 2};
  part.blocks[ElementType::quad].nodes = {5, 6, 7, 8};
  set_regions_of_faces(part);
  EXPECT_THAT(part.region_of_face, ElementsAre(9, 1, 2, 3, 2));
  EXPECT_THAT(part.blocks[ElementType::quad].regions, ElementsAre(9));
}

TEST(RegionsOfFaces, of_a_part_of_one_region_are_said_once) {
  NumberedPart part = part_of_regions({4, 4}, 4);
  set_regions_from_cells(part);
  EXPECT_EQ(part.region, 4);
  EXPECT_THAT(part.region_of_tet, IsEmpty());
  EXPECT_THAT(part.region_of_face, IsEmpty());
  EXPECT_THAT(part.blocks[ElementType::quad].regions, ElementsAre(4));
}

TEST(RegionsOfFaces, of_a_part_of_several_regions_are_told_of_each) {
  for (const std::int32_t pyramid : {4, 5}) {
    NumberedPart part = part_of_regions({4, pyramid == 4 ? 5 : 4}, pyramid);
    set_regions_from_cells(part);
    EXPECT_EQ(part.region, 4);
    EXPECT_EQ(part.region_of_tet.size(), 2U);
    EXPECT_EQ(part.region_of_face.size(), 5U);
    EXPECT_THAT(part.blocks[ElementType::quad].regions, ElementsAre(pyramid));
  }
  NumberedPart none;
  none.region = 7;
  set_regions_from_cells(none);
  EXPECT_EQ(none.region, 7);
}

}  // namespace
}  // namespace tetfarm
