#include "mesh/core/elements.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "mesh/core/signed_volume.h"

namespace tetfarm {
namespace {

using enum ElementType;
using testing::ElementsAre;

std::vector<ElementType> cells() { return {tet, pyramid, prism, hex}; }

/// An element with edges of length 1, in our order.
std::vector<Vec3> regular(ElementType type) {
  const double h = std::sqrt(0.75);
  switch (type) {
    case tet:
      return {{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0.5, h / 3, std::sqrt(2.0 / 3)}};
    case pyramid:
      return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, std::sqrt(0.5)}};
    case prism:
      return {{0, 0, 0}, {1, 0, 0}, {0.5, h, 0}, {0, 0, 1}, {1, 0, 1}, {0.5, h, 1}};
    default:
      return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
              {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  }
}

TEST(Elements, of_three_dimensions_have_faces_that_close) {
  for (const ElementType type : cells()) {
    std::map<std::pair<int, int>, int> steps;
    std::set<int> nodes;
    for (const ElementFace& face : element(type).faces) {
      const std::size_t count = nodes_of(face.type);
      for (std::size_t k = 0; k < count; ++k) {
        ++steps[{face.nodes[k], face.nodes[(k + 1) % count]}];
        nodes.insert(face.nodes[k]);
      }
    }
    EXPECT_EQ(nodes.size(), nodes_of(type)) << element(type).name;
    for (const auto& [step, times] : steps) {
      EXPECT_EQ(times, 1) << element(type).name;
      EXPECT_EQ(steps.count({step.second, step.first}), 1U) << element(type).name;
    }
  }
}

TEST(Elements, have_the_edges_of_their_faces_and_no_others) {
  for (const ElementType type : cells()) {
    std::set<std::pair<int, int>> of_faces;
    for (const ElementFace& face : element(type).faces) {
      const std::size_t count = nodes_of(face.type);
      for (std::size_t k = 0; k < count; ++k) {
        of_faces.insert(std::minmax<int>(face.nodes[k], face.nodes[(k + 1) % count]));
      }
    }
    std::set<std::pair<int, int>> edges;
    for (const auto& [a, b] : element(type).edges) edges.insert(std::minmax<int>(a, b));
    EXPECT_EQ(edges, of_faces) << element(type).name;
    EXPECT_EQ(edges.size(), element(type).edges.size()) << element(type).name;
    EXPECT_EQ(nodes_of(type) + element(type).faces.size(), edges.size() + 2) << "Euler";
  }
}

TEST(Elements, have_the_volume_that_formulas_give) {
  EXPECT_NEAR(static_cast<double>(element_volume(tet, regular(tet))), std::sqrt(2.0) / 12, 1e-15);
  EXPECT_NEAR(static_cast<double>(element_volume(pyramid, regular(pyramid))), std::sqrt(2.0) / 6,
              1e-15);
  EXPECT_NEAR(static_cast<double>(element_volume(prism, regular(prism))), std::sqrt(3.0) / 4,
              1e-15);
  EXPECT_NEAR(static_cast<double>(element_volume(hex, regular(hex))), 1, 1e-15);
}

TEST(Elements, a_mirror_turns_the_sign_of_the_volume) {
  for (const ElementType type : cells()) {
    std::vector<Vec3> nodes = regular(type);
    const long double volume = element_volume(type, nodes);
    for (Vec3& p : nodes) p.x = -p.x;
    EXPECT_NEAR(static_cast<double>(element_volume(type, nodes)), static_cast<double>(-volume),
                1e-15);
  }
}

TEST(Elements, a_bent_quad_bounds_the_same_volume_from_either_side_and_from_any_corner) {
  const Vec3 origin = {0.3, -0.2, -1};
  std::vector<Vec3> face = {{0, 0, 0}, {1, 0, 0.25}, {1, 1, -0.5}, {0, 1, 0.125}};
  const long double volume = cone_volume(origin, face);
  EXPECT_GT(volume, 0);
  std::rotate(face.begin(), face.begin() + 1, face.end());
  EXPECT_NEAR(static_cast<double>(cone_volume(origin, face) - volume), 0, 1e-17);
  std::reverse(face.begin(), face.end());
  EXPECT_NEAR(static_cast<double>(cone_volume(origin, face) + volume), 0, 1e-17);
}

TEST(Elements, regular_ones_have_the_scaled_jacobian_1) {
  for (const ElementType type : cells()) {
    EXPECT_NEAR(scaled_jacobian(type, regular(type)), 1, 1e-15) << element(type).name;
  }
}

TEST(Elements, the_scaled_jacobian_tells_a_corner_that_is_turned_in) {
  std::vector<Vec3> nodes = regular(hex);
  nodes[6] = {0.3, 0.3, 0.3};
  EXPECT_GT(element_volume(hex, nodes), 0);
  EXPECT_LT(scaled_jacobian(hex, nodes), 0);
}

TEST(Elements, every_type_of_a_numbering_is_found_by_its_code) {
  for (const auto codes : {ElementCodes::vtk, ElementCodes::cgns, ElementCodes::msh,
                           ElementCodes::medit, ElementCodes::ugrid}) {
    for (const ElementType type : all_element_types) {
      EXPECT_EQ(type_of(codes, code_of(codes, type)), type);
    }
    EXPECT_EQ(type_of(codes, 0), std::nullopt) << "stands for none";
    EXPECT_EQ(type_of(codes, 1000), std::nullopt);
  }
}

TEST(Elements, orders_of_nodes_are_undone_on_the_way_back) {
  for (const auto codes : {ElementCodes::vtk, ElementCodes::cgns, ElementCodes::ugrid}) {
    for (const ElementType type : all_element_types) {
      const std::vector<int> ours = {10, 11, 12, 13, 14, 15, 16, 17};
      const std::span<const int> nodes(ours.data(), nodes_of(type));
      std::vector<std::int64_t> theirs(nodes.size());
      put_in_order_of(codes, type, nodes, std::span(theirs));
      std::vector<int> back(nodes.size());
      take_from_order_of(codes, type, std::span<const std::int64_t>(theirs), std::span(back));
      EXPECT_THAT(back, testing::ElementsAreArray(nodes)) << element(type).name;
    }
  }
}

/// What the formats' documents say of the two that are not everybody's.
TEST(Elements, the_wedge_of_vtk_and_the_pyramid_of_ugrid_are_turned) {
  const std::vector<Vec3> wedge = regular(prism);
  std::vector<Vec3> vtk(6);
  for (std::size_t k = 0; k < 6; ++k) vtk[k] = wedge[node_order(ElementCodes::vtk, prism)[k]];
  EXPECT_LT(dot(cross(vtk[1] - vtk[0], vtk[2] - vtk[0]), vtk[3] - vtk[0]), 0);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(vtk[k].x, vtk[k + 3].x);
  const std::vector<Vec3> ours = regular(pyramid);
  std::vector<Vec3> ugrid(5);
  for (std::size_t k = 0; k < 5; ++k) ugrid[k] = ours[node_order(ElementCodes::ugrid, pyramid)[k]];
  EXPECT_EQ(ugrid[2].z, ours[4].z) << "its third node is the apex";
  const auto base = [&](std::size_t k) { return ugrid[std::array{0, 3, 4, 1}[k]]; };
  EXPECT_GT(signed_volume(base(0), base(1), base(2), ugrid[2]), 0);
  EXPECT_GT(signed_volume(base(0), base(2), base(3), ugrid[2]), 0);
}

TEST(Elements, are_counted_in_words) {
  EXPECT_EQ(text_of_count(1, pyramid), "1 pyramid");
  EXPECT_EQ(text_of_count(3, hex), "3 hexes");
}

}  // namespace
}  // namespace tetfarm
