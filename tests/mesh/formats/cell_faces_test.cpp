#include "mesh/formats/cell_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "base/array_index.h"
#include "base/error.h"
#include "mesh/assemble/part_cells.h"
#include "tests/support/hybrid_grid.h"

namespace tetfarm {
namespace {

using Face = FaceNodes<std::int32_t>;

/// Of each face by its sorted nodes, the cells that have it and how it runs there.
std::map<Face, std::vector<std::pair<std::int32_t, Face>>> all_faces(const NumberedPart& part) {
  std::map<Face, std::vector<std::pair<std::int32_t, Face>>> faces;
  for_each_face_of_cells(part, [&](std::int32_t cell, const Face& face) {
    faces[face.sorted()].emplace_back(cell, face.smallest_first());
  });
  return faces;
}

TEST(CellFaces, are_all_faces_of_all_types_of_cells_once_with_those_who_have_them) {
  for (const NumberedPart& part : HybridGrid(4, 2, true).parts) {
    std::map<Face, std::int32_t> number_of_face;
    for_each_boundary_face(part, [&](std::int32_t number, const Face& face, std::int32_t) {
      number_of_face[face.smallest_first()] = number;
    });
    const auto expected = all_faces(part);
    const CellFaces faces = cell_faces(part);
    EXPECT_EQ(faces.inner.size() + faces.outer.size(), expected.size());
    for (const InnerFace& face : faces.inner) {
      const auto& owners = expected.at(face.nodes.sorted());
      ASSERT_EQ(owners.size(), 2U);
      EXPECT_LT(face.owner, face.neighbour);
      const std::size_t first = owners[0].first == face.owner ? 0 : 1;
      EXPECT_EQ(owners[first], std::pair(face.owner, face.nodes.smallest_first()));
      EXPECT_EQ(owners[1 - first], std::pair(face.neighbour, face.nodes.turned().smallest_first()));
    }
    std::size_t on_boundary = 0;
    for (const OuterFace& face : faces.outer) {
      const auto& owners = expected.at(face.nodes.sorted());
      ASSERT_EQ(owners.size(), 1U);
      EXPECT_EQ(owners[0], std::pair(face.owner, face.nodes.smallest_first()));
      const auto found = number_of_face.find(face.nodes.smallest_first());
      EXPECT_EQ(face.face, found == number_of_face.end() ? -1 : found->second);
      on_boundary += face.face >= 0 ? 1U : 0U;
    }
    EXPECT_EQ(on_boundary, number_of_face.size());
    EXPECT_TRUE(std::is_sorted(
        faces.inner.begin(), faces.inner.end(), [](const InnerFace& a, const InnerFace& b) {
          return std::pair(a.owner, a.neighbour) < std::pair(b.owner, b.neighbour);
        }));
    EXPECT_TRUE(
        std::is_sorted(faces.outer.begin(), faces.outer.end(),
                       [](const OuterFace& a, const OuterFace& b) { return a.owner < b.owner; }));
  }
}

/// Two tets with a face in common.
NumberedPart two_tets() {
  NumberedPart part;
  part.number = 7;
  part.nodes.resize(6);
  part.tets = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  return part;
}

NumberedPart with_faces(const std::vector<Triangle>& faces) {
  NumberedPart part = two_tets();
  part.faces = faces;
  part.patch_of_face.assign(faces.size(), 0);
  return part;
}

TEST(CellFaces, on_a_cut_have_no_number) {
  const CellFaces faces = cell_faces(with_faces({{0, 1, 3}}));
  ASSERT_EQ(faces.inner.size(), 1U);
  ASSERT_EQ(faces.outer.size(), 6U);
  EXPECT_EQ(std::count_if(faces.outer.begin(), faces.outer.end(),
                          [](const OuterFace& face) { return face.face == 0; }),
            1);
}

TEST(CellFaces, between_regions_are_boundary_faces_twice_or_not_at_all) {
  EXPECT_EQ(cell_faces(with_faces({{0, 1, 2}, {0, 2, 1}})).inner.size(), 1U);
  EXPECT_THROW(cell_faces(with_faces({{0, 1, 2}})), InvalidInput);
}

TEST(CellFaces, refuse_three_cells_at_one_and_a_boundary_face_that_no_cell_has) {
  NumberedPart part = two_tets();
  part.tets.push_back({0, 1, 2, 5});
  EXPECT_THROW(cell_faces(part), InvalidInput);
  EXPECT_THROW(cell_faces(with_faces({{0, 3, 4}})), InvalidInput);
}

}  // namespace
}  // namespace tetfarm
