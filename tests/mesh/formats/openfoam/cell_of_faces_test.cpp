#include "mesh/formats/openfoam/cell_of_faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "mesh/core/element_block.h"
#include "mesh/core/surface_mesh.h"

namespace tetfarm {
namespace {

using Face = FaceNodes<std::int32_t>;

std::vector<Face> faces_of(ElementType type, std::span<const std::int32_t> nodes) {
  std::vector<Face> faces;
  for_each_face_of(type, nodes, [&](ElementType, std::span<const std::int32_t> face) {
    faces.emplace_back(face);
  });
  return faces;
}

std::vector<Face> sorted_faces(std::vector<Face> faces) {
  for (Face& face : faces) face = face.smallest_first();
  std::sort(faces.begin(), faces.end());
  return faces;
}

constexpr std::array cells = {ElementType::tet, ElementType::pyramid, ElementType::prism,
                              ElementType::hex};

std::vector<std::int32_t> first_nodes(ElementType type) {
  std::vector<std::int32_t> nodes(nodes_of(type));
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}

TEST(CellOfFaces, has_the_same_faces_in_whatever_order_they_come_and_begin) {
  std::mt19937 random(9);
  for (const ElementType type : cells) {
    for (int i = 0; i < 100; ++i) {
      std::vector<std::int32_t> nodes(20);
      std::iota(nodes.begin(), nodes.end(), 100);
      std::shuffle(nodes.begin(), nodes.end(), random);
      nodes.resize(nodes_of(type));
      std::vector<Face> faces = faces_of(type, nodes);
      std::shuffle(faces.begin(), faces.end(), random);
      for (Face& face : faces) {
        const auto turns = static_cast<std::ptrdiff_t>(random() % face.size());
        std::rotate(face.begin(), face.begin() + turns, face.end());
      }
      const auto cell = cell_of_faces(faces);
      ASSERT_TRUE(cell.has_value());
      EXPECT_EQ(cell->type, type);
      EXPECT_EQ(sorted_faces(faces_of(type, cell->all_nodes())), sorted_faces(faces));
    }
  }
}

TEST(CellOfFaces, begins_as_the_first_face_that_can_be_the_first_of_its_type_does) {
  for (const ElementType type : cells) {
    const std::vector<std::int32_t> nodes = first_nodes(type);
    const auto cell = cell_of_faces(faces_of(type, nodes));
    ASSERT_TRUE(cell.has_value());
    EXPECT_TRUE(std::ranges::equal(cell->all_nodes(), nodes));
  }
}

TEST(CellOfFaces, is_nothing_when_a_face_is_turned) {
  for (const ElementType type : cells) {
    const std::vector<Face> faces = faces_of(type, first_nodes(type));
    for (std::size_t i = 0; i < faces.size(); ++i) {
      std::vector<Face> turned = faces;
      turned[i] = turned[i].turned();
      EXPECT_FALSE(cell_of_faces(turned).has_value());
      EXPECT_TRUE(has_faces_of_a_cell(turned));
    }
  }
}

TEST(CellOfFaces, is_nothing_when_faces_do_not_close_or_two_nodes_are_one) {
  for (const ElementType type : cells) {
    const std::vector<std::int32_t> nodes = first_nodes(type);
    const std::vector<Face> faces = faces_of(type, nodes);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      std::vector<Face> open = faces;
      open[i].set(0, 50);
      EXPECT_FALSE(cell_of_faces(open).has_value());
    }
    for (std::size_t a = 0; a < nodes.size(); ++a) {
      for (std::size_t b = a + 1; b < nodes.size(); ++b) {
        std::vector<std::int32_t> merged = nodes;
        merged[b] = merged[a];
        EXPECT_FALSE(cell_of_faces(faces_of(type, merged)).has_value()) << a << " " << b;
      }
    }
  }
}

TEST(CellOfFaces, of_other_polyhedra_is_nothing) {
  const std::vector<std::int32_t> nodes = first_nodes(ElementType::hex);
  std::vector<Face> faces = faces_of(ElementType::hex, nodes);
  faces.pop_back();
  EXPECT_FALSE(cell_of_faces(faces).has_value());
  EXPECT_FALSE(has_faces_of_a_cell(faces));
  EXPECT_FALSE(cell_of_faces({}).has_value());
  EXPECT_FALSE(has_faces_of_a_cell({}));
  // Two tets that share a face, without it.
  std::vector<Face> double_tet;
  for (const Triangle& face : {Triangle{0, 1, 3}, Triangle{1, 2, 3}, Triangle{2, 0, 3},
                               Triangle{1, 0, 4}, Triangle{2, 1, 4}, Triangle{0, 2, 4}}) {
    double_tet.emplace_back(face);
  }
  EXPECT_FALSE(cell_of_faces(double_tet).has_value());
  EXPECT_FALSE(has_faces_of_a_cell(double_tet));
}

TEST(CellOfFaces, names_what_it_knows) {
  EXPECT_EQ(names_of_cells(), "tet, pyramid, prism or hex");
}

}  // namespace
}  // namespace tetfarm
