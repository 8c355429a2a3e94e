#include "mesh/filling/lattice_filling.h"

#include <gtest/gtest.h>

#include "base/array_index.h"
#include "mesh/core/tet_quality.h"
#include "mesh/cosmetics/altitude_improvement.h"
#include "mesh/cosmetics/improve_mesh.h"
#include "mesh/filling/core_graft.h"
#include "mesh/geometry/bowyer_watson.h"
#include "mesh/recovery/boundary_recovery.h"
#include "mesh/recovery/inside_tets.h"
#include "tests/mesh/filling/lattice_cases.h"
#include "tests/mesh/volume/volume_checks.h"

namespace tetfarm {
namespace {

constexpr std::int32_t enclosing_nodes = 4;

/// A sphere on its way through the volume mesher.
struct Sphere {
  explicit Sphere(double radius)
      : domain(root_subdomain(shapes::sphere({0, 0, 0}, radius, 4))),
        complex(bowyer_watson(domain.vertices).complex) {
    constrained.assign(complex.nodes.size(), 0);
    EXPECT_TRUE(recover_boundary(complex, constrained, domain.triangles).lost.empty());
  }
  std::int32_t boundary_nodes() const { return static_cast<std::int32_t>(domain.vertices.size()); }
  std::vector<std::uint8_t> inside() {
    return inside_tets(
        LocalRemeshing(complex, constrained),
        RecoverySurface(domain.triangles, static_cast<std::int32_t>(complex.points.size())));
  }
  void keep_inside_only() {
    InsideComplex kept =
        keep_inside(complex, constrained, inside(), boundary_nodes(), enclosing_nodes);
    complex = std::move(kept.complex);
    constrained = std::move(kept.constrained);
  }
  std::size_t nodes_in_use() const {
    return static_cast<std::size_t>(std::count_if(complex.node2tet.begin(), complex.node2tet.end(),
                                                  [](std::int32_t t) { return t >= 0; }));
  }

  Subdomain domain;
  TetComplex complex;
  std::vector<std::uint8_t> constrained;
  GraftedCore core;
};

Sphere filled(double radius, const SpacingField& field, const PointInsertionOptions& options = {}) {
  Sphere sphere(radius);
  PendingCore pending = insert_shell(sphere.complex, sphere.constrained, sphere.inside(),
                                     sphere.domain, field, options);
  EXPECT_TRUE(validate(sphere.complex).empty());
  sphere.keep_inside_only();
  sphere.core = graft_pending_core(sphere.complex, sphere.constrained, std::move(pending),
                                   sphere.boundary_nodes(), enclosing_nodes);
  return sphere;
}

void expect_valid(const Sphere& sphere) {
  const auto wrong = validate(sphere.complex);
  EXPECT_TRUE(wrong.empty()) << wrong.front();
  TetMesh mesh = to_tet_mesh(sphere.complex, sphere.boundary_nodes());
  double volume = 0;
  for (const Tet& t : mesh.tets) {
    volume += tet_volume(mesh.nodes[at(t[0])], mesh.nodes[at(t[1])], mesh.nodes[at(t[2])],
                         mesh.nodes[at(t[3])]);
  }
  EXPECT_NEAR(volume, enclosed_volume(sphere.domain.vertices, sphere.domain.triangles),
              1e-9 * volume);
}

TEST(LatticeFilling, makes_a_valid_mesh_of_the_whole_domain) {
  expect_valid(filled(1.0, lattice_cases::uniform()));
  expect_valid(filled(1.0, lattice_cases::fine()));
  expect_valid(filled(1.6, lattice_cases::graded()));
}

TEST(LatticeFilling, has_the_nodes_and_about_the_tets_of_inserting_all) {
  const SpacingField field = lattice_cases::fine();
  Sphere all(1.0);
  const auto nodes = field.lattice_nodes(bounding_box(all.domain.vertices));
  const auto inside =
      find_inside_nodes(all.complex, all.inside(), nodes, std::vector<std::uint8_t>(nodes.size()));
  std::vector<LatticeNode> chosen;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (inside[i] != 0) chosen.push_back(nodes[i]);
  }
  insert_lattice(all.complex, all.constrained, static_cast<std::int32_t>(all.complex.points.size()),
                 chosen);
  all.keep_inside_only();
  const Sphere ours = filled(1.0, field);
  EXPECT_EQ(ours.nodes_in_use(), all.nodes_in_use());
  // Ties of cospherical points may be broken otherwise.
  EXPECT_NEAR(static_cast<double>(ours.complex.live_tets()),
              static_cast<double>(all.complex.live_tets()),
              1e-3 * static_cast<double>(all.complex.live_tets()));
}

TEST(LatticeFilling, gives_up_core_nodes_whose_neighbours_were_refused) {
  PointInsertionOptions options;
  options.face_clearance = 1.2;  // refuses nodes that the core counts on
  const Sphere sphere = filled(1.0, lattice_cases::fine(), options);
  expect_valid(sphere);
  const Sphere usual = filled(1.0, lattice_cases::fine());
  EXPECT_LT(sphere.nodes_in_use(), usual.nodes_in_use());
}

/// The shell of a sphere, with what the core needs to find its seat.
struct Hollow {
  Hollow() : sphere(1.0) {
    pending = insert_shell(sphere.complex, sphere.constrained, sphere.inside(), sphere.domain,
                           lattice_cases::fine(), {});
  }
  CoreSeat seat() const {
    return find_core_seat(sphere.complex, sphere.constrained, pending.core, pending.node_numbers);
  }
  Sphere sphere;
  PendingCore pending;
};

TEST(LatticeFilling, tells_which_tets_are_regular_and_how_low_they_are) {
  const Sphere sphere = filled(1.6, lattice_cases::graded());
  const TetComplex& complex = sphere.complex;
  ASSERT_GT(sphere.core.last - sphere.core.first, 100);
  double lowest = HUGE_VAL;
  for (std::int32_t t = sphere.core.first; t < sphere.core.last; ++t) {
    const Tet& tet = complex.nodes[at(t)];
    const auto point = [&](std::size_t i) { return complex.points[at(tet[i])]; };
    const DihedralRange range = dihedral_range(point(0), point(1), point(2), point(3));
    ASSERT_NEAR(range.min_deg, 60, 1e-6);
    ASSERT_NEAR(range.max_deg, 90, 1e-6);
    lowest = std::min(
        lowest, std::sqrt(cosmetics::smallest_height2(point(0), point(1), point(2), point(3))));
  }
  EXPECT_GE(lowest, sphere.core.least_height);
  EXPECT_LT(lowest, 1.001 * sphere.core.least_height);
}

TEST(LatticeFilling, cosmetics_does_the_same_whether_it_knows_the_regular_tets_or_not) {
  Sphere first = filled(1.6, lattice_cases::graded());
  Sphere second = first;
  CosmeticOptions options;
  options.smallest_spacing = 1.4 * first.core.least_height;
  options.height_in_smallest_spacings = 0.7;
  const CosmeticReport plain = improve_mesh(first.complex, first.boundary_nodes(), options);
  options.regular = {second.core.first, second.core.last, second.core.least_height};
  const CosmeticReport known = improve_mesh(second.complex, second.boundary_nodes(), options);
  EXPECT_GT(plain.moves, 10);
  EXPECT_EQ(first.complex.points, second.complex.points);
  EXPECT_EQ(first.complex.nodes, second.complex.nodes);
  EXPECT_EQ(plain.min_dihedral_before_deg, known.min_dihedral_before_deg);
  EXPECT_EQ(plain.min_dihedral_after_deg, known.min_dihedral_after_deg);
}

TEST(CoreGraft, finds_the_hollow_and_its_filling) {
  const Hollow hollow;
  const CoreSeat seat = hollow.seat();
  EXPECT_TRUE(seat.fits);
  EXPECT_EQ(seat.outer.size(), hollow.pending.core.hull().size());
  double filling = 0;
  for (const std::int32_t t : seat.filling) {
    const Tet& tet = hollow.sphere.complex.nodes[at(t)];
    const auto p = [&](std::size_t i) { return hollow.sphere.complex.points[at(tet[i])]; };
    filling += tet_volume(p(0), p(1), p(2), p(3));
  }
  const double edge = lattice_cases::fine().lattice_nodes(lattice_cases::box()).front().cell_edge;
  const double core = hollow.pending.core.tet_count() * edge * edge * edge / 12;
  EXPECT_NEAR(filling, core, 1e-9 * core);
}

TEST(CoreGraft, does_not_fit_where_a_face_of_the_hull_is_missing) {
  Hollow hollow;
  const std::int32_t filling = hollow.seat().filling.front();
  hollow.sphere.complex.kill_tet(filling);
  EXPECT_FALSE(hollow.seat().fits);
}

TEST(CoreGraft, does_not_fit_where_a_constrained_face_is_in_the_way) {
  Hollow hollow;
  const std::int32_t filling = hollow.seat().filling.front();
  hollow.sphere.constrained[at(filling)] = 1;
  EXPECT_FALSE(hollow.seat().fits);
}

}  // namespace
}  // namespace tetfarm
