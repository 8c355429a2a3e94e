#include "mesh/volume/volume_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

#include "mesh/core/tet_quality.h"
#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/boundary_recovery.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {
namespace {

double smallest_dihedral(const TetMesh& mesh) {
  double smallest = 180;
  for (const Tet& t : mesh.tets) {
    const auto p = [&](std::size_t i) { return mesh.nodes[static_cast<std::size_t>(t[i])]; };
    smallest = std::min(smallest, dihedral_range(p(0), p(1), p(2), p(3)).min_deg);
  }
  return smallest;
}

TEST(VolumeMesh, of_a_single_tet_is_that_tet) {
  const Subdomain domain = root_subdomain(shapes::tetrahedron());
  const TetMesh mesh = mesh_volume(domain, SpacingField(10)).mesh.value();
  expect_mesh_of(mesh, domain);
  EXPECT_EQ(mesh.tets.size(), 1U);
}

TEST(VolumeMesh, of_simple_shapes_is_valid_and_well_shaped) {
  const struct {
    SurfaceMesh surface;
    double spacing;
    double angle;
  } cases[] = {{shapes::unit_cube(), 10, 20},
               {shapes::box({0, 0, 0}, {1, 1, 1}, 8), 0.14, 12},
               {shapes::box({0, 0, 0}, {3, 1, 0.1}, 6), 0.3, 3},
               {shapes::sphere({5, 5, 5}, 2, 3), 0.3, 12},
               {shapes::nested_spheres(3), 0.14, 10},
               {shapes::torus(0.4, 40, 16), 0.16, 12}};
  for (const auto& c : cases) {
    const Subdomain domain = root_subdomain(c.surface);
    const TetMesh mesh = mesh_volume(domain, SpacingField(c.spacing)).mesh.value();
    expect_mesh_of(mesh, domain);
    EXPECT_GT(smallest_dihedral(mesh), c.angle);
  }
}

TEST(VolumeMesh, has_about_as_many_elements_as_the_spacing_asks_for) {
  const Subdomain domain = root_subdomain(shapes::box({0, 0, 0}, {1, 1, 1}, 16));
  const double h = 1.0 / 16;
  const TetMesh mesh = mesh_volume(domain, SpacingField(h)).mesh.value();
  const double wanted = SpacingField::elements_per_h3 / (h * h * h);
  EXPECT_GT(static_cast<double>(mesh.tets.size()), 0.5 * wanted);
  EXPECT_LT(static_cast<double>(mesh.tets.size()), 1.6 * wanted);
}

TEST(VolumeMesh, of_the_schoenhardt_polyhedron_has_a_point_inside) {
  const Subdomain domain = root_subdomain(shapes::schoenhardt());
  ASSERT_GT(enclosed_volume(domain.vertices, domain.triangles), 0);
  VolumeMeshReport report;
  const TetMesh mesh = mesh_volume(domain, SpacingField(10), {}, &report).mesh.value();
  expect_mesh_of(mesh, domain);
  EXPECT_GE(report.interior_steiner_points, 1);
}

TEST(VolumeMesh, of_random_stars_with_spikes_is_valid) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Subdomain domain = root_subdomain(shapes::random_star(2, 0.25, 1.5, seed));
    const TetMesh mesh = mesh_volume(domain, SpacingField(0.3)).mesh.value();
    SCOPED_TRACE(seed);
    expect_mesh_of(mesh, domain);
  }
}

TEST(VolumeMesh, of_blocks_that_touch_along_edges_of_a_grid_is_valid) {
  // Columns of random height: flat faces, right angles and rows of cospherical points.
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SurfaceMesh surface = shapes::box({0, 0, 0}, {1, 1, 1}, 6);
    std::mt19937_64 random(seed);
    for (Vec3& p : surface.vertices) {
      if (p.z == 1) p.z = 1 + 0.25 * static_cast<double>(random() % 4);
    }
    const Subdomain domain = root_subdomain(surface);
    SCOPED_TRACE(seed);
    expect_mesh_of(mesh_volume(domain, SpacingField(0.2)).mesh.value(), domain);
  }
}

TEST(VolumeMesh, without_filling_has_the_boundary_nodes_only) {
  const Subdomain domain = root_subdomain(shapes::sphere({0, 0, 0}, 1, 2));
  VolumeMeshOptions options;
  options.fill = false;
  const TetMesh mesh = mesh_volume(domain, SpacingField(0.1), options).mesh.value();
  expect_mesh_of(mesh, domain);
  EXPECT_EQ(mesh.nodes.size(), domain.vertices.size());
}

TEST(VolumeMesh, is_the_same_to_the_last_bit_each_time) {
  const Subdomain domain = root_subdomain(shapes::random_star(3, 0.7, 1.2, 5));
  const TetMesh a = mesh_volume(domain, SpacingField(0.12)).mesh.value();
  const TetMesh b = mesh_volume(domain, SpacingField(0.12)).mesh.value();
  EXPECT_EQ(a.tets, b.tets);
  EXPECT_EQ(a.nodes, b.nodes);
}

TEST(VolumeMesh, is_the_same_whether_somebody_listens) {
  for (const SurfaceMesh& surface : {shapes::random_star(2, 0.25, 1.5, 5), shapes::schoenhardt()}) {
    const Subdomain domain = root_subdomain(surface);
    VolumeMeshOptions listened;
    std::int64_t calls = 0;
    listened.progress = WorkProgress([&calls](const WorkCount&) { ++calls; });
    const TetMesh a = mesh_volume(domain, SpacingField(0.2)).mesh.value();
    const TetMesh b = mesh_volume(domain, SpacingField(0.2), listened).mesh.value();
    EXPECT_EQ(a.tets, b.tets);
    EXPECT_EQ(a.nodes, b.nodes);
    EXPECT_GT(calls, 4);
  }
}

TEST(VolumeMesh, tells_its_stages_in_order_with_counts_that_never_fall) {
  for (const InteriorPoints points : {InteriorPoints::lattice, InteriorPoints::sweeps}) {
    const Subdomain domain = root_subdomain(shapes::random_star(2, 0.25, 1.5, 7));
    std::vector<WorkStage> stages;
    std::map<WorkStage, WorkCount> last;
    VolumeMeshOptions options;
    options.points = points;
    options.progress = WorkProgress([&](const WorkCount& count) {
      if (!last.contains(count.stage)) stages.push_back(count.stage);
      const WorkCount& before = last[count.stage];
      EXPECT_GE(count.pass, before.pass);
      EXPECT_GE(count.done, before.done);
      EXPECT_GE(count.total, before.total);
      EXPECT_TRUE(count.total == 0 || count.done <= count.total);
      last[count.stage] = count;
    });
    mesh_volume(domain, SpacingField(0.2), options);
    EXPECT_THAT(stages, testing::IsSupersetOf({WorkStage::boundary, WorkStage::edges,
                                               WorkStage::points, WorkStage::cosmetics}));
    EXPECT_TRUE(std::is_sorted(stages.begin(), stages.end()));
    EXPECT_GT(last[WorkStage::edges].done, 0U) << "the star has missing edges";
    EXPECT_GT(last[WorkStage::cosmetics].pass, 0U);
  }
}

TEST(VolumeMesh, names_the_place_of_two_vertices_at_one_point) {
  Subdomain domain = root_subdomain(shapes::box({0, 0, 0}, {1, 1, 1}, 2));
  domain.vertices[3] = domain.vertices[5];
  const VolumeOutcome outcome = mesh_volume(domain, SpacingField(1));
  ASSERT_FALSE(outcome.mesh);
  EXPECT_EQ(outcome.failure.cause, VolumeFailure::Cause::same_place);
  EXPECT_THAT(outcome.failure.message,
              testing::StartsWith("sub-domain root: two vertices are at the same place ("));
  // All that one of the two has, in whichever of their corners.
  const auto triangles_of = [&domain](std::int32_t v) {
    std::vector<std::int32_t> found;
    for (std::size_t t = 0; t < domain.triangles.size(); ++t) {
      if (std::ranges::count(domain.triangles[t], v) > 0)
        found.push_back(static_cast<std::int32_t>(t));
    }
    return found;
  };
  EXPECT_THAT(outcome.failure.triangles, testing::AnyOf(triangles_of(3), triangles_of(5)));
}

/// How often the boundary of a sphere is tried through which a small tet sticks out.
int attempts_at(int levels) {
  Subdomain domain = root_subdomain(shapes::sphere({0, 0, 0}, 1, levels));
  const auto first = static_cast<std::int32_t>(domain.vertices.size());
  for (const Vec3& p : {Vec3{0.9, 0.01, 0.02}, Vec3{1.2, 0.02, 0.01}, Vec3{0.92, 0.1, 0.03},
                        Vec3{0.93, 0.03, 0.12}}) {
    domain.vertices.push_back(p);
  }
  domain.node_origin.resize(domain.vertices.size());
  for (const Triangle& t :
       {Triangle{0, 1, 2}, Triangle{0, 3, 1}, Triangle{0, 2, 3}, Triangle{1, 3, 2}}) {
    domain.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  domain.triangle_origin.resize(domain.triangles.size());
  VolumeMeshOptions options;
  int attempts = 0;
  std::optional<WorkStage> last;
  options.progress = WorkProgress([&](const WorkCount& count) {
    if (count.stage == WorkStage::boundary && last != count.stage) ++attempts;
    last = count.stage;
  });
  EXPECT_FALSE(mesh_volume(domain, SpacingField(1), options).mesh);
  return attempts;
}

TEST(VolumeMesh, of_small_surfaces_is_tried_more_often) {
  EXPECT_EQ(attempts_at(1), 12);
  EXPECT_EQ(attempts_at(4), 2);
}

/// A prism whose top is turned by half a side, so that its sides bend inward.
SurfaceMesh twisted_prism(int sides) {
  SurfaceMesh mesh;
  const double side = 2 * std::numbers::pi / sides;
  for (const int level : {0, 1}) {
    for (int i = 0; i < sides; ++i) {
      const double angle = side * i + 0.25 * side * level;
      mesh.vertices.push_back({std::cos(angle), std::sin(angle), 1.0 * level});
    }
  }
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    mesh.triangles.push_back({i, next, sides + next});
    mesh.triangles.push_back({i, sides + next, sides + i});
    if (i == 0 || next == 0) continue;
    mesh.triangles.push_back({0, next, i});
    mesh.triangles.push_back({sides, sides + i, sides + next});
  }
  return mesh;
}

TEST(VolumeMesh, reports_points_on_the_boundary_and_inside_apart) {
  int different = 0;
  for (int sides = 3; sides <= 14; ++sides) {
    const Subdomain domain = root_subdomain(twisted_prism(sides));
    TetComplex complex = bowyer_watson(domain.vertices).complex;
    std::vector<std::uint8_t> constrained(complex.nodes.size(), 0);
    const RecoveredBoundary recovered = recover_boundary(complex, constrained, domain.triangles);
    if (!recovered.lost.empty()) continue;
    VolumeMeshReport report;
    VolumeMeshOptions options;
    options.fill = false;
    mesh_volume(domain, SpacingField(1), options, &report);
    EXPECT_EQ(report.boundary_steiner_points, recovered.splits);
    EXPECT_EQ(report.interior_steiner_points, recovered.steiner_points);
    different += recovered.splits != recovered.steiner_points ? 1 : 0;
  }
  EXPECT_GT(different, 0);
}

TEST(VolumeMesh, of_a_surface_that_cuts_itself_fails_and_names_triangles) {
  const SurfaceMesh a = shapes::sphere({0, 0, 0}, 1, 2);
  const SurfaceMesh b = shapes::sphere({1.2, 0, 0}, 1, 2);
  SurfaceMesh both = shapes::between(a, b);
  for (std::size_t t = a.triangles.size(); t < both.triangles.size(); ++t) {
    std::swap(both.triangles[t][1], both.triangles[t][2]);
  }
  const VolumeOutcome outcome = mesh_volume(root_subdomain(both), SpacingField(0.5));
  ASSERT_FALSE(outcome.mesh);
  EXPECT_EQ(outcome.failure.cause, VolumeFailure::Cause::not_recovered);
  EXPECT_FALSE(outcome.failure.triangles.empty());
}

}  // namespace
}  // namespace tetfarm
