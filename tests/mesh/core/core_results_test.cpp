// Numbers of single tets, and layers and regions of small meshes, worked out by hand.
#include <gmock/gmock.h>

#include <cmath>

#include "mesh/core/subdomain_regions.h"
#include "mesh/core/tet_layers.h"
#include "mesh/core/tet_quality.h"
#include "mesh/core/triangle_angles.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(TetQuality, of_tets_worked_out_by_hand_is_known) {
  const Vec3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const DihedralCosines corner = dihedral_cosines(o, x, y, z);
  EXPECT_NEAR(corner.of_smallest, 1 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(corner.of_largest, 0, 1e-15);
  // Inradius 1 / (3 + sqrt 3), circumradius sqrt(3) / 2.
  EXPECT_NEAR(radius_ratio(o, x, y, z), 3 / (3 + std::sqrt(3.0)) / (std::sqrt(3.0) / 2), 1e-14);
  // A low roof over a triangle: the angles at the base are those of slope 0.1 over a height of 1/3
  // of the triangle's.
  const Vec3 a{1, 0, 0}, b{-0.5, std::sqrt(3.0) / 2, 0}, c{-0.5, -std::sqrt(3.0) / 2, 0};
  const Vec3 top{0, 0, 0.1};
  const DihedralCosines roof = dihedral_cosines(a, b, c, top);
  EXPECT_NEAR(roof.of_smallest, 0.5 / std::sqrt(0.25 + 0.01), 1e-14);
  EXPECT_LT(roof.of_largest, -0.4);
  EXPECT_EQ(dihedral_cosines(a, c, b, top).of_smallest, 1) << "inverted";
  EXPECT_EQ(dihedral_cosines(a, c, b, top).of_largest, -1);
  EXPECT_FALSE(may_have_smaller_dihedral(o, x, y, z, 0.58));
  EXPECT_TRUE(may_have_smaller_dihedral(o, x, y, z, 0.57));
  EXPECT_TRUE(may_have_smaller_dihedral(o, x, y, z, 0));
  EXPECT_TRUE(may_have_smaller_dihedral(o, y, x, z, 0.99)) << "inverted";
}

TEST(TriangleAngles, of_15_degrees_are_no_needle_and_of_less_are_one) {
  const auto needles_of = [](double degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    return needle_count({{0, 0, 0}, {1, 0, 0}, {std::cos(angle), std::sin(angle), 0}}, {{0, 1, 2}});
  };
  EXPECT_EQ(needles_of(14.99), 1);
  EXPECT_EQ(needles_of(15.01), 0);
  EXPECT_EQ(needles_of(15.05), 0);
  EXPECT_EQ(needles_of(0.001), 1);
  EXPECT_EQ(needles_of(60), 0);
}

TEST(TetLayers, reach_what_is_in_later_blocks_and_pages_too) {
  // A chain of tets, each with the last node of the one before: 3 nodes more for each.
  std::vector<Tet> chain;
  for (std::int32_t i = 0; i < 1100; ++i) chain.push_back({3 * i, 3 * i + 1, 3 * i + 2, 3 * i + 3});
  const TetBlocks blocks(chain, 3 * 1100 + 1);
  EXPECT_EQ(blocks.blocks(), 3U) << "512, 512 and 76 tets";
  EXPECT_EQ(blocks.pages(), 52U) << "3301 nodes, 64 a page";
  TetLayers layers(blocks);
  layers.reach(3 * 512);  // of the last tet of the first block and the first of the second
  EXPECT_THAT(layers.next(), ElementsAre(511U, 512U));
  EXPECT_TRUE(layers.has(511) && layers.has(512));
  EXPECT_FALSE(layers.has(510));
  EXPECT_THAT(layers.next(), IsEmpty()) << "nobody has reached farther";
  layers.reach_nodes_of(std::vector<std::uint32_t>{511, 512});
  EXPECT_THAT(layers.next(), ElementsAre(510U, 513U));
  layers.reach(3300);
  layers.reach(3300);
  EXPECT_THAT(layers.next(), ElementsAre(1099U));
}

TEST(SurfaceMesh, counts_the_regions_on_the_sides_of_its_triangles) {
  SurfaceMesh mesh = shapes::tetrahedron();
  EXPECT_EQ(meshed_sides(mesh), 4);
  EXPECT_EQ(region_count(mesh), 1);
  mesh.sides = {{1, 0}, {2, 1}, {0, 0}, {0, 3}};
  EXPECT_EQ(meshed_sides(mesh), 1 + 2 + 0 + 1);
  EXPECT_EQ(meshed_sides(mesh, 1), 2);
  EXPECT_EQ(meshed_sides(mesh, 2), 0);
  EXPECT_EQ(region_count(mesh), 3);
  EXPECT_EQ(sides_of(mesh, 3), (Sides{0, 3}));
}

TEST(SurfaceMesh, has_the_volume_of_its_regions_however_their_triangles_face) {
  SurfaceMesh mesh = shapes::unit_cube();
  EXPECT_NEAR(domain_volume(mesh), 1, 1e-15);
  mesh.sides.assign(12, Sides{1, 0});
  for (std::size_t t = 0; t < 12; t += 3) {
    std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    mesh.sides[t] = {0, 1};
  }
  EXPECT_NEAR(domain_volume(mesh), 1, 1e-15);
  // An interface counts on neither side.
  mesh.triangles.push_back({0, 1, 2});
  mesh.sides.push_back({1, 2});
  mesh.triangles.push_back({0, 1, 3});
  mesh.sides.push_back({0, 0});
  EXPECT_NEAR(domain_volume(mesh), 1, 1e-15);
}

}  // namespace
}  // namespace tetfarm
