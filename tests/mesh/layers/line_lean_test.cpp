#include "mesh/layers/line_lean.h"

#include <gtest/gtest.h>

#include <numeric>

#include "base/array_index.h"
#include "mesh/layers/marching_direction.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// The whole of a surface as the wall, and the best direction of each line at it.
struct Ground {
  WallGraph graph;
  WallPlanes planes;
  std::vector<Vec3> normals;
  std::vector<Vec3> places;
  std::vector<Vec3> along;

  explicit Ground(const SurfaceMesh& surface) {
    std::vector<std::int32_t> all(surface.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    graph = wall_graph(surface, all);
    planes = wall_planes(surface, graph);
    places = surface.vertices;
    for (const Triangle& t : surface.triangles) {
      const Vec3 a = surface.vertices[at(t[0])];
      normals.push_back(
          normalized(cross(surface.vertices[at(t[2])] - a, surface.vertices[at(t[1])] - a)));
    }
    for (std::size_t i = 0; i < graph.feet.size(); ++i) {
      const MarchingDirection best = marching_direction(normals_at(view(), i));
      along.push_back(best.direction / best.visibility);
    }
  }
  LineGround view() const { return {graph, planes, normals, places}; }
};

TEST(LineLean, straight_lines_go_on_as_they_begin) {
  const Ground cube(shapes::box({0, 0, 0}, {1, 1, 1}, 4));
  EXPECT_EQ(leaning(cube.view(), cube.along, Lean::straight), cube.along);
}

TEST(LineLean, lines_keep_a_share_of_what_they_see_and_the_height_above_their_worst_face) {
  const Ground cube(shapes::box({0, 0, 0}, {1, 1, 1}, 6));
  for (const Lean lean : {Lean::as_neighbours, Lean::as_nearest, Lean::from_wall}) {
    const std::vector<Vec3> later = leaning(cube.view(), cube.along, lean);
    for (std::size_t i = 0; i < later.size(); ++i) {
      const std::vector<Vec3> normals = normals_at(cube.view(), i);
      const double before = visibility(normalized(cube.along[i]), normals);
      const double seen = visibility(normalized(later[i]), normals);
      EXPECT_GE(seen, 0.6 * before - 1e-12);
      EXPECT_NEAR(norm(later[i]) * seen, 1, 1e-12);
    }
  }
}

TEST(LineLean, lines_on_flat_faces_lean_away_from_concave_edges) {
  // Inside a cube edges are concave: lines next to them lean towards the middle.
  const Ground cube(shapes::box({0, 0, 0}, {1, 1, 1}, 8));
  const std::vector<Vec3> later = leaning(cube.view(), cube.along, Lean::as_neighbours);
  for (std::size_t i = 0; i < later.size(); ++i) {
    const Vec3 p = cube.places[i];
    if (p.z != 0 || p.x != 0.125 || p.y != 0.5) continue;
    EXPECT_EQ(cube.along[i].x, 0);
    EXPECT_GT(later[i].x, 0.1);
    EXPECT_NEAR(later[i].z, 1, 1e-12) << "as high above the floor";
  }
}

TEST(LineLean, a_line_that_does_not_move_has_no_say) {
  Ground cube(shapes::box({0, 0, 0}, {1, 1, 1}, 4));
  std::vector<Vec3> along = cube.along;
  along[3] = {};
  for (const Lean lean : all_leans) {
    EXPECT_EQ(leaning(cube.view(), along, lean)[3], Vec3{});
  }
  const std::vector<Vec3> none(along.size());
  EXPECT_EQ(leaning(cube.view(), none, Lean::as_nearest), none);
}

/// Two nodes next to each other among others far away: they come to go the same way.
TEST(LineLean, near_neighbours_count_more_where_distances_are_asked) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 4);
  // A node of the floor is drawn to the edge.
  std::size_t moved = 0;
  for (std::size_t v = 0; v < box.vertices.size(); ++v) {
    if (box.vertices[v] == Vec3{0.25, 0.5, 0}) moved = v;
  }
  box.vertices[moved].x = 0.001;
  const Ground ground(box);
  const std::vector<Vec3> mean = leaning(ground.view(), ground.along, Lean::as_neighbours);
  const std::vector<Vec3> nearest = leaning(ground.view(), ground.along, Lean::as_nearest);
  EXPECT_GT(normalized(nearest[moved]).x, normalized(mean[moved]).x + 0.05);
}

/// A row of nodes is 0.001 away from an edge: each sees one face, and those of the edge see two.
TEST(LineLean, nodes_that_are_near_to_each_other_go_the_same_way_from_the_wall) {
  SurfaceMesh box = shapes::box({0, 0, 0}, {1, 1, 1}, 4);
  for (Vec3& p : box.vertices) {
    if (p.x == 0.25) p.x = 0.001;
  }
  const Ground ground(box);
  const std::vector<Vec3> ways = leaning(ground.view(), ground.along, Lean::from_wall);
  int pairs = 0;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    if (!(ground.places[i] == Vec3{0.001, 0.5, 0})) continue;
    for (std::size_t j = 0; j < ways.size(); ++j) {
      if (!(ground.places[j] == Vec3{0, 0.5, 0})) continue;
      EXPECT_GT(norm(cross(normalized(ground.along[i]), normalized(ground.along[j]))), 0.7);
      EXPECT_LT(norm(cross(normalized(ways[i]), normalized(ways[j]))), 1e-4);
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, 1);
}

}  // namespace
}  // namespace tetfarm
