#include "mesh/adaptation/conservative_transfer.h"

#include <gtest/gtest.h>

#include "mesh/adaptation/solution_interpolation.h"
#include "tests/mesh/adaptation/transfer_shapes.h"

namespace tetfarm {
namespace {

using Field = std::vector<double>;

Field conserved(const PlaneMesh& from, const Field& values, const PlaneMesh& to) {
  const TriangleComplex complex = checked_complex(from);
  const TriangleComplex target = checked_complex(to);
  const MeshLocation location(complex);
  const std::vector<Field> fields{values};
  return transferred_conservatively(location, fields, target, locate_nodes(location, target))
      .fields.front();
}

double integral(const PlaneMesh& mesh, const Field& values) {
  return field_integral(checked_complex(mesh), values);
}

TEST(ConservativeTransfer, keeps_integrals_of_random_fields_between_unrelated_meshes) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const PlaneMesh from = plane_test::shaken_square(9 + static_cast<int>(seed), seed);
    const PlaneMesh to = plane_test::shaken_square(17 - static_cast<int>(seed), seed + 10);
    const Field before = plane_test::random_field(from, seed);
    const Field after = conserved(from, before, to);
    EXPECT_NEAR(integral(to, after), integral(from, before), 1e-14);
  }
}

TEST(ConservativeTransfer, keeps_integrals_where_triangles_are_thin) {
  const PlaneMesh from = plane_test::thin_square(20, 1, 0.4, 1e-5);
  const PlaneMesh to = plane_test::thin_square(23, 2, 0.41, 1e-4);
  const Field before = plane_test::random_field(from, 3);
  const Field after = conserved(from, before, to);
  EXPECT_NEAR(integral(to, after), integral(from, before), 1e-12);
  EXPECT_GE(plane_test::least(after), plane_test::least(before));
  EXPECT_LE(plane_test::greatest(after), plane_test::greatest(before));
}

TEST(ConservativeTransfer, keeps_integrals_far_from_the_origin) {
  PlaneMesh from = plane_test::shaken_square(10, 1);
  PlaneMesh to = plane_test::shaken_square(12, 2);
  for (PlaneMesh* mesh : {&from, &to}) {
    for (Vec2& p : mesh->points) p = {p.x + 65536, p.y - 32768};
  }
  const Field before = plane_test::random_field(from, 3);
  EXPECT_NEAR(integral(to, conserved(from, before, to)), integral(from, before), 1e-11);
}

TEST(ConservativeTransfer, is_exact_for_linear_fields) {
  const PlaneMesh from = plane_test::shaken_square(11, 1);
  const PlaneMesh to = plane_test::thin_square(17, 2, 0.4, 1e-2);
  const auto linear = [](const Vec2& p) { return 100 + 5 * p.x - 7 * p.y; };
  const Field values = conserved(from, plane_test::field_of_points(from, linear), to);
  EXPECT_LT(plane_test::greatest_error(to, values, linear), 1e-11);
}

TEST(ConservativeTransfer, gives_constants_back) {
  const PlaneMesh from = plane_test::disc(7);
  const PlaneMesh to = plane_test::disc(12);
  for (const double value : conserved(from, Field(from.points.size(), 0.1), to)) {
    EXPECT_EQ(value, 0.1);
  }
}

TEST(ConservativeTransfer, of_a_mesh_onto_itself_changes_nothing) {
  const PlaneMesh mesh = plane_test::shaken_square(9, 4);
  const Field before = plane_test::random_field(mesh, 5);
  const Field after = conserved(mesh, before, mesh);
  for (std::size_t v = 0; v < before.size(); ++v) EXPECT_NEAR(after[v], before[v], 1e-12);
}

TEST(ConservativeTransfer, stays_within_the_values_round_a_node) {
  // A step in the middle of the square: away from it nothing changes.
  const PlaneMesh from = plane_test::shaken_square(20, 1);
  const PlaneMesh to = plane_test::shaken_square(27, 2);
  const auto step = [](const Vec2& p) { return p.x < 0.5 ? -1.0 : 1.0; };
  const Field after = conserved(from, plane_test::field_of_points(from, step), to);
  for (std::size_t v = 0; v < after.size(); ++v) {
    EXPECT_LE(std::abs(after[v]), 1);
    if (std::abs(to.points[v].x - 0.5) > 0.2) {
      EXPECT_NEAR(after[v], step(to.points[v]), 1e-14);
    }
  }
}

TEST(ConservativeTransfer, is_of_second_order) {
  const auto smooth = [](const Vec2& p) { return std::sin(3 * p.x) * std::cos(2 * p.y); };
  std::array<double, 2> errors{};
  for (std::size_t k = 0; k < 2; ++k) {
    const int n = k == 0 ? 20 : 40;
    const PlaneMesh from = plane_test::shaken_square(n, 1);
    const PlaneMesh to = plane_test::shaken_square(n + 3, 2);
    const Field values = conserved(from, plane_test::field_of_points(from, smooth), to);
    errors[k] = plane_test::greatest_error(to, values, smooth);
  }
  EXPECT_LT(errors[1], errors[0] / 3);
}

TEST(ConservativeTransfer, keeps_what_is_covered_where_a_curve_is_refined) {
  const PlaneMesh from = plane_test::square_with_hole(0.3, 6, 8);
  const PlaneMesh to = plane_test::square_with_hole(0.3, 16, 20);
  const auto linear = [](const Vec2& p) { return 2 + p.x - p.y; };
  const Field before = plane_test::field_of_points(from, linear);
  const Field after = conserved(from, before, to);
  EXPECT_GE(plane_test::least(after), plane_test::least(before));
  EXPECT_LE(plane_test::greatest(after), plane_test::greatest(before));
  // Nothing but the new slivers between chord and circle is added or lost: a share of the hole.
  const double hole = plane_test::area(from) - plane_test::area(to);
  EXPECT_NEAR(integral(from, before) - integral(to, after), 2 * hole, 0.02 * std::abs(2 * hole));
}

TEST(ConservativeTransfer, gives_what_is_not_covered_the_closest_values) {
  const PlaneMesh from = plane_test::square(8);
  PlaneMesh to = plane_test::square(10);
  for (Vec2& p : to.points) p.x *= 2;
  const auto field = [](const Vec2& p) { return p.y; };
  const Field before = plane_test::field_of_points(from, field);
  const TriangleComplex complex = checked_complex(from);
  const TriangleComplex target = checked_complex(to);
  const MeshLocation location(complex);
  const ConservedFields result = transferred_conservatively(location, std::vector<Field>{before},
                                                            target, locate_nodes(location, target));
  EXPECT_NEAR(result.covered_area, 1, 1e-14);
  EXPECT_LT(plane_test::greatest_error(to, result.fields[0], field), 1e-13);
}

TEST(ConservativeTransfer, keeps_to_its_side_of_a_thin_wall) {
  // A gap of 0.02 parts a disc from a ring; the fields are 1 and -1 on its two sides.
  const PlaneMesh from = plane_test::disc_in_a_narrow_gap();
  PlaneMesh to = from;
  // The nodes of the gap's two sides change places, nearly: each side is beyond the other.
  for (Vec2& p : to.points) {
    const double radius = std::hypot(p.x, p.y);
    const bool is_joined = p.x > 0 && p.y < 0.2 && p.y > -1.1 && std::atan2(p.y, p.x) < 0.1;
    if (std::abs(radius - 1.01) > 0.02 || is_joined) continue;
    const double moved = radius < 1.01 ? 1.021 : 0.999;
    p = {p.x * moved / radius, p.y * moved / radius};
  }
  const auto side = [](const Vec2& p) { return std::hypot(p.x, p.y) < 1.01 ? 1.0 : -1.0; };
  const Field before = plane_test::field_of_points(from, side);
  const Field after = conserved(from, before, to);
  for (int ring = 0; ring < 9; ++ring) {
    for (int k = 8; k < 76; ++k) {
      const std::size_t v = at(ring * 96 + k);
      EXPECT_EQ(after[v], before[v]) << ring << " " << k;
    }
  }
}

TEST(ConservativeTransfer, keeps_a_shock_over_twenty_transfers_where_interpolation_drifts) {
  const PlaneMesh a = plane_test::shaken_square(30, 1);
  const PlaneMesh b = plane_test::shaken_square(33, 2);
  const Field first =
      plane_test::field_of_points(a, [](const Vec2& p) { return 1 + plane_test::curved_shock(p); });
  Field kept = first;
  Field interpolated_ones = first;
  const TriangleComplex complex_a = checked_complex(a);
  const TriangleComplex complex_b = checked_complex(b);
  const auto a_in_b = locate_nodes(MeshLocation(complex_b), complex_a);
  const auto b_in_a = locate_nodes(MeshLocation(complex_a), complex_b);
  for (int cycle = 0; cycle < 10; ++cycle) {
    kept = conserved(b, conserved(a, kept, b), a);
    interpolated_ones =
        interpolated(complex_b, interpolated(complex_a, interpolated_ones, b_in_a), a_in_b);
  }
  const double before = integral(a, first);
  EXPECT_NEAR(integral(a, kept), before, 1e-12 * before);
  EXPECT_GT(std::abs(integral(a, interpolated_ones) - before), 1e-6 * before);
}

}  // namespace
}  // namespace tetfarm
