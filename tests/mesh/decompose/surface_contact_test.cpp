#include "mesh/decompose/surface_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/mesh/decompose/flat_cut.h"

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

TEST(ClosestInTriangle, is_that_of_faces_edges_and_corners) {
  const Vec3 a{0, 0, 0};
  const Vec3 b{2, 0, 0};
  const Vec3 c{0, 2, 0};
  EXPECT_EQ(closest_in_triangle({0.5, 0.5, 3}, a, b, c).point, (Vec3{0.5, 0.5, 0}));
  EXPECT_EQ(closest_in_triangle({1, -2, 0}, a, b, c).point, (Vec3{1, 0, 0}));
  EXPECT_EQ(closest_in_triangle({-1, -1, 0}, a, b, c).point, a);
  EXPECT_EQ(closest_in_triangle({3, 0, 4}, a, b, c).distance2, 17);
}

TEST(ClosestInTriangle, of_a_triangle_without_area_is_on_its_longest_edge) {
  const Vec3 a{0, 0, 0}, b{3, 0, 0}, c{1, 0, 0};
  EXPECT_EQ(closest_in_triangle({2, 1, 0}, a, b, c).point, (Vec3{2, 0, 0}));
  EXPECT_EQ(closest_in_triangle({2, 1, 0}, c, a, b).distance2, 1);
  EXPECT_EQ(closest_in_triangle({2, 1, 0}, a, a, a).distance2, 5);
}

NearbySurface whole_surface(const Subdomain& subdomain) {
  NearbySurface all;
  all.triangles.resize(subdomain.triangles.size());
  std::iota(all.triangles.begin(), all.triangles.end(), 0);
  for (const Triangle& triangle : subdomain.triangles) {
    Box3 box;
    for (const std::int32_t v : triangle) box.add(subdomain.vertices[at(v)]);
    all.boxes.push_back(box);
  }
  all.tree = BoxTree(all.boxes);
  return all;
}

using Pair = std::array<std::int32_t, 2>;

std::vector<Pair> pairs_of(const std::vector<SurfaceContact>& contacts) {
  std::vector<Pair> pairs;
  for (const SurfaceContact& contact : contacts) {
    pairs.push_back({contact.cut_triangle, contact.surface_triangle});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// The vertices of a cut triangle as the sub-domain numbers them; -1: a new node.
std::array<std::int32_t, 3> vertices_of(const InterdomainMesh& mesh, std::int32_t triangle) {
  std::array<std::int32_t, 3> vertices = mesh.planar.triangles[at(triangle)];
  for (std::int32_t& v : vertices) v = mesh.is_rim_node(v) ? mesh.rim_vertices[at(v)] : -1;
  return vertices;
}

TEST(SurfaceContacts, of_a_plate_that_the_cut_nearly_touches_are_all_pairs_within_reach) {
  const FlatCut cut = cut_at_plate(0.51, 0.6);
  constexpr double reach = 0.4;
  const auto contacts =
      find_contacts(cut.mesh, cut.subdomain, cut.topology, whole_surface(cut.subdomain), reach);
  std::vector<Pair> expected;
  for (std::int32_t i = 0; i < std::ssize(cut.mesh.planar.triangles); ++i) {
    const auto& nodes = cut.mesh.planar.triangles[at(i)];
    const std::array<std::int32_t, 3> vertices = vertices_of(cut.mesh, i);
    const auto place = [&](std::size_t k) {
      return node_position(cut.mesh, cut.subdomain, nodes[k]);
    };
    for (std::int32_t s = 0; s < std::ssize(cut.subdomain.triangles); ++s) {
      const Triangle& surface = cut.subdomain.triangles[at(s)];
      const auto vertex = [&](std::size_t k) { return cut.subdomain.vertices[at(surface[k])]; };
      if (std::find_first_of(surface.begin(), surface.end(), vertices.begin(), vertices.end()) !=
          surface.end()) {
        continue;
      }
      const bool is_at_rim = std::any_of(surface.begin(), surface.end(), [&](std::int32_t v) {
        return std::count(cut.mesh.rim_vertices.begin(), cut.mesh.rim_vertices.end(), v) > 0;
      });
      double least2 = HUGE_VAL;
      for (std::size_t k = 0; k < 3; ++k) {
        if (vertices[k] < 0) {
          least2 = std::min(
              least2, closest_in_triangle(place(k), vertex(0), vertex(1), vertex(2)).distance2);
        }
        if (!is_at_rim) {
          least2 = std::min(least2,
                            closest_in_triangle(vertex(k), place(0), place(1), place(2)).distance2);
        }
      }
      double h = 0;
      for (const std::int32_t v : nodes) h = std::max(h, cut.mesh.spacing[at(v)]);
      const double unit = std::min(h, cut.topology.size[at(s)]);
      if (std::sqrt(least2) < reach * unit) expected.push_back({i, s});
    }
  }
  EXPECT_GT(expected.size(), 20U);
  EXPECT_EQ(pairs_of(contacts), expected);
  for (const SurfaceContact& contact : contacts) EXPECT_FALSE(contact.meets);
}

TEST(SurfaceContacts, are_found_in_what_is_nearby_as_in_the_whole_surface) {
  for (const double low : {0.45, 0.51}) {
    const FlatCut cut = cut_at_plate(low, 0.6);
    const NearbySurface nearby = find_nearby_surface(cut.mesh, cut.subdomain, cut.topology, 2);
    EXPECT_LT(2 * nearby.triangles.size(), cut.subdomain.triangles.size());
    EXPECT_TRUE(std::is_sorted(nearby.triangles.begin(), nearby.triangles.end()));
    EXPECT_EQ(pairs_of(find_contacts(cut.mesh, cut.subdomain, cut.topology, nearby, 0.4)),
              pairs_of(find_contacts(cut.mesh, cut.subdomain, cut.topology,
                                     whole_surface(cut.subdomain), 0.4)));
  }
}

TEST(SurfaceContacts, are_looked_for_no_longer_once_there_are_more_than_asked_for) {
  const FlatCut cut = cut_at_plate(0.51, 0.6);
  const NearbySurface surface = whole_surface(cut.subdomain);
  const auto found = [&](std::size_t most) {
    return pairs_of(find_contacts(cut.mesh, cut.subdomain, cut.topology, surface, 0.4, most));
  };
  const std::vector<Pair> all = found(1000000);
  ASSERT_GT(all.size(), 20U);
  EXPECT_EQ(found(all.size()), all);
  const std::vector<Pair> few = found(5);
  EXPECT_GT(few.size(), 5U);
  EXPECT_LT(few.size(), all.size());
  EXPECT_TRUE(std::equal(few.begin(), few.end(), all.begin()));
}

TEST(SurfaceContacts, of_a_plate_in_the_way_meet_and_have_no_distance) {
  FlatCut cut = cut_at_plate(0.51, 0.6);
  for (std::size_t i = cut.mesh.rim_vertices.size(); i < cut.mesh.heights.size(); ++i) {
    cut.mesh.heights[i] = 0.05;
  }
  const auto contacts =
      find_contacts(cut.mesh, cut.subdomain, cut.topology, whole_surface(cut.subdomain), 0.4);
  EXPECT_TRUE(std::any_of(contacts.begin(), contacts.end(),
                          [](const SurfaceContact& contact) { return contact.meets; }));
  for (const SurfaceContact& contact : contacts) {
    if (!contact.meets) continue;
    EXPECT_EQ(contact.distance, 0);
    EXPECT_FALSE(contact.is_at_rim);
  }
}

}  // namespace
}  // namespace tetfarm
