#include "mesh/library/leaf_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/core/validate.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// An octahedron of four tets round its axis, cut in two pyramids by its middle square.
struct Octahedron {
  Subdomain whole;
  Cut cut;
};

Subdomain subdomain_of(TreePath path, const std::vector<Vec3>& vertices,
                       const std::vector<Triangle>& triangles,
                       const std::vector<Origin>& node_origin) {
  Subdomain subdomain{path, vertices, triangles, node_origin, {}, 1, {}};
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    subdomain.triangle_origin.push_back({path.heap + 100, static_cast<std::uint32_t>(t)});
  }
  return subdomain;
}

/// The cut has a node of its own, 0, in the middle of the square.
Octahedron octahedron() {
  const std::vector<Vec3> v = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const Vec3 middle{0, 0, 0};
  std::vector<Origin> origins;
  for (std::uint32_t i = 0; i < 6; ++i) origins.push_back({0, i});
  const Origin new_node{1, 0};
  Octahedron o;
  o.whole = subdomain_of(
      {1}, v,
      {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}},
      origins);
  // Upper half: square 0..3, apex 4, middle 5; lower half: the same with the other apex.
  const std::vector<Triangle> upper = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4},
                                       {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};
  std::vector<Triangle> lower;
  for (const Triangle& t : upper) lower.push_back({t[1], t[0], t[2]});
  o.cut.left = subdomain_of({2}, {v[0], v[1], v[2], v[3], v[4], middle}, upper,
                            {origins[0], origins[1], origins[2], origins[3], origins[4], new_node});
  o.cut.right =
      subdomain_of({3}, {v[0], v[1], v[2], v[3], v[5], middle}, lower,
                   {origins[0], origins[1], origins[2], origins[3], origins[5], new_node});
  return o;
}

/// Four tets round the axis from the middle (5) to the apex (4).
TetMesh pyramid_mesh(const Subdomain& half) {
  TetMesh mesh{half.vertices, {}, static_cast<std::int32_t>(half.vertices.size())};
  const bool up = half.vertices[4].z > 0;
  for (std::int32_t i = 0; i < 4; ++i) {
    const std::int32_t a = i;
    const std::int32_t b = (i + 1) % 4;
    mesh.tets.push_back(up ? Tet{5, a, b, 4} : Tet{5, b, a, 4});
  }
  return mesh;
}

TEST(JoinHalves, is_a_valid_mesh_of_the_whole_whose_first_nodes_are_its_own) {
  const Octahedron o = octahedron();
  const TetMesh joined = join_halves(o.whole, o.cut.left, pyramid_mesh(o.cut.left), o.cut.right,
                                     pyramid_mesh(o.cut.right));
  EXPECT_EQ(validate(joined, o.whole.triangles), std::vector<std::string>());
  EXPECT_EQ(joined.boundary_nodes, 6);
  EXPECT_EQ(joined.nodes.size(), 7U);
  EXPECT_EQ(joined.tets.size(), 8U);
  for (std::size_t v = 0; v < 6; ++v) EXPECT_EQ(joined.nodes[v], o.whole.vertices[v]);
  for (std::size_t t = 0; t < 8; ++t) {
    const bool has_apex = std::ranges::count(joined.tets[t], t < 4 ? 4 : 5) == 1;
    EXPECT_TRUE(has_apex) << "tets of the left half come first, tet " << t;
  }
}

VolumeOutcome pyramid_of(const Subdomain& half) { return {pyramid_mesh(half), {}}; }

VolumeOutcome failure_at(std::int32_t triangle, VolumeFailure::Cause cause) {
  return {{}, {cause, "no mesh", {triangle}}};
}

TEST(LeafMesh, takes_the_first_way_when_it_works) {
  const Octahedron o = octahedron();
  const auto never = [](const Subdomain&) -> CutOutcome {
    ADD_FAILURE() << "cut without need";
    return {};
  };
  const VolumeOutcome outcome = leaf_mesh(o.cut.left, {.mesh = pyramid_of, .cut = never});
  EXPECT_EQ(outcome.mesh.value().tets.size(), 4U);
}

VolumeOutcome halves_only(const Subdomain& part) {
  if (part.path.heap == 1) return failure_at(3, VolumeFailure::Cause::not_recovered);
  return pyramid_of(part);
}

TEST(LeafMesh, cuts_a_leaf_that_cannot_be_recovered_once_more) {
  const Octahedron o = octahedron();
  const auto cut = [&o](const Subdomain&) { return CutOutcome{o.cut, ""}; };
  const VolumeOutcome outcome = leaf_mesh(o.whole, {.mesh = halves_only, .cut = cut});
  EXPECT_EQ(validate(outcome.mesh.value(), o.whole.triangles), std::vector<std::string>());
}

TEST(LeafMesh, names_the_triangles_of_the_whole_when_neither_way_works) {
  const Octahedron o = octahedron();
  const auto no_cut = [](const Subdomain&) { return CutOutcome{std::nullopt, "no plane"}; };
  const VolumeOutcome outcome = leaf_mesh(o.whole, {.mesh = halves_only, .cut = no_cut});
  EXPECT_FALSE(outcome.mesh);
  EXPECT_EQ(outcome.failure.triangles, std::vector<std::int32_t>{3});
}

TEST(LeafMesh, names_the_triangles_of_the_whole_when_a_half_fails) {
  const Octahedron o = octahedron();
  const auto cut = [&o](const Subdomain&) { return CutOutcome{o.cut, ""}; };
  for (const std::uint64_t failing : {2U, 3U}) {
    const auto mesh = [failing](const Subdomain& part) {
      if (part.path.heap != 1 && part.path.heap != failing) return pyramid_of(part);
      return failure_at(static_cast<std::int32_t>(part.path.heap),
                        VolumeFailure::Cause::not_recovered);
    };
    const VolumeOutcome outcome = leaf_mesh(o.whole, {.mesh = mesh, .cut = cut});
    EXPECT_FALSE(outcome.mesh);
    EXPECT_EQ(outcome.failure.triangles, std::vector<std::int32_t>{1});
  }
}

TEST(LeafMesh, cuts_no_leaf_two_of_whose_vertices_are_at_the_same_place) {
  const Octahedron o = octahedron();
  const auto mesh = [](const Subdomain&) {
    return failure_at(3, VolumeFailure::Cause::same_place);
  };
  const auto never = [](const Subdomain&) -> CutOutcome {
    ADD_FAILURE() << "cut in vain";
    return {};
  };
  const VolumeOutcome outcome = leaf_mesh(o.whole, {.mesh = mesh, .cut = never});
  EXPECT_FALSE(outcome.mesh);
  EXPECT_EQ(outcome.failure.cause, VolumeFailure::Cause::same_place);
}

/// A bar along x with two voids, each a tet, near one of its ends. A vertex of one is at the same
/// place as one of the other: no part with them both has a mesh.
Subdomain bar_with_touching_voids(double end) {
  SurfaceMesh bar = shapes::box({0, 0, 0}, {6, 1, 1}, 4);
  const Vec3 meeting{end, 0.5, 0.5};
  for (const double way : {-0.2, 0.2}) {
    const auto first = static_cast<std::int32_t>(bar.vertices.size());
    for (const Vec3& step : {Vec3{0, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{1, 0, 0}}) {
      bar.vertices.push_back(meeting + way * step);
    }
    // They point out of the domain, into the void; the step in x turns with the way.
    const std::int32_t a = first;
    const std::int32_t b = first + (way > 0 ? 1 : 2);
    const std::int32_t c = first + (way > 0 ? 2 : 1);
    const std::int32_t d = first + 3;
    for (const Triangle& t : {Triangle{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}}) {
      bar.triangles.push_back(t);
    }
  }
  bar.patch_of_triangle.clear();
  bar.patch_names.clear();
  return root_subdomain(bar);
}

TEST(LeafMeshers, accept_no_cut_of_which_one_half_has_no_mesh) {
  const SpacingField spacing(0.4);
  const auto cut = [&spacing](const Subdomain& leaf) {
    return leaf_meshers(spacing, {}, {}).cut(leaf);
  };
  EXPECT_TRUE(cut(root_subdomain(shapes::box({0, 0, 0}, {6, 1, 1}, 4))).cut);
  for (const double end : {0.5, 5.5}) {
    const CutOutcome outcome = cut(bar_with_touching_voids(end));
    EXPECT_FALSE(outcome.cut) << end;
    EXPECT_EQ(outcome.reason, "no candidate accepted") << end;
  }
}

}  // namespace
}  // namespace tetfarm
