// Delaunay tets, orders and searches, known by their digests (tests/golden/geometry.txt).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "mesh/geometry/bowyer_watson.h"
#include "mesh/geometry/box_tree.h"
#include "mesh/geometry/cavity_insertion.h"
#include "mesh/geometry/fine_point.h"
#include "mesh/geometry/hilbert_order.h"
#include "mesh/geometry/point_location.h"
#include "mesh/geometry/predicates.h"
#include "mesh/geometry/triangle_distance.h"
#include "tests/support/chance.h"
#include "tests/support/complex_digest.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using test::ResultDigest;

Vec3 place(shapes::Chance& chance) {
  const double x = chance.between(-1, 1);
  const double y = chance.between(-1, 1);
  return {x, y, chance.between(-1, 1)};
}

std::vector<Vec3> scattered(int count, std::uint64_t seed) {
  shapes::Chance chance(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(place(chance));
  return points;
}

std::vector<Vec3> lattice(int n) {
  std::vector<Vec3> points;
  for (int i = 0; i < n * n * n; ++i) {
    points.push_back({0.1 * (i % n), 0.1 * (i / n % n), 0.1 * (i / n / n)});
  }
  return points;
}

TEST(GeometryResults, of_delaunay_tets_are_known) {
  std::vector<Vec3> with_doubles = scattered(60, 5);
  with_doubles.push_back(with_doubles[7]);
  with_doubles.push_back(with_doubles[7]);
  with_doubles.push_back(with_doubles[20]);
  const std::vector<std::pair<std::string, std::vector<Vec3>>> cases = {
      {"scattered", scattered(300, 1)},
      {"lattice", lattice(6)},
      {"sphere", shapes::sphere({0, 0, 0}, 1, 2).vertices},
      {"doubles", with_doubles}};
  for (const auto& [name, points] : cases) {
    ResultDigest result;
    const DelaunayTets tets = bowyer_watson(points);
    result.add(tets.duplicates, hilbert_order(points), brio_order(points));
    test::add_complex(result, tets.complex);
    test::expect_known("geometry", name, result);
  }
}

TEST(GeometryResults, of_points_looked_up_and_put_in_are_known) {
  TetComplex complex = bowyer_watson(lattice(5)).complex;
  ResultDigest result;
  shapes::Chance chance(3);
  std::vector<std::uint8_t> constrained(complex.nodes.size(), 0);
  // Both sides of some faces.
  for (std::int32_t t = 0; t < std::ssize(complex.nodes); t += 7) {
    if (!complex.is_live(t)) continue;
    const FaceHandle other = complex.neighbours[static_cast<std::size_t>(t)][0];
    if (other == no_face) continue;
    constrained[static_cast<std::size_t>(t)] |= 1;
    constrained[static_cast<std::size_t>(tet_of(other))] |=
        static_cast<std::uint8_t>(1 << face_of(other));
  }
  CavityInsertion insertion(complex, &constrained);
  std::int32_t last = 0;
  while (!complex.is_live(last)) ++last;
  for (int i = 0; i < 60; ++i) {
    const Vec3 p = 0.2 * place(chance) + Vec3{0.2, 0.2, 0.2};
    const Location location = locate(complex, p, last);
    result.add(location.tet, location.node);
    if (location.tet < 0) continue;
    const auto node = static_cast<std::int32_t>(complex.points.size());
    complex.points.push_back(p);
    complex.node2tet.push_back(-1);
    const bool is_found = insertion.find_cavity(node, location.tet);
    result.add(is_found, insertion.cavity(), insertion.hull());
    if (is_found) {
      last = insertion.fill();
    } else {
      complex.points.pop_back();
      complex.node2tet.pop_back();
    }
  }
  for (const Vec3& p : {Vec3{0.2, 0.2, 0.2}, Vec3{0, 0.1, 0.4}, Vec3{1e9, 0, 0}}) {
    const Location location = locate(complex, p, last);
    result.add(location.tet, location.node);
  }
  result.add(constrained);
  test::add_complex(result, complex);
  test::expect_known("geometry", "insertion", result);
}

TEST(GeometryResults, of_boxes_that_overlap_are_known) {
  std::vector<Box3> boxes;
  shapes::Chance chance(9);
  for (int i = 0; i < 120; ++i) {
    const Vec3 low = place(chance);
    boxes.push_back({low, low + 0.15 * (place(chance) + Vec3{1, 1, 1})});
  }
  const BoxTree tree(boxes);
  ResultDigest result;
  result.add(tree.size());
  tree.self_pairs([&](std::int32_t i, std::int32_t j) { result.add(i, j); });
  for (const Box3& box : boxes) tree.query(box, [&](std::int32_t i) { result.add(i); });
  const SurfaceMesh ball = shapes::sphere({0, 0, 0}, 1, 1);
  for (const Box3& box : triangle_boxes(ball.vertices, ball.triangles)) {
    result.add(box.low, box.high);
  }
  test::expect_known("geometry", "boxes", result);
}

TEST(GeometryResults, of_measures_are_known) {
  ResultDigest result;
  shapes::Chance chance(4);
  for (int i = 0; i < 100; ++i) {
    std::array<Vec3, 5> p;
    for (Vec3& v : p) v = place(chance);
    // A third of them nearly in one plane, a third on one.
    if (i % 3 == 1) p[3] = (p[0] + p[1] + p[2]) / 3.0;
    if (i % 3 == 2) {
      for (Vec3& v : p) v.z = 0.25;
    }
    result.add(orient3d(p[0], p[1], p[2], p[3]));
    result.add(insphere(p[0], p[1], p[2], p[3], p[4]) > 0);
    result.add(distance2_to_triangle(p[3], p[0], p[1], p[2]));
    for (const double far : {0.1, 0.5, 1.0}) {
      result.add(is_nearer_to_triangle(p[4], p[0], p[1], p[2], far));
    }
    const FinePoint q = between(fine(p[0]), fine(p[1]), {0.3, 1e-18});
    result.add(q.high, q.low, orient3d(q, fine(p[2]), fine(p[3]), fine(p[4])));
    const DoubleDouble size = fine_orient3d(q, fine(p[2]), fine(p[3]), fine(p[4]));
    result.add(size.high, size.low);
    for (int axis = 0; axis < 3; ++axis) {
      const double turn = orient2d_along(axis, q, fine(p[2]), fine(p[3]));
      result.add((turn > 0) - (turn < 0));
    }
  }
  test::expect_known("geometry", "measures", result);
}

/// Points on one sphere: of a cube, of an octahedron round it, and on its faces' circles.
std::vector<Vec3> cospherical() {
  std::vector<Vec3> points;
  for (const double x : {-2.0, 2.0}) {
    for (const double y : {-2.0, 2.0}) {
      for (const double z : {-1.0, 1.0}) points.push_back({x, y, z});
    }
  }
  for (const double s : {-3.0, 3.0}) {
    points.push_back({s, 0, 0});
    points.push_back({0, 0, s});
  }
  return points;
}

TEST(GeometryResults, of_perturbed_spheres_are_known_and_say_the_same_however_the_tet_is_turned) {
  const std::vector<Vec3> points = cospherical();
  ResultDigest result;
  std::uint64_t state = 1;
  int decided = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    std::array<std::int32_t, 5> ids;
    for (std::size_t i = 0; i < 5; ++i) {
      do {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        ids[i] = static_cast<std::int32_t>((state >> 33U) % points.size());
      } while (std::count(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(i), ids[i]) > 0);
    }
    const auto p = [&](std::size_t i) { return points[static_cast<std::size_t>(ids[i])]; };
    if (!(orient3d(p(0), p(1), p(2), p(3)) > 0)) continue;
    const std::int32_t order[5] = {ids[0], ids[1], ids[2], ids[3], ids[4]};
    const std::int32_t turned[5] = {ids[1], ids[2], ids[0], ids[3], ids[4]};
    const bool is_in = in_perturbed_sphere(p(0), p(1), p(2), p(3), p(4), order);
    EXPECT_EQ(in_perturbed_sphere(p(1), p(2), p(0), p(3), p(4), turned), is_in);
    EXPECT_EQ(in_perturbed_sphere_exactly(p(0), p(1), p(2), p(3), p(4), order), is_in);
    result.add(is_in);
    decided += is_in ? 1 : 0;
  }
  EXPECT_GT(decided, 200);
  test::expect_known("geometry", "perturbed", result);
}

}  // namespace
}  // namespace tetfarm
