#include "mesh/render/part_faces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/hybrid_mesh.h"

namespace tetfarm {
namespace {

/// "nodes/patch/region", one after the other.
std::string text_of_faces(const std::vector<ShownFace>& faces) {
  std::string text;
  for (const ShownFace& face : faces) {
    for (const std::int32_t v : face.nodes) text += std::to_string(v) + " ";
    text += "/" + std::to_string(face.patch) + "/" + std::to_string(face.region) + "; ";
  }
  return text;
}

/// A tet on a triangle of a pyramid, of another region.
NumberedPart tet_and_pyramid() {
  NumberedPart part;
  part.region = 2;
  part.nodes.resize(6);
  part.tets = {{1, 2, 4, 5}};
  part.faces = {{2, 5, 4}};
  part.patch_of_face = {7};
  ElementBlock& pyramids = part.blocks[ElementType::pyramid];
  pyramids.nodes = {1, 2, 3, 0, 4};
  pyramids.regions = {3};
  ElementBlock& quads = part.blocks[ElementType::quad];
  quads.nodes = {2, 1, 0, 3};
  quads.regions = {3};
  quads.patches = {8};
  return part;
}

TEST(PartFacesOfSurface, are_its_triangles_and_the_halves_of_its_quads) {
  EXPECT_EQ(text_of_faces(surface_faces(tet_and_pyramid())),
            "2 5 4 /7/2; 0 3 2 /8/3; 0 2 1 /8/3; ");
  NumberedPart part = tet_and_pyramid();
  part.region_of_face = {9};
  EXPECT_EQ(text_of_faces(surface_faces(part)).substr(0, 10), "2 5 4 /7/9");
}

TEST(PartFacesOfCells, are_those_that_one_of_the_kept_has) {
  EXPECT_EQ(text_of_faces(outer_faces(tet_and_pyramid(), {true, true})),
            "0 1 2 /8/3; 0 1 4 /-1/3; 0 2 3 /8/3; 0 3 4 /-1/3; 1 2 5 /-1/2; 1 4 5 /-1/2; "
            "2 3 4 /-1/3; 2 4 5 /7/2; ");
  EXPECT_EQ(text_of_faces(outer_faces(tet_and_pyramid(), {true, false})),
            "1 2 4 /-1/2; 1 2 5 /-1/2; 1 4 5 /-1/2; 2 4 5 /7/2; ");
  EXPECT_EQ(text_of_faces(outer_faces(tet_and_pyramid(), {false, true})),
            "0 1 2 /8/3; 0 1 4 /-1/3; 0 2 3 /8/3; 0 3 4 /-1/3; 1 2 4 /-1/3; 2 3 4 /-1/3; ");
  EXPECT_EQ(text_of_faces(outer_faces(tet_and_pyramid(), {false, false})), "");
}

TEST(PartFacesOfCells, of_two_that_share_a_quad_are_cut_at_the_same_node_from_both_sides) {
  const NumberedPart part = HybridMesh().parts[0];  // a prism, two hexes
  const auto count = [&](std::vector<bool> kept) { return outer_faces(part, kept).size(); };
  EXPECT_EQ(count({true, true, true}), 4U * 2 + 4 * 2 + 2 + 2 * 2 + 2);
  EXPECT_EQ(count({true, false, false}), 2U + 3 * 2);
  EXPECT_EQ(count({false, true, true}), 10U * 2);
}

}  // namespace
}  // namespace tetfarm
