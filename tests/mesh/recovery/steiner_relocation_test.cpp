#include "mesh/recovery/steiner_relocation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/boundary_recovery.h"
#include "mesh/recovery/inside_tets.h"
#include "mesh/recovery/star_growth.h"
#include "mesh/recovery/steiner_settling.h"
#include "mesh/recovery/surface_fans.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {
namespace {

/// A cube whose boundary is recovered; then a point is put on one of its edges or faces, which is
/// split.
struct SplitCube {
  SplitCube(std::int32_t triangle, bool is_on_edge)
      : domain(root_subdomain(shapes::unit_cube())),
        complex(bowyer_watson(domain.vertices).complex),
        marks(complex.nodes.size(), 0) {
    EXPECT_TRUE(recover_boundary(complex, marks, domain.triangles).lost.empty());
    mesh.emplace(complex, marks);
    const auto& [a, b, c] = domain.triangles[static_cast<std::size_t>(triangle)];
    const FinePoint on_edge = between(fine(mesh->point(a)), fine(mesh->point(b)), {0.3, 1e-20});
    const DoubleDouble share = is_on_edge ? DoubleDouble{} : DoubleDouble{0.4, 1e-20};
    node = mesh->add_point(between(on_edge, fine(mesh->point(c)), share));
    surface = unsplit(domain.triangles);
    if (is_on_edge) {
      put_into_tets({a, b});
      split_edge(surface, a, b, node);
    } else {
      put_into_tets({a, b, c});
      split_face(surface, triangle, node);
    }
    for (const Triangle& t : surface.triangles) {
      const FaceHandle face = mesh->find_face(t[0], t[1], t[2]);
      EXPECT_NE(face, no_face);
      mesh->constrain(face, true);
    }
  }

  void put_into_tets(const std::vector<std::int32_t>& crossed) {
    std::vector<std::int32_t> tets;
    std::vector<Tet> parts;
    for (const std::int32_t t : mesh->star(crossed.front())) {
      const Tet& n = complex.nodes[static_cast<std::size_t>(t)];
      const auto holds = [&n](std::int32_t v) { return std::count(n.begin(), n.end(), v) > 0; };
      if (!std::all_of(crossed.begin(), crossed.end(), holds)) continue;
      tets.push_back(t);
      for (const std::int32_t v : crossed) {
        parts.push_back(n);
        std::replace(parts.back().begin(), parts.back().end(), v, node);
      }
    }
    mesh->replace(tets, parts);
  }

  /// The inside as a mesh, as it is after the outside is gone.
  TetMesh inside_mesh() {
    const RecoverySurface whole(domain.triangles, static_cast<std::int32_t>(complex.points.size()));
    InsideComplex kept = keep_inside(complex, marks, inside_tets(*mesh, whole), 8, 4);
    kept.complex.points.resize(static_cast<std::size_t>(node) - 4 + 1);
    return to_tet_mesh(kept.complex, 8);
  }

  Subdomain domain;
  TetComplex complex;
  std::vector<std::uint8_t> marks;
  std::optional<LocalRemeshing> mesh;
  SplitSurface surface;
  std::int32_t node = -1;
};

TEST(SteinerRelocation, of_a_point_on_an_edge_or_a_face_makes_what_it_split_whole) {
  for (const bool is_on_edge : {true, false}) {
    for (std::int32_t triangle = 0; triangle < 12; ++triangle) {
      SplitCube cube(triangle, is_on_edge);
      ASSERT_TRUE(
          relocate_steiner_point(*cube.mesh, cube.surface, cube.domain.triangles, cube.node));
      const Vec3& moved = cube.complex.points[static_cast<std::size_t>(cube.node)];
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GT(moved[axis], 0);
        EXPECT_LT(moved[axis], 1);
      }
      EXPECT_TRUE(validate(cube.complex).empty());
      expect_mesh_of(cube.inside_mesh(), cube.domain);
    }
  }
}

TEST(SteinerRelocation, changes_nothing_when_the_surface_has_other_faces_at_the_point) {
  SplitCube cube(0, false);
  std::swap(cube.surface.triangles.back()[0], cube.surface.triangles.back()[1]);
  const auto before = cube.complex.nodes;
  EXPECT_FALSE(relocate_steiner_point(*cube.mesh, cube.surface, cube.domain.triangles, cube.node));
  EXPECT_EQ(cube.complex.nodes, before);
}

TEST(SurfaceFans, of_a_point_on_an_edge_are_two_whose_places_the_whole_triangles_fill) {
  SplitCube cube(2, true);
  const auto fans = surface_fans(*cube.mesh, cube.surface, cube.domain.triangles, cube.node);
  ASSERT_TRUE(fans.has_value());
  ASSERT_EQ(fans->size(), 2U);
  for (const SurfaceFan& fan : *fans) {
    ASSERT_EQ(fan.without.size(), 1U);
    Triangle whole = cube.domain.triangles[static_cast<std::size_t>(fan.source)];
    Triangle cut = fan.without.front();
    std::rotate(whole.begin(), std::min_element(whole.begin(), whole.end()), whole.end());
    std::rotate(cut.begin(), std::min_element(cut.begin(), cut.end()), cut.end());
    EXPECT_EQ(cut, whole);
  }
}

TEST(SteinerSettling, takes_nodes_out_of_random_tets_by_flips_and_leaves_them_valid) {
  std::mt19937_64 random(5);
  std::vector<Vec3> points(60);
  for (Vec3& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = std::uniform_real_distribution<double>(0, 1)(random);
    }
  }
  TetComplex complex = bowyer_watson(points).complex;
  std::vector<std::uint8_t> marks;
  LocalRemeshing mesh(complex, marks);
  int removed = 0;
  for (std::int32_t v = 0; v < 40; ++v) {
    const auto before = complex.nodes;
    if (!remove_node(mesh, v)) {
      EXPECT_EQ(complex.nodes, before);
      continue;
    }
    ++removed;
    ASSERT_TRUE(validate(complex).empty());
    for (const Tet& t : complex.nodes) EXPECT_EQ(std::count(t.begin(), t.end(), v), 0);
  }
  EXPECT_GT(removed, 30);
}

TEST(StarGrowth, finds_a_place_of_doubles_for_a_node_in_a_tet_as_thin_as_their_last_digit) {
  // The thin tet fills what is between the two ways to cut a square that is not quite flat.
  TetMesh thin;
  thin.nodes = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, std::nextafter(1.0, 2)}, {0.4, 0.5, 2}};
  thin.tets = {{0, 1, 2, 3}, {0, 1, 3, 4}, {1, 2, 3, 4}};
  thin.boundary_nodes = 5;
  TetComplex complex = make_tet_complex(thin);
  std::vector<std::uint8_t> marks;
  LocalRemeshing mesh(complex, marks);
  mesh.constrain(mesh.find_face(0, 1, 2), true);
  mesh.constrain(mesh.find_face(0, 2, 3), true);
  const FinePoint low = between(mesh.fine_point(0), mesh.fine_point(2), {0.5, 0});
  const FinePoint high = between(mesh.fine_point(1), mesh.fine_point(3), {0.5, 0});
  const std::int32_t node = mesh.add_point(between(low, high, {0.5, 0}));
  std::vector<Tet> parts(4, thin.tets.front());
  for (std::size_t i = 0; i < 4; ++i) parts[i][i] = node;
  mesh.replace(std::array{0}, parts);
  ASSERT_FALSE(mesh.fine_point(node).is_plain());
  ASSERT_TRUE(grow_star(mesh, node));
  EXPECT_TRUE(mesh.fine_point(node).is_plain());
  EXPECT_GT(mesh.point(node).z, 1.01);
  EXPECT_TRUE(validate(complex).empty());
  EXPECT_NE(mesh.find_face(0, 1, 2), no_face);
  EXPECT_NE(mesh.find_face(0, 2, 3), no_face);
}

TEST(SteinerSettling, keeps_the_point_that_schoenhardts_polyhedron_needs_on_plain_doubles) {
  const Subdomain domain = root_subdomain(shapes::schoenhardt());
  TetComplex complex = bowyer_watson(domain.vertices).complex;
  std::vector<std::uint8_t> marks(complex.nodes.size(), 0);
  const RecoveredBoundary recovered = recover_boundary(complex, marks, domain.triangles);
  EXPECT_TRUE(recovered.lost.empty());
  EXPECT_EQ(recovered.steiner_points, 1);
}

}  // namespace
}  // namespace tetfarm
