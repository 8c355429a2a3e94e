#include "mesh/formats/openfoam/seam_faces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "base/error.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/grid_source.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(CellFaces, every_face_of_a_tet_is_inner_twice_or_outer_once) {
  const GridSource grid(cut_grid(4));
  for (const NumberedPart& part : grid.parts) {
    const CellFaces faces = cell_faces(part);
    EXPECT_EQ(2 * faces.inner.size() + faces.outer.size(), 4 * part.tets.size());
    std::set<std::int32_t> boundary;
    for (const OuterFace& face : faces.outer) {
      if (face.face >= 0) boundary.insert(face.face);
    }
    EXPECT_EQ(boundary.size(), part.faces.size());
    for (const InnerFace& face : faces.inner) EXPECT_LT(face.owner, face.neighbour);
  }
}

TEST(CellFaces, refuses_a_boundary_triangle_inside) {
  GridSource grid(cut_grid(4));
  NumberedPart& part = grid.parts[0];
  std::ranges::copy(cell_faces(part).inner[0].nodes, part.faces[0].begin());
  EXPECT_THROW(cell_faces(part), InvalidInput);
}

TEST(CellFaces, refuses_a_face_of_three_tets) {
  NumberedPart part;
  part.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 2}};
  part.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  EXPECT_EQ(cell_faces(part).inner.size(), 1U);
  part.tets.push_back({0, 1, 2, 5});
  EXPECT_THAT([&] { cell_faces(part); },
              ThrowsMessage<InvalidInput>(HasSubstr("a face has more than two cells")));
}

TEST(SeamFaces, both_sides_have_the_same_faces_in_the_same_order_turned_round) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  SeamFaces seams(grid, outline_of(grid), folder.path());
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<SeamFace>> lists;
  for (std::int32_t part = 0; part < 3; ++part) {
    for (const SeamFace& seam : seams.next_part()) {
      EXPECT_EQ(seam.part, part);
      lists[{part, seam.neighbour}].push_back(seam);
    }
  }
  EXPECT_EQ(lists.size(), 6u);
  std::size_t faces = 0;
  for (const auto& [pair, list] : lists) {
    const auto& back = lists.at({pair.second, pair.first});
    ASSERT_EQ(list.size(), back.size());
    faces += list.size();
    for (std::size_t i = 0; i < list.size(); ++i) {
      EXPECT_EQ(list[i].nodes, back[i].nodes.turned());
      EXPECT_EQ(list[i].cell, back[i].neighbour_cell);
    }
  }
  // A cut through all 4 x 4 cubes, and one through 4 x 2.
  EXPECT_EQ(faces, 2u * 2u * (16 + 8));
  EXPECT_EQ(seams.between_regions(), 0);
}

TEST(SeamFaces, triangles_between_regions_are_shared_too) {
  const TempFolder folder;
  GridSource grid(cut_grid(4));
  // The first part becomes a region of its own: its cut has triangles of the surface on both sides.
  SeamFaces cut(grid, outline_of(grid), folder.path());
  for (std::int32_t part = 0; part < 3; ++part) {
    NumberedPart& here = grid.parts[static_cast<std::size_t>(part)];
    for (const SeamFace& seam : cut.next_part()) {
      if (seam.part != 0 && seam.neighbour != 0) continue;
      Triangle local;
      for (std::size_t k = 0; k < 3; ++k) {
        local[k] = static_cast<std::int32_t>(
            std::find(here.local2global.begin(), here.local2global.end(), seam.nodes[k]) -
            here.local2global.begin());
      }
      here.faces.push_back(local);
      here.patch_of_face.push_back(0);
    }
    here.region = part == 0 ? 1 : 2;
  }
  SeamFaces seams(grid, outline_of(grid), folder.path());
  EXPECT_EQ(seams.between_regions(), 2 * 2 * 16);
  EXPECT_EQ(
      seams.faces_of_patch()[0][0] + seams.faces_of_patch()[1][0] + seams.faces_of_patch()[2][0],
      32);
}

TEST(SeamFaces, refuses_a_face_that_lies_twice_in_one_part) {
  const TempFolder folder;
  GridSource grid(cut_grid(3));
  NumberedPart& part = grid.parts[0];
  // Two tets whose common nodes have two places in the part: it falls apart there.
  part.local2global = {0, 1, 2, 3, 0, 2, 1, 4};
  part.nodes.resize(8);
  part.tets = {{0, 1, 2, 3}, {4, 5, 6, 7}};
  part.faces.clear();
  part.patch_of_face.clear();
  grid.parts.resize(1);
  EXPECT_THAT([&] { SeamFaces(grid, outline_of(grid), folder.path()); },
              ThrowsMessage<InvalidInput>(HasSubstr("a face occurs twice in one sub-domain")));
}

TEST(SeamFaces, refuses_a_hole) {
  const TempFolder folder;
  GridSource grid(cut_grid(4));
  grid.parts[1].faces.pop_back();
  grid.parts[1].patch_of_face.pop_back();
  EXPECT_THROW(SeamFaces(grid, outline_of(grid), folder.path()), InvalidInput);
}

}  // namespace
}  // namespace tetfarm
