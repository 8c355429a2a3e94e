#include "mesh/decompose/surface_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(ClosestInTriangle, is_nearer_than_any_other_point_of_it) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-1, 1);
  const auto point = [&] { return Vec3{place(random), place(random), place(random)}; };
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = point(), b = point(), c = point(), p = point();
    const Closest closest = closest_in_triangle(p, a, b, c);
    EXPECT_NEAR(closest.distance2, norm2(p - closest.point), 1e-12);
    constexpr int steps = 40;
    double least = HUGE_VAL;
    for (int u = 0; u <= steps; ++u) {
      for (int v = 0; u + v <= steps; ++v) {
        const Vec3 q = a + (1.0 * u / steps) * (b - a) + (1.0 * v / steps) * (c - a);
        least = std::min(least, norm2(p - q));
      }
    }
    // Nearer than all of a grid, and no farther from the nearest of them than the grid is wide.
    EXPECT_LE(closest.distance2, least + 1e-12);
    EXPECT_NEAR(std::sqrt(closest.distance2), std::sqrt(least), 3.5 / steps);
  }
}

/// A level cut of one triangle at a height over the middle of a box of side 2, without a rim.
InterdomainMesh cut_at(double height) {
  InterdomainMesh cut;
  cut.plane = make_cut_plane({0, 0, 1}, height);
  for (const Vec3& p : {Vec3{-0.2, -0.1, 0}, Vec3{0.2, -0.1, 0}, Vec3{0, 0.2, 0}}) {
    cut.planar.points.push_back(cut.plane.project(p));
    cut.heights.push_back(0);
    cut.spacing.push_back(0.5);
  }
  cut.planar.triangles = {{0, 1, 2}};
  return cut;
}

std::vector<SurfaceContact> contacts_of(const InterdomainMesh& cut, double reach) {
  const Subdomain box = root_subdomain(shapes::box({-1, -1, -1}, {1, 1, 1}, 4));
  const SurfaceTopology topology = make_surface_topology(box);
  return find_contacts(cut, box, topology, find_nearby_surface(cut, box, topology, reach), reach);
}

TEST(SurfaceContacts, of_a_cut_inside_are_those_within_reach_with_their_distances) {
  EXPECT_TRUE(contacts_of(cut_at(0), 1).empty());
  const std::vector<SurfaceContact> near = contacts_of(cut_at(0.9), 1);
  ASSERT_FALSE(near.empty());
  double least = HUGE_VAL;
  for (const SurfaceContact& contact : near) {
    EXPECT_FALSE(contact.meets);
    EXPECT_FALSE(contact.is_at_rim);
    EXPECT_LT(contact.distance, 1);
    EXPECT_EQ(contact.unit, 0.5) << "the spacing, which is smaller than the triangles";
    least = std::min(least, contact.distance * contact.unit);
  }
  EXPECT_NEAR(least, 0.1, 1e-12);
}

TEST(SurfaceContacts, of_a_cut_through_the_surface_meet_it) {
  InterdomainMesh cut = cut_at(0.9);
  cut.heights[2] = 0.3;
  int meeting = 0;
  for (const SurfaceContact& contact : contacts_of(cut, 0.01)) {
    if (!contact.meets) continue;
    ++meeting;
    EXPECT_EQ(contact.distance, 0);
  }
  EXPECT_GT(meeting, 0);
}

TEST(SurfaceContacts, near_a_cut_are_looked_for_among_the_surface_near_it) {
  const Subdomain box = root_subdomain(shapes::box({-1, -1, -1}, {1, 1, 1}, 4));
  const SurfaceTopology topology = make_surface_topology(box);
  const NearbySurface nearby = find_nearby_surface(cut_at(0.9), box, topology, 0.5);
  EXPECT_FALSE(nearby.triangles.empty());
  for (const std::int32_t t : nearby.triangles) {
    for (const std::int32_t v : box.triangles[at(t)]) EXPECT_EQ(box.vertices[at(v)].z, 1);
  }
  EXPECT_EQ(find_nearby_surface(cut_at(0.9), box, topology, 9).triangles.size(),
            box.triangles.size());
}

}  // namespace
}  // namespace tetfarm
