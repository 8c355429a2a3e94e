#include "mesh/geometry/cavity_insertion.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>

#include "base/array_index.h"
#include "mesh/geometry/bowyer_watson.h"
#include "mesh/geometry/predicates.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

bool holds(const TetComplex& complex, std::int32_t tet, const Vec3& p) {
  const Tet& n = complex.nodes[at(tet)];
  for (const auto& [a, b, c] : {Triangle{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}) {
    const auto corner = [&](std::int32_t i) { return complex.points[at(n[at(i)])]; };
    if (orient3d(corner(a), corner(b), corner(c), p) < 0) return false;
  }
  return true;
}

void expect_mutual_neighbours(const TetComplex& complex) {
  for (std::int32_t t = 0; at(t) < complex.nodes.size(); ++t) {
    if (!complex.is_live(t)) continue;
    for (int f = 0; f < 4; ++f) {
      const FaceHandle other = complex.neighbours[at(t)][at(f)];
      if (other == no_face) continue;
      ASSERT_EQ(complex.neighbours[at(tet_of(other))][at(face_of(other))], face_handle(t, f));
      auto here = complex.face_nodes(face_handle(t, f));
      auto there = complex.face_nodes(other);
      std::sort(here.begin(), here.end());
      std::sort(there.begin(), there.end());
      ASSERT_EQ(here, there);
    }
  }
}

/// The Delaunay tets of a ball's surface, and a point in their middle that is yet to be inserted:
/// it lies in the sphere of each of them.
struct BallAndMiddle {
  explicit BallAndMiddle(int levels)
      : surface(shapes::sphere({0, 0, 0}, 1, levels)),
        complex(bowyer_watson(surface.vertices).complex),
        node(static_cast<std::int32_t>(complex.points.size())) {
    complex.points.push_back({1e-3, 2e-3, 3e-3});
    while (!complex.is_live(tet) || !holds(complex, tet, complex.points.back())) ++tet;
  }

  SurfaceMesh surface;
  TetComplex complex;
  std::int32_t node;
  std::int32_t tet = 0;
};

class CavityOfABall : public ::testing::TestWithParam<int> {};

TEST_P(CavityOfABall, joins_the_middle_with_the_whole_surface) {
  BallAndMiddle ball(GetParam());
  CavityInsertion insertion(ball.complex);
  ASSERT_TRUE(insertion.find_cavity(ball.node, ball.tet));
  insertion.fill();
  std::size_t star = 0;
  for (std::int32_t t = 0; at(t) < ball.complex.nodes.size(); ++t) {
    const Tet& n = ball.complex.nodes[at(t)];
    const bool has_node = std::find(n.begin(), n.end(), ball.node) != n.end();
    star += ball.complex.is_live(t) && has_node ? 1U : 0U;
  }
  EXPECT_EQ(star, ball.surface.triangles.size());
  expect_mutual_neighbours(ball.complex);
}

INSTANTIATE_TEST_SUITE_P(OfFewAndManyNodes, CavityOfABall, ::testing::Values(2, 5));

TEST(CavityInsertion, of_a_large_cavity_takes_memory_by_its_faces_not_by_their_square) {
  BallAndMiddle ball(5);  // 10242 nodes: 420 MB by the square
  CavityInsertion insertion(ball.complex);
  ASSERT_TRUE(insertion.find_cavity(ball.node, ball.tet));
  const auto peak_kb = [] {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  const auto before = peak_kb();
  insertion.fill();
  EXPECT_LT(peak_kb() - before, 50'000);
}

}  // namespace
}  // namespace tetfarm
