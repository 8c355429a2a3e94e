#include "mesh/inspect/surface_check.h"

#include <gmock/gmock.h>

#include <limits>
#include <numeric>

#include "mesh/core/validate.h"
#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

SurfaceMesh cube(double low, double high) {
  return shapes::box({low, low, low}, {high, high, high}, 2);
}

void expect_domain(const CheckedSurface& checked, double volume) {
  EXPECT_THAT(kinds(checked.report), IsEmpty());
  EXPECT_THAT(unmatched_edges(checked.surface.triangles), IsEmpty());
  EXPECT_NEAR(checked.report.volume, volume, 1e-12 * volume);
  EXPECT_NEAR(enclosed_volume(checked.surface.vertices, checked.surface.triangles), volume,
              1e-9 * volume);
}

TEST(SurfaceCheck, leaves_a_good_surface_as_it_is) {
  const SurfaceMesh mesh = shapes::nested_spheres(2);
  const CheckedSurface checked = check_surface(mesh);
  EXPECT_THAT(checked.report.remarks, IsEmpty());
  EXPECT_EQ(checked.surface.triangles, mesh.triangles);
  EXPECT_EQ(checked.surface.vertices, mesh.vertices);
  expect_domain(checked, enclosed_volume(mesh.vertices, mesh.triangles));
}

TEST(SurfaceCheck, turns_a_body_that_faces_inward) {
  SurfaceMesh mesh = shapes::unit_cube();
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  const CheckedSurface checked = check_surface(mesh);
  expect_domain(checked, 1);
  EXPECT_TRUE(checked.report.shells[0].was_flipped);
  EXPECT_THAT(checked.report.remarks,
              ElementsAre("shell 0 (12 triangles) was oriented inward; turned by nesting"));
}

TEST(SurfaceCheck, repairs_random_flips_and_counts_them) {
  const SurfaceMesh good = shapes::nested_spheres(2);
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    std::mt19937 random(seed);
    SurfaceMesh mesh = good;
    std::size_t turned = 0;
    for (std::size_t t = 0; t < 320; ++t) {  // the outer shell
      if (below(random, 4) != 0) continue;
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
      ++turned;
    }
    const CheckedSurface checked = check_surface(mesh);
    EXPECT_EQ(checked.surface.triangles, good.triangles);
    EXPECT_THAT(checked.report.remarks,
                ElementsAre(HasSubstr("shell 0 (320 triangles): " + std::to_string(turned) +
                                      " triangles faced the other way")));
    EXPECT_FALSE(checked.report.shells[0].was_flipped);
  }
}

TEST(SurfaceCheck, orients_nested_shells_by_depth_however_they_come) {
  const SurfaceMesh mesh = joined(joined(cube(0, 8), cube(1, 7)), joined(cube(2, 6), cube(3, 5)));
  for (unsigned way = 0; way < 16; ++way) {
    SurfaceMesh given = mesh;
    for (std::size_t t = 0; t < given.triangles.size(); ++t) {
      if ((way >> (t / 48) & 1U) != 0) std::swap(given.triangles[t][1], given.triangles[t][2]);
    }
    const CheckedSurface checked = check_surface(given);
    expect_domain(checked, 512 - 216 + 64 - 8);
    std::vector<int> depths;
    for (const Shell& shell : checked.report.shells) depths.push_back(shell.depth);
    EXPECT_THAT(depths, ElementsAre(0, 1, 2, 3));
    EXPECT_EQ(checked.report.shells[3].parent, 2);
    // Outward cubes are right at even depth, reversed ones at odd.
    EXPECT_EQ(checked.report.shells[0].was_flipped, (way & 1U) != 0);
    EXPECT_EQ(checked.report.shells[1].was_flipped, (way & 2U) == 0);
  }
}

TEST(SurfaceCheck, takes_several_bodies_side_by_side) {
  const CheckedSurface checked = check_surface(joined(cube(0, 1), cube(2, 4)));
  expect_domain(checked, 9);
  EXPECT_EQ(checked.report.shells[1].parent, -1);
  EXPECT_DOUBLE_EQ(checked.report.shells[1].volume, 8);
}

TEST(SurfaceCheck, allows_bodies_that_share_a_corner_but_says_so) {
  const CheckedSurface checked = check_surface(welded(joined(cube(0, 1), cube(1, 2))));
  expect_domain(checked, 2);
  EXPECT_THAT(checked.report.remarks,
              Contains(HasSubstr("touches itself at 1 single point: vertex")));
  EXPECT_THAT(checked.report.remarks, Contains(HasSubstr("(1, 1, 1)")));
}

TEST(SurfaceCheck, allows_a_very_thin_wedge) {
  SurfaceMesh mesh = shapes::tetrahedron();
  mesh.vertices[3] = {0.3, 0.3, 1e-14};
  expect_domain(check_surface(mesh), 1e-14 / 6);
}

TEST(SurfaceCheck, names_each_kind_of_defect) {
  SurfaceMesh open = cube(0, 1);
  open.triangles.pop_back();
  EXPECT_THAT(kinds_of(open), ElementsAre("open edge"));
  EXPECT_THAT(kinds_of(joined(cube(0, 2), cube(1, 3))), ElementsAre("self-intersection"));
  EXPECT_THAT(kinds_of({}), ElementsAre("too few triangles"));
  SurfaceMesh twice = cube(0, 1);
  twice.triangles.push_back(twice.triangles[3]);
  EXPECT_THAT(kinds_of(twice), ElementsAre("duplicate triangle"));
  SurfaceMesh nan = cube(0, 1);
  nan.vertices[0].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(kinds_of(nan), ElementsAre("bad coordinate", "open edge"));
  SurfaceMesh folded = shapes::tetrahedron();
  folded.vertices[3] = {0.3, 0.3, 0};
  EXPECT_THAT(kinds_of(folded), ElementsAre("self-intersection"));
}

TEST(SurfaceCheck, returns_a_defective_surface_as_given) {
  SurfaceMesh mesh = joined(cube(0, 2), cube(1, 3));
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  const CheckedSurface checked = check_surface(mesh);
  EXPECT_EQ(checked.surface.triangles, mesh.triangles);
  EXPECT_EQ(checked.report.volume, 0);
  EXPECT_EQ(checked.report.shells.size(), 2U);
}

TEST(SurfaceCheck, says_the_same_whatever_the_order_of_triangles_and_corners) {
  const std::vector<SurfaceMesh> meshes = {
      shapes::nested_spheres(1), joined(cube(0, 2), cube(1, 3)),
      welded(joined(cube(0, 1), cube(1, 2))), joined(shapes::torus(0.3, 9, 6), cube(-0.2, 0.2))};
  for (const SurfaceMesh& mesh : meshes) {
    const CheckedSurface before = check_surface(mesh);
    std::mt19937 random(7);
    for (int repeat = 0; repeat < 5; ++repeat) {
      SurfaceMesh mixed = mesh;
      for (std::size_t i = mixed.triangles.size(); i > 1; --i) {
        std::swap(mixed.triangles[i - 1], mixed.triangles[below(random, i)]);
      }
      for (Triangle& t : mixed.triangles) {
        std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(below(random, 3)), t.end());
      }
      const CheckedSurface after = check_surface(mixed);
      EXPECT_EQ(kinds(after.report), kinds(before.report));
      EXPECT_EQ(after.report.shells.size(), before.report.shells.size());
      EXPECT_NEAR(after.report.volume, before.report.volume, 1e-12);
      if (!before.report.defects.empty()) {
        EXPECT_EQ(after.report.defects[0].triangles.size(),
                  before.report.defects[0].triangles.size());
      }
    }
  }
}

TEST(SurfaceCheck, says_the_same_of_a_turned_surface) {
  // Rational rotations, then rounded: nothing stays on a plane of the axes.
  const auto turned = [](SurfaceMesh mesh) {
    for (Vec3& p : mesh.vertices) {
      p = {0.36 * p.x + 0.48 * p.y - 0.8 * p.z, -0.8 * p.x + 0.6 * p.y,
           0.48 * p.x + 0.64 * p.y + 0.6 * p.z};
    }
    return mesh;
  };
  for (const SurfaceMesh& mesh :
       {shapes::nested_spheres(2), joined(joined(cube(0, 8), cube(1, 7)), cube(2, 6)),
        joined(shapes::torus(0.3, 9, 6), cube(-0.2, 0.2)),
        joined(cube(0, 2), shapes::box({1, 1, 1}, {3, 4, 5}, 3))}) {
    SurfaceMesh other = mesh;
    const CheckedSurface before = check_surface(mesh);
    for (int i = 0; i < 3; ++i) {
      other = turned(other);
      const CheckedSurface after = check_surface(other);
      EXPECT_EQ(kinds(after.report), kinds(before.report));
      EXPECT_NEAR(after.report.volume, before.report.volume, 1e-9);
      ASSERT_EQ(after.report.shells.size(), before.report.shells.size());
      for (std::size_t s = 0; s < before.report.shells.size(); ++s) {
        EXPECT_EQ(after.report.shells[s].depth, before.report.shells[s].depth);
      }
    }
  }
}

TEST(SurfaceCheck, counts_vertices_of_no_triangle) {
  SurfaceMesh mesh = cube(0, 1);
  mesh.vertices.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  const CheckedSurface checked = check_surface(mesh);
  EXPECT_THAT(kinds(checked.report), IsEmpty());
  EXPECT_THAT(checked.report.remarks, ElementsAre("vertices in no triangle: 1"));
}

}  // namespace
}  // namespace tetfarm
