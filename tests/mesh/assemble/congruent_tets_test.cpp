#include "mesh/assemble/congruent_tets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tetfarm {
namespace {

using Corners = std::array<Vec3, 4>;

void expect_the_same(const TetShape& shape, const TetShape& expected) {
  EXPECT_EQ(shape.dihedral_cosines, expected.dihedral_cosines);
  EXPECT_EQ(shape.dihedral_bins, expected.dihedral_bins);
  EXPECT_EQ(shape.min_dihedral_deg, expected.min_dihedral_deg);
  EXPECT_EQ(shape.max_dihedral_deg, expected.max_dihedral_deg);
  EXPECT_EQ(shape.radius_ratio, expected.radius_ratio);
  EXPECT_EQ(shape.height, expected.height);
  EXPECT_EQ(shape.centroid, expected.centroid);
}

/// How many were worked out.
std::int64_t expect_shapes_of(const std::vector<Corners>& tets) {
  CongruentTets shapes;
  for (const auto& [a, b, c, d] : tets) {
    expect_the_same(shapes.shape(a, b, c, d), tet_shape(a, b, c, d));
  }
  return shapes.worked_out();
}

Corners moved(const Corners& tet, const Vec3& by) {
  return {tet[0] + by, tet[1] + by, tet[2] + by, tet[3] + by};
}

Vec3 random_point(std::mt19937_64& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  const double x = number(random);
  const double y = number(random);
  return {x, y, number(random)};
}

TEST(CongruentTets, copies_of_few_have_their_shapes_and_places_of_their_own) {
  std::mt19937_64 random(1);
  std::vector<Corners> few;
  for (int i = 0; i < 60; ++i) {
    Corners tet;
    for (Vec3& p : tet) {
      p = random_point(random);
      p = {std::round(p.x * 64) / 64, std::round(p.y * 64) / 64, std::round(p.z * 64) / 64};
    }
    few.push_back(tet);
  }
  std::vector<Corners> tets;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 by = {static_cast<double>(random() % 100), static_cast<double>(random() % 100), 7};
    tets.push_back(moved(few[random() % few.size()], by));
  }
  EXPECT_LT(expect_shapes_of(tets), 2500) << "copies were not known";
}

/// The tets of a body-centred lattice: each axis, with each pair of neighbours round it.
TEST(CongruentTets, of_a_lattice_are_worked_out_once_each) {
  const double h = 0x1.37a6ep-5;
  std::vector<Corners> kinds;
  for (const bool is_turned : {false, true}) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 4; ++side) {
        const auto along = [&](double x, double y, double z) {
          const std::array<double, 3> p = {x, is_turned ? -y : y, z};
          const auto of = [&](int i) { return h * p[static_cast<std::size_t>((i + axis) % 3)]; };
          return Vec3{of(0), of(1), of(2)};
        };
        const double y = side % 2 == 0 ? 0.5 : -0.5;
        const double z = side < 2 ? 0.5 : -0.5;
        kinds.push_back({along(0, 0, 0), along(1, 0, 0), along(0.5, y, z), along(0.5, -y, z)});
      }
    }
  }
  std::vector<Corners> tets;
  for (int i = 0; i < 4000; ++i) {
    const auto along = [i](int step) { return 0x1.37a6ep-5 * static_cast<double>(i / step % 16); };
    tets.push_back(
        moved(kinds[static_cast<std::size_t>(i) % kinds.size()], {along(24), along(5), along(90)}));
  }
  EXPECT_LE(expect_shapes_of(tets), 2 * std::ssize(kinds));
}

TEST(CongruentTets, tets_that_nearly_are_copies_have_shapes_of_their_own) {
  std::mt19937_64 random(2);
  std::vector<Corners> tets;
  const Corners tet = {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  for (int i = 0; i < 3000; ++i) tets.push_back(moved(tet, random_point(random)));
  for (std::size_t k = 0; k < 4; ++k) {
    Corners other = tet;
    other[k].x = std::nextafter(other[k].x, 2);
    tets.push_back(tet);
    tets.push_back(other);
  }
  expect_shapes_of(tets);
}

TEST(CongruentTets, flat_and_turned_tets_are_as_without_them) {
  const Vec3 o = {0, 0, 0};
  const Vec3 x = {1, 0, 0};
  const Vec3 y = {0, 1, 0};
  const Vec3 z = {0, 0, 1};
  expect_shapes_of({{o, x, y, z},
                    {o, y, x, z},
                    {o, x, y, x + y},
                    {o, o, o, o},
                    {o, o, o, o},
                    {z, z, z, z},
                    {o, x, y, z},
                    {o, y, x, z}});
}

}  // namespace
}  // namespace tetfarm
