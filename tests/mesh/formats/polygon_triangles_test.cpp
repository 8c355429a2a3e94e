#include "mesh/formats/polygon_triangles.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

#include "mesh/formats/medit/read_medit.h"
#include "mesh/formats/msh/read_msh.h"
#include "mesh/formats/obj/read_obj.h"
#include "mesh/formats/off/read_off.h"
#include "mesh/formats/ply/read_ply.h"
#include "mesh/formats/su2/read_su2.h"
#include "mesh/formats/tetgen/read_tetgen.h"
#include "mesh/formats/ugrid/read_ugrid_surface.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

/// A surface of vertices alone, in the plane z = 0.
SurfaceMesh corners_at(const std::vector<std::array<double, 2>>& places) {
  SurfaceMesh surface;
  for (const auto& [x, y] : places) surface.vertices.push_back({x, y, 0});
  return surface;
}

std::vector<std::int32_t> from_corner(std::size_t count, std::size_t first) {
  std::vector<std::int32_t> corners(count);
  std::iota(corners.begin(), corners.end(), 0);
  std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(first), corners.end());
  return corners;
}

std::vector<Vec3> area_vectors(const SurfaceMesh& surface) {
  std::vector<Vec3> areas;
  for (const Triangle& t : surface.triangles) {
    const auto corner = [&](std::size_t k) {
      return surface.vertices[static_cast<std::size_t>(t[k])];
    };
    areas.push_back(cross(corner(1) - corner(0), corner(2) - corner(0)) * 0.5);
  }
  return areas;
}

/// Triangles that all turn one way and have the polygon's area together cover it once.
void expect_covered(const std::vector<std::array<double, 2>>& places, double area) {
  for (std::size_t first = 0; first < places.size(); ++first) {
    SurfaceMesh surface = corners_at(places);
    EXPECT_EQ(add_polygon(surface, from_corner(places.size(), first)), places.size() - 2);
    ASSERT_EQ(surface.triangles.size(), places.size() - 2);
    double sum = 0;
    for (const Vec3& of_triangle : area_vectors(surface)) {
      EXPECT_GT(of_triangle.z * area, 0) << "from corner " << first;
      sum += of_triangle.z;
    }
    EXPECT_DOUBLE_EQ(sum, area) << "from corner " << first;
  }
}

TEST(PolygonTriangles, are_a_fan_round_the_first_corner_where_the_polygon_is_convex) {
  SurfaceMesh surface = corners_at({{0, 0}, {4, 0}, {5, 3}, {2, 5}, {-1, 3}});
  EXPECT_EQ(add_polygon(surface, std::vector<std::int32_t>{2, 3, 4, 0, 1}), 3U);
  EXPECT_THAT(surface.triangles,
              ElementsAre(Triangle{2, 3, 4}, Triangle{2, 4, 0}, Triangle{2, 0, 1}));
}

TEST(PolygonTriangles, cover_an_l_and_an_arrowhead_from_every_corner_and_either_way_round) {
  std::vector<std::array<double, 2>> l = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  std::vector<std::array<double, 2>> arrowhead = {{0, 0}, {2, -1}, {1, 0}, {2, 1}};
  expect_covered(l, 3);
  expect_covered(arrowhead, 1);
  std::reverse(l.begin(), l.end());
  std::reverse(arrowhead.begin(), arrowhead.end());
  expect_covered(l, -3);
  expect_covered(arrowhead, -1);
}

TEST(PolygonTriangles, are_not_flat_where_corners_lie_on_straight_sides) {
  expect_covered({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}, 4);
  expect_covered({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 3}, {1.5, 1.5}}, 4.5);
  expect_covered({{0, 0}, {1, 0}, {2, 0}, {1, 1}}, 1);
}

TEST(PolygonTriangles, cover_combs_and_the_ring_round_a_hole_that_a_cut_makes_a_polygon) {
  std::vector<std::array<double, 2>> comb = {{0, 0}, {20, 0}};
  for (int tooth = 9; tooth >= 0; --tooth) {
    comb.push_back({2.0 * tooth + 1.5, 5});
    comb.push_back({2.0 * tooth + 1, 1});
    comb.push_back({2.0 * tooth + 0.5, 5});
    if (tooth > 0) comb.push_back({2.0 * tooth, 1});
  }
  double area = 0;
  for (std::size_t i = 0; i < comb.size(); ++i) {
    const auto& [x, y] = comb[i];
    const auto& [u, v] = comb[(i + 1) % comb.size()];
    area += 0.5 * (x * v - u * y);
  }
  expect_covered(comb, area);
  expect_covered({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}},
                 8);
}

TEST(PolygonTriangles, of_a_polygon_in_space_that_is_not_flat_turn_its_way) {
  SurfaceMesh surface;
  surface.vertices = {{5, 0, 0}, {5, 2, 0.1}, {5.1, 1, 0.5}, {5, 0, 2}};
  EXPECT_EQ(add_polygon(surface, std::vector<std::int32_t>{1, 2, 3, 0}), 2U);
  for (const Vec3& area : area_vectors(surface)) EXPECT_GT(area.x, 0);
}

TEST(PolygonTriangles, of_what_has_no_inside_are_a_fan_for_the_check_to_judge) {
  SurfaceMesh line = corners_at({{0, 0}, {1, 0}, {2, 0}, {3, 0}});
  EXPECT_EQ(add_polygon(line, from_corner(4, 0)), 2U);
  EXPECT_THAT(line.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  SurfaceMesh one_place = corners_at(std::vector<std::array<double, 2>>(300, {1, 1}));
  EXPECT_EQ(add_polygon(one_place, from_corner(300, 0)), 298U);
  SurfaceMesh star = corners_at({{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}});
  EXPECT_EQ(add_polygon(star, from_corner(5, 0)), 3U);
  EXPECT_EQ(star.triangles.size(), 3U);
}

/// A corner of a large polygon looks at all others; here nearly no corner is an ear.
TEST(PolygonTriangles, cost_bounded_work_where_nearly_no_corner_is_an_ear) {
  std::vector<std::array<double, 2>> places;
  for (int i = 0; i < 40000; ++i) {  // a line that is gone along to and fro, with a bump
    places.push_back({static_cast<double>(i % 2), i == 7 ? 1.0 : 0.0});
  }
  SurfaceMesh surface = corners_at(places);
  EXPECT_EQ(add_polygon(surface, from_corner(places.size(), 0)), places.size() - 2);
}

TEST(PolygonTriangles, are_those_of_all_formats_that_have_polygons) {
  const std::string places = "0 0 0\n1 -1 0\n0.5 0 0\n1 1 0\n";  // an arrowhead
  const SurfaceMesh obj =
      read_obj("v 0 0 0\nv 1 -1 0\nv 0.5 0 0\nv 1 1 0\ng a\nf 2 3 4 1\n", "a.obj");
  const auto expected = obj.triangles;
  ASSERT_EQ(expected.size(), 2U);
  for (const Vec3& area : area_vectors(obj)) EXPECT_GT(area.z, 0);
  EXPECT_THAT(obj.patch_of_triangle, ElementsAre(0, 0));
  EXPECT_EQ(read_off("OFF\n4 1 0\n" + places + "4 1 2 3 0\n", "a.off").triangles, expected);
  EXPECT_EQ(read_ply("ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                     "property float y\nproperty float z\nelement face 1\n"
                     "property list uchar int vertex_index\nend_header\n" +
                         places + "4 1 2 3 0\n",
                     "a.ply")
                .triangles,
            expected);
  const SurfaceMesh tetgen = read_tetgen(
      "4 3 0 0\n0 0 0 0\n1 1 -1 0\n2 0.5 0 0\n3 1 1 0\n1 1\n4 1 2 3 0 7\n0\n0\n", "a.smesh");
  EXPECT_EQ(tetgen.triangles, expected);
  EXPECT_THAT(tetgen.patch_of_triangle, ElementsAre(0, 0));
}

TEST(PolygonTriangles, take_the_place_of_quadrangles_in_files_of_meshes) {
  const auto expect_cut = [](const SurfaceMesh& surface, const std::string& patch) {
    ASSERT_EQ(surface.triangles.size(), 2U) << patch;
    for (const Vec3& area : area_vectors(surface)) EXPECT_DOUBLE_EQ(area.z, 0.25) << patch;
    EXPECT_THAT(surface.patch_names, ElementsAre(patch));
    EXPECT_THAT(surface.patch_of_triangle, ElementsAre(0, 0)) << patch;
  };
  expect_cut(read_msh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 -1 0\n"
                      "3 0.5 0 0\n4 1 1 0\n$EndNodes\n$Elements\n1\n1 3 2 7 1 2 3 4 1\n"
                      "$EndElements\n",
                      "a.msh"),
             "physical 7");
  const std::string places = "0 0 0\n1 -1 0\n0.5 0 0\n1 1 0\n";
  expect_cut(read_su2("NDIME= 3\nNELEM= 0\nNPOIN= 4\n" + places +
                          "NMARK= 1\nMARKER_TAG= wall\nMARKER_ELEMS= 1\n9 1 2 3 0\n",
                      "a.su2"),
             "wall");
  expect_cut(read_medit("MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 -1 0 0\n"
                        "0.5 0 0 0\n1 1 0 0\nQuadrilaterals\n1\n2 3 4 1 5\nEnd\n",
                        "a.mesh"),
             "reference 5");
  expect_cut(read_ugrid_surface("4 0 1 0 0 0 0\n" + places + "2 3 4 1\n3\n", "a.ugrid"), "patch 3");
}

}  // namespace
}  // namespace tetfarm
