#include "mesh/cosmetics/improve_mesh.h"

#include <gmock/gmock.h>

#include <set>

#include "base/array_index.h"
#include "mesh/core/tet_quality.h"
#include "mesh/cosmetics/quality.h"
#include "tests/mesh/cosmetics/trial_meshes.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;

/// The boundary faces, each turned so that its smallest node comes first.
std::multiset<std::array<std::int32_t, 3>> boundary_faces(const TetComplex& complex) {
  std::multiset<std::array<std::int32_t, 3>> faces;
  for (std::int32_t t = 0; at(t) < complex.nodes.size(); ++t) {
    for (int face = 0; complex.is_live(t) && face < 4; ++face) {
      if (complex.neighbours[at(t)][at(face)] != no_face) continue;
      std::array<std::int32_t, 3> nodes;
      for (std::size_t i = 0; i < 3; ++i) {
        nodes[i] = complex.nodes[at(t)][at(tet_face_nodes[at(face)][i])];
      }
      std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end()), nodes.end());
      faces.insert(nodes);
    }
  }
  return faces;
}

struct Measures {
  double volume = 0;
  double worst = 1;
  double min_dihedral_deg = 180;
};
Measures measure(const TetComplex& complex) {
  Measures measures;
  for (const Tet& tet : complex.nodes) {
    if (tet[0] < 0) continue;
    const auto point = [&](std::size_t i) { return complex.points[at(tet[i])]; };
    measures.volume += tet_volume(point(0), point(1), point(2), point(3));
    measures.worst = std::min(measures.worst, cosmetics::quality(complex, tet));
    measures.min_dihedral_deg = std::min(
        measures.min_dihedral_deg, dihedral_range(point(0), point(1), point(2), point(3)).min_deg);
  }
  return measures;
}

/// Improves the mesh and checks all that must hold for every mesh.
CosmeticReport improve_and_check(const TetMesh& mesh, const CosmeticOptions& options = {}) {
  TetComplex complex = make_tet_complex(mesh);
  const auto faces = boundary_faces(complex);
  const Measures before = measure(complex);
  const CosmeticReport report = improve_mesh(complex, mesh.boundary_nodes, options);
  const Measures after = measure(complex);
  EXPECT_THAT(validate(complex), IsEmpty());
  EXPECT_EQ(boundary_faces(complex), faces);
  EXPECT_NEAR(after.volume, before.volume, 1e-12 * before.volume);
  EXPECT_GE(after.worst, before.worst);
  EXPECT_NEAR(report.min_dihedral_before_deg, before.min_dihedral_deg, 1e-6);
  EXPECT_NEAR(report.min_dihedral_after_deg, after.min_dihedral_deg, 1e-6);
  for (std::size_t v = 0; v < at(mesh.boundary_nodes); ++v) {
    EXPECT_EQ(complex.points[v], mesh.nodes[v]);
  }
  return report;
}

std::int64_t operations(const CosmeticReport& report) {
  return report.swaps + report.moves + report.collapses + report.splits;
}

TEST(ImproveMesh, lets_good_meshes_be) {
  EXPECT_EQ(operations(improve_and_check(trial::kuhn_box(3))), 0);
}

TEST(ImproveMesh, lets_a_single_sliver_be) {
  TetMesh mesh;
  mesh.nodes = {{1, 0, 0.01}, {-1, 0, 0.01}, {0, 1, 0}, {0, -1, 0}};
  mesh.tets = {{0, 1, 2, 3}};
  mesh.boundary_nodes = 4;
  ASSERT_THAT(validate(make_tet_complex(mesh)), IsEmpty());
  EXPECT_EQ(operations(improve_and_check(mesh)), 0);
}

TEST(ImproveMesh, an_empty_mesh_stays_empty) {
  TetComplex complex;
  EXPECT_EQ(operations(improve_mesh(complex, 0)), 0);
}

TEST(ImproveMesh, a_planted_sliver_disappears) {
  TetMesh mesh = trial::kuhn_box(4);
  mesh.nodes[at(mesh.boundary_nodes) + 13] += {0.9, 0.8, 0.7};
  ASSERT_THAT(validate(make_tet_complex(mesh)), IsEmpty());
  const CosmeticReport report = improve_and_check(mesh);
  EXPECT_LT(report.min_dihedral_before_deg, 10);
  EXPECT_GT(report.min_dihedral_after_deg, 29);
}

TEST(ImproveMesh, improves_fifty_random_meshes) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE(seed);
    const CosmeticReport report = seed % 2 == 0 ? improve_and_check(trial::random_ball(1, 40, seed))
                                                : improve_and_check(trial::kuhn_box(3, 0.9, seed));
    EXPECT_GT(operations(report), 0);
    EXPECT_GT(report.min_dihedral_after_deg, 4);
  }
}

TEST(ImproveMesh, leaves_no_angle_below_25_degrees_in_a_lattice_ball) {
  const CosmeticReport report = improve_and_check(trial::lattice_ball(2));
  EXPECT_GT(report.min_dihedral_after_deg, 25);
}

TEST(ImproveMesh, reaches_15_degrees_from_random_points) {
  CosmeticOptions options;
  options.wanted_dihedral_deg = 20;
  const CosmeticReport report = improve_and_check(trial::random_ball(2, 500, 5), options);
  EXPECT_LT(report.min_dihedral_before_deg, 2);
  EXPECT_GT(report.min_dihedral_after_deg, 15);
}

TEST(ImproveMesh, gives_the_same_bytes_each_time) {
  const TetMesh mesh = trial::random_ball(2, 300, 9);
  TetComplex first = make_tet_complex(mesh);
  TetComplex second = make_tet_complex(mesh);
  improve_mesh(first, mesh.boundary_nodes);
  improve_mesh(second, mesh.boundary_nodes);
  EXPECT_EQ(first.points, second.points);
  EXPECT_EQ(first.nodes, second.nodes);
  EXPECT_EQ(first.neighbours, second.neighbours);
}

TEST(ImproveMesh, does_not_move_a_node_of_a_boundary_face_even_when_it_is_not_fixed) {
  TetMesh mesh = trial::random_ball(1, 40, 3);
  const std::int32_t boundary = mesh.boundary_nodes;
  TetComplex complex = make_tet_complex(mesh);
  const auto faces = boundary_faces(complex);
  improve_mesh(complex, 0);
  EXPECT_EQ(boundary_faces(complex), faces);
  for (std::size_t v = 0; v < at(boundary); ++v) EXPECT_EQ(complex.points[v], mesh.nodes[v]);
}

TEST(ImproveMesh, a_fixed_inner_node_stays) {
  const TetMesh mesh = trial::random_ball(1, 40, 3);
  TetComplex complex = make_tet_complex(mesh);
  improve_mesh(complex, mesh.boundary_nodes + 40);
  for (std::size_t v = 0; v < mesh.nodes.size(); ++v) EXPECT_EQ(complex.points[v], mesh.nodes[v]);
}

TEST(ImproveMesh, asks_the_spacing_before_it_adds_or_removes_nodes) {
  CosmeticOptions options;
  options.wanted_dihedral_deg = 40;
  options.rebuilt_dihedral_deg = 40;
  const TetMesh mesh = trial::random_ball(2, 300, 9);
  ASSERT_GT(improve_and_check(mesh, options).splits, 0);
  options.spacing = [](const Vec3&) { return 1e3; };
  EXPECT_EQ(improve_and_check(mesh, options).splits, 0);
  options.spacing = [](const Vec3&) { return 1e-3; };
  EXPECT_EQ(improve_and_check(mesh, options).collapses, 0);
}

}  // namespace
}  // namespace tetfarm
