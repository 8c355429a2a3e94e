// The steps of filling a domain with points, known by their digests (tests/golden/filling.txt).
#include <gtest/gtest.h>

#include "mesh/filling/core_graft.h"
#include "mesh/filling/core_nodes.h"
#include "mesh/filling/lattice_filling.h"
#include "mesh/filling/sweep_points.h"
#include "tests/mesh/filling/lattice_block.h"
#include "tests/mesh/recovery/recovered_sphere.h"
#include "tests/support/complex_digest.h"

namespace tetfarm {
namespace {

using test::ResultDigest;

void expect_known(const std::string& name, const ResultDigest& result) {
  test::expect_known("filling", name, result);
}

void add_core(ResultDigest& result, const LatticeCore& core) {
  result.add(core.tet_count(), core.core_nodes(), core.hull().size());
  for (const CoreHullFace& face : core.hull()) result.add(face.face, face.tet);
}

/// A domain's tets with the boundary recovered, ready for points inside.
struct RecoveredDomain {
  explicit RecoveredDomain(const Subdomain& domain)
      : triangles(domain.triangles),
        boundary_nodes(static_cast<std::int32_t>(domain.vertices.size())),
        complex(bowyer_watson(domain.vertices).complex),
        constrained(complex.nodes.size(), 0) {
    EXPECT_TRUE(recover_boundary(complex, constrained, triangles).lost.empty());
  }
  std::vector<std::uint8_t> inside() {
    return inside_tets(
        LocalRemeshing(complex, constrained),
        RecoverySurface(triangles, static_cast<std::int32_t>(complex.points.size())));
  }

  std::vector<Triangle> triangles;
  std::int32_t boundary_nodes;
  TetComplex complex;
  std::vector<std::uint8_t> constrained;
};

void fill(const std::string& name, const Subdomain& domain, const SpacingField& field,
          const PointInsertionOptions& asked = {}) {
  RecoveredDomain ball(domain);
  ResultDigest shell;
  PointInsertionOptions options = asked;
  options.progress = shell.listener();
  PendingCore pending =
      insert_shell(ball.complex, ball.constrained, ball.inside(), domain, field, options);
  shell.add(pending.node_numbers, pending.places, pending.smallest_cell_edge,
            pending.cost.visits.cells, pending.cost.visits.questions, pending.cost.listed,
            pending.cost.inside, ball.constrained);
  add_core(shell, pending.core);
  test::add_complex(shell, ball.complex);
  expect_known(name + "_shell", shell);

  ResultDigest seat_found;
  const CoreSeat seat =
      find_core_seat(ball.complex, ball.constrained, pending.core, pending.node_numbers);
  seat_found.add(seat.outer, seat.faces, seat.filling, seat.fits);
  expect_known(name + "_seat", seat_found);

  ResultDigest whole;
  InsideComplex kept =
      keep_inside(ball.complex, ball.constrained, ball.inside(), ball.boundary_nodes, 4);
  const GraftedCore core = graft_pending_core(kept.complex, kept.constrained, std::move(pending),
                                              ball.boundary_nodes, 4);
  whole.add(core.first, core.last, core.least_height, kept.constrained);
  test::add_complex(whole, kept.complex);
  expect_known(name + "_whole", whole);
}

Subdomain ball_of(double radius) { return root_subdomain(shapes::sphere({0, 0, 0}, radius, 3)); }

/// The finest cells where the lattice ends last.
SpacingField finest_last() {
  SpacingOptions options;
  options.background = 0.25;
  options.growth = 0.15;
  options.inherit_surface = false;
  options.sources = {{{{{0.6, 0.6, 0.6}, 0.09, 0.3, 0.9}}}};
  return make_spacing_field(shapes::sphere({0, 0, 0}, 1.8, 2), options);
}

TEST(FillingResults, of_a_ball_are_known_at_every_step) {
  fill("even", ball_of(1), lattice_cases::uniform());
  fill("graded", ball_of(1.3), lattice_cases::graded());
  fill("finest_last", ball_of(1.3), finest_last());
  PointInsertionOptions wide;
  wide.face_clearance = 1.2;  // refuses nodes that the core counts on
  fill("wide", ball_of(1), lattice_cases::uniform(), wide);
}

TEST(FillingResults, of_a_domain_bounded_by_the_lattice_are_known_at_every_step) {
  LatticeBlock block(4);
  fill("block", block.domain, block.field);
  // Some faces are none of the lattice's any more.
  for (Vec3& p : block.domain.vertices) {
    if (p.z > 0.3) p.z += 0.01;
  }
  fill("dented_block", block.domain, block.field);
}

TEST(FillingResults, of_nodes_of_the_lattice_and_their_kinds_are_known) {
  const Subdomain domain = root_subdomain(shapes::sphere({0.1, 0.2, 0.05}, 0.8, 2));
  const BoxTree tree(triangle_boxes(domain.vertices, domain.triangles));
  for (const bool is_graded : {false, true}) {
    const SpacingField field = is_graded ? lattice_cases::graded() : lattice_cases::uniform();
    const std::vector<LatticeNode> nodes = field.lattice_nodes(lattice_cases::box());
    const LatticeGrid grid(nodes);
    ResultDigest result;
    for (std::int32_t slot = 0; slot < grid.slot_count(); ++slot) {
      result.add(grid.centre(slot), grid.low_corner(slot));
      for (std::size_t k = 0; k < 8; ++k) result.add(grid.corner(slot, k));
      if (slot % LatticeGrid::slots_in_block == 0) {
        result.add(grid.is_deep(slot / LatticeGrid::slots_in_block));
      }
    }
    const LatticeBoundary boundary = find_lattice_boundary(nodes, domain);
    result.add(boundary.node2vertex, boundary.is_lattice_face);
    result.add(find_core_nodes(nodes, grid, domain, tree, boundary));
    expect_known(is_graded ? "graded_nodes" : "even_nodes", result);
  }
}

TEST(FillingResults, of_sweeps_are_known) {
  for (const double face_clearance : {0.4, 0.9}) {
    RecoveredSphere ball(2);
    ResultDigest result;
    SweepOptions options;
    options.face_clearance = face_clearance;
    options.progress = result.listener();
    const SweepReport report =
        sweep_points(ball.complex, ball.constrained, ball.inside(), SpacingField(0.25), options);
    result.add(report.sweeps, report.points, ball.constrained);
    test::add_complex(result, ball.complex);
    expect_known(face_clearance > 0.5 ? "sweeps_off_faces" : "sweeps", result);
  }
}

}  // namespace
}  // namespace tetfarm
