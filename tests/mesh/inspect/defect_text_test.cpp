#include "mesh/inspect/defect_text.h"

#include <gmock/gmock.h>

#include <limits>

#include "base/error.h"
#include "mesh/inspect/outer_boundary.h"
#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"
#include "tests/support/voxel_surface.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(DefectText, of_a_triangle_has_its_number_and_its_corners) {
  EXPECT_EQ(triangle_text(shapes::tetrahedron(), 1), "triangle 1 (0, 0, 0) (0, 0, 1) (0, 1, 0)");
}

TEST(DefectText, names_three_places_and_counts_the_others) {
  EXPECT_EQ(with_places("what", {}, 0), "what");
  EXPECT_EQ(with_places("what", {"a"}, 1), "what: a");
  EXPECT_EQ(with_places("what", {"a", "b", "c"}, 3), "what: a; b; c");
  EXPECT_EQ(with_places("what", {"a", "b", "c"}, 4), "what: a; b; c; and 1 more");
  EXPECT_EQ(with_places("what", {"a", "b", "c", "d", "e"}, 9), "what: a; b; c; and 6 more");
  EXPECT_EQ(with_places("what", {"a"}, 3), "what: a; and 2 more");
}

TEST(DefectText, of_triangles_lists_all_of_them_and_names_some) {
  const SurfaceMesh surface = shapes::tetrahedron();
  const SurfaceDefect one = defect_of_triangles(surface, "kind", "what", {3});
  EXPECT_EQ(one.kind, "kind");
  EXPECT_EQ(one.message, "what: triangle 3 (0, 0, 0) (0, 1, 0) (1, 0, 0)");
  EXPECT_THAT(one.triangles, ElementsAre(3));
  const SurfaceDefect all = defect_of_triangles(surface, "kind", "what", {0, 1, 2, 3});
  EXPECT_EQ(all.message,
            "what: triangle 0 (1, 0, 0) (0, 1, 0) (0, 0, 1); "
            "triangle 1 (0, 0, 0) (0, 0, 1) (0, 1, 0); "
            "triangle 2 (0, 0, 0) (1, 0, 0) (0, 0, 1); and 1 more");
  EXPECT_THAT(all.triangles, ElementsAre(0, 1, 2, 3));
}

TEST(DefectText, of_defects_has_a_line_for_each) {
  EXPECT_EQ(defects_text({{"one kind", "at this place", {1}}, {"another", "at that", {}}}),
            "the surface cannot be meshed\n  one kind: at this place\n  another: at that");
}

/// The defects of a surface, a line each, with their triangles.
std::vector<std::string> defects_of(const SurfaceMesh& surface, const RegionRules& rules = {}) {
  std::vector<std::string> lines;
  for (const SurfaceDefect& defect : check_surface(surface, rules).report.defects) {
    std::string line = defect.kind + ": " + defect.message + " [";
    for (const std::int64_t t : defect.triangles) line += " " + std::to_string(t);
    lines.push_back(line + " ]");
  }
  return lines;
}

TEST(SurfaceCheck, says_of_each_defect_what_is_wrong_and_where_word_by_word) {
  EXPECT_THAT(defects_of({}), ElementsAre("too few triangles: no triangles at all [ ]"));
  SurfaceMesh surface = shapes::tetrahedron();
  EXPECT_THAT(defects_of(surface), IsEmpty());
  surface.triangles.pop_back();
  EXPECT_THAT(
      defects_of(surface),
      ElementsAre("too few triangles: only 3 triangles; a closed surface has at least 4 [ 0 1 2 ]",
                  "open edge: 3 open edges (on one triangle only): edge from vertex 0 (0, 0, 0) to "
                  "1 (1, 0, 0) of triangle 2; edge from vertex 0 (0, 0, 0) to 2 (0, 1, 0) of "
                  "triangle 1; edge from vertex 1 (1, 0, 0) to 2 (0, 1, 0) of triangle 0 "
                  "[ 0 1 2 ]"));
  surface = shapes::tetrahedron();
  surface.triangles.push_back({0, 7, -1});
  EXPECT_THAT(defects_of(surface),
              ElementsAre("bad vertex number: 1 triangle with vertex numbers outside 0 to 3: "
                          "triangle 4 has vertices 0, 7, -1 [ 4 ]"));
  surface = shapes::tetrahedron();
  surface.vertices.push_back({1e61, 0, 0});
  surface.vertices.push_back({0, 1e-61, 0});
  surface.triangles.push_back({0, 1, 4});
  surface.triangles.push_back({0, 1, 5});
  EXPECT_THAT(defects_of(surface),
              ElementsAre("bad coordinate: 2 triangles with a coordinate that is not a number, or "
                          "beyond 1e60, or below 1e-60 but not 0: triangle 4 (0, 0, 0) (1, 0, 0) "
                          "(1e+61, 0, 0); triangle 5 (0, 0, 0) (1, 0, 0) (0, 1e-61, 0) [ 4 5 ]"));
  surface = shapes::tetrahedron();
  surface.triangles.push_back({2, 0, 2});
  surface.triangles.push_back({0, 1, 2});
  EXPECT_THAT(
      defects_of(surface),
      ElementsAre("degenerate triangle: 1 triangle without area: triangle 4 (0, 1, 0) (0, 0, 0) "
                  "(0, 1, 0) [ 4 ]",
                  "duplicate triangle: 1 triangle present more than once: triangle 3 (0, 0, 0) "
                  "(0, 1, 0) (1, 0, 0) again as 5 [ 3 5 ]"));
}

TEST(SurfaceCheck, says_of_sheets_that_end_inside_how_many_edges_they_hang_on_word_by_word) {
  SurfaceMesh surface = shapes::tetrahedron();
  surface.vertices.push_back({-1, -1, -1});
  surface.triangles.push_back({0, 1, 4});
  const std::string of_one =
      "open edge: 2 open edges (on one triangle only); 1 edge is on more than two triangles: a "
      "sheet that ends inside a region divides nothing; remove it, or continue it to the boundary: "
      "edge from vertex 0 (0, 0, 0) to 4 (-1, -1, -1) of triangle 4; edge from vertex 1 (1, 0, 0) "
      "to 4 (-1, -1, -1) of triangle 4 [ 4 ]";
  EXPECT_THAT(defects_of(surface), ElementsAre(of_one));
  surface.vertices.push_back({2, 2, 2});
  surface.triangles.push_back({2, 3, 5});
  ASSERT_EQ(defects_of(surface).size(), 1U);
  EXPECT_THAT(
      defects_of(surface)[0],
      ::testing::StartsWith("open edge: 4 open edges (on one triangle only); 2 edges are on "
                            "more than two triangles: a sheet that ends inside"));
}

TEST(SurfaceCheck, takes_coordinates_up_to_the_limits_of_its_exact_tests) {
  SurfaceMesh surface = shapes::tetrahedron();
  for (Vec3& p : surface.vertices) p *= 1e60;
  EXPECT_THAT(defects_of(surface), IsEmpty());
  surface = shapes::tetrahedron();
  for (Vec3& p : surface.vertices) p *= 1e-60;
  EXPECT_THAT(defects_of(surface), IsEmpty());
}

TEST(SurfaceCheck, says_which_triangles_meet_word_by_word) {
  SurfaceMesh both = joined(shapes::tetrahedron(), shapes::tetrahedron());
  for (std::size_t v = 4; v < 8; ++v) both.vertices[v] += Vec3{0.25, 0.25, -0.125};
  const auto lines = defects_of(both);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0],
            "self-intersection: 4 pairs of triangles that intersect or touch, 4 triangles in all: "
            "triangle 0 (1, 0, 0) (0, 1, 0) (0, 0, 1) meets triangle 5 (0.25, 0.25, -0.125) (0.25, "
            "0.25, 0.875) (0.25, 1.25, -0.125); triangle 0 (1, 0, 0) (0, 1, 0) (0, 0, 1) meets "
            "triangle 6 (0.25, 0.25, -0.125) (1.25, 0.25, -0.125) (0.25, 0.25, 0.875); triangle 3 "
            "(0, 0, 0) (0, 1, 0) (1, 0, 0) meets triangle 5 (0.25, 0.25, -0.125) (0.25, 0.25, "
            "0.875) (0.25, 1.25, -0.125); and 1 more [ 0 3 5 6 ]");
}

TEST(SurfaceCheck, says_that_a_surface_has_one_side_only_word_by_word) {
  // The projective plane of six vertices, in four dimensions; only its connections matter here.
  SurfaceMesh plane;
  plane.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0.5}, {0.5, 1, 1}};
  plane.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                     {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
  const SurfaceReport report = check_surface(plane).report;
  ASSERT_FALSE(report.defects.empty());
  const SurfaceDefect& defect = report.defects[0];
  EXPECT_EQ(defect.kind, "non-orientable shell");
  const std::size_t count = defect.triangles.size();
  EXPECT_THAT(defect.message,
              ::testing::StartsWith("the surface has only one side, like a Möbius strip: however "
                                    "they are turned, neighbours disagree at " +
                                    std::to_string(count) + " triangles: triangle "));
  for (std::size_t i = 0; i + 1 < count; ++i) {
    EXPECT_LT(defect.triangles[i], defect.triangles[i + 1]) << "each once";
  }
}

TEST(SurfaceCheck, remarks_what_it_has_turned_word_by_word) {
  SurfaceMesh inward = shapes::tetrahedron();
  for (Triangle& t : inward.triangles) std::swap(t[0], t[1]);
  EXPECT_THAT(check_surface(inward).report.remarks,
              ElementsAre("shell 0 (4 triangles) was oriented inward; turned by nesting"));
  SurfaceMesh one_turned = shapes::tetrahedron();
  std::swap(one_turned.triangles[2][0], one_turned.triangles[2][1]);
  EXPECT_THAT(check_surface(one_turned).report.remarks,
              ElementsAre("shell 0 (4 triangles): 1 triangle faced the other way than the rest and "
                          "had to be turned"));
  EXPECT_FALSE(check_surface(one_turned).report.shells[0].was_flipped);
  SurfaceMesh nested = joined(shapes::sphere({0, 0, 0}, 2, 0), shapes::sphere({0, 0, 0}, 1, 0));
  EXPECT_THAT(check_surface(nested).report.remarks,
              ElementsAre("shell 1 (20 triangles) was oriented outward; turned by nesting"));
  nested.vertices.push_back({9, 9, 9});
  nested.vertices.push_back({9, 9, 8});
  EXPECT_THAT(check_surface(nested).report.remarks,
              ElementsAre("vertices in no triangle: 2",
                          "shell 1 (20 triangles) was oriented outward; turned by nesting"));
}

TEST(SurfaceCheck, remarks_where_a_surface_touches_itself_word_by_word) {
  SurfaceMesh both = joined(shapes::tetrahedron(), shapes::tetrahedron());
  for (std::size_t v = 4; v < 8; ++v) both.vertices[v] *= -1;
  for (std::size_t t = 4; t < 8; ++t) std::swap(both.triangles[t][0], both.triangles[t][1]);
  both = welded(both);
  EXPECT_THAT(check_surface(both).report.remarks,
              ElementsAre("the surface touches itself at 1 single point: vertex 0 (0, 0, 0)",
                          "vertices in no triangle: 1"));
}

std::string refusal_of(const RegionRules& rules) {
  try {
    check_surface(shapes::nested_spheres(0), rules);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "none";
}

TEST(Regions, refuse_points_word_by_word) {
  EXPECT_EQ(refusal_of({.wishes = {{.at = {0.7, 0, 0.1}, .name = "shell"}}}), "none");
  EXPECT_EQ(refusal_of({.wishes = {{.at = {5, 0, 0.5}, .name = "far"}}}),
            "region.at: the point (5, 0, 0.5) is outside the surface");
  EXPECT_EQ(
      refusal_of({.wishes = {{.at = {5, 0, 0}, .name = "far", .is_void = true}},
                  .is_outside_meshed = true}),
      "region.at: the point (5, 0, 0) is outside the surface, which is to be meshed up to the "
      "outer boundary");
  EXPECT_EQ(
      refusal_of({.wishes = {{.at = {0, 0, 0}, .name = "a"}, {.at = {0.1, 0, 0}, .name = "b"}}}),
      "region.at: the point (0.1, 0, 0) is in the same region as (0, 0, 0)");
  const Vec3 corner = shapes::nested_spheres(0).vertices[0];
  EXPECT_THAT(refusal_of({.wishes = {{.at = corner, .name = "edge"}}}),
              ::testing::EndsWith("is on the surface, so it cannot tell which side is meant"));
}

TEST(Regions, remark_what_is_turned_and_left_out_word_by_word) {
  const SurfaceMesh nested =
      joined(shapes::sphere({0, 0, 0}, 2, 0), shapes::sphere({0, 0, 0}, 1, 0));
  const CheckedSurface hollow =
      check_surface(nested, {.wishes = {{.at = {1.4, 0, 0.1}, .name = "shell"}}});
  EXPECT_THAT(hollow.report.remarks,
              ElementsAre("20 triangles pointed into the domain and had to be turned"));
  ASSERT_EQ(hollow.report.regions.size(), 2U);
  EXPECT_EQ(hollow.report.regions[0].name, "shell");
  EXPECT_EQ(hollow.report.regions[0].number, 1);
  EXPECT_EQ(hollow.report.regions[1].name, "");
  EXPECT_EQ(hollow.report.regions[1].number, 0);
  EXPECT_EQ(hollow.report.volume, hollow.report.regions[0].volume);
  const CheckedSurface core =
      check_surface(nested, {.wishes = {{.at = {1.4, 0, 0.1}, .name = "", .is_void = true},
                                        {.at = {0, 0, 0}, .name = ""}}});
  EXPECT_THAT(core.report.remarks,
              ElementsAre("20 triangles with no meshed region on either side: left out"));
  EXPECT_THAT(core.surface.region_names, ElementsAre("region 1"));
  const CheckedSurface outside = check_surface(
      nested, {.wishes = {{.at = {0, 0, 0}, .name = "core"}}, .is_outside_meshed = true});
  EXPECT_THAT(outside.surface.region_names, ElementsAre("outside", "core"));
  const auto nothing =
      defects_of(nested, {.wishes = {{.at = {1.4, 0, 0.1}, .name = "", .is_void = true}}});
  EXPECT_THAT(nothing, ElementsAre("nothing to mesh: the job declares every region void [ ]"));
}

TEST(Regions, turn_interfaces_to_point_out_of_the_lower_region_without_a_remark) {
  // Two cubes that share a face.
  const auto cubes =
      shapes::voxel_surface({.size = {2, 1, 1}, .label = [](int x, int, int) { return 1 + x; }});
  for (const bool is_turned : {false, true}) {
    SurfaceMesh given = cubes.surface;
    for (std::size_t t = 0; t < given.triangles.size(); ++t) {
      const auto& [behind, in_front] = cubes.sets[t];
      const bool points_in = behind == 0;
      const bool is_interface = behind != 0 && in_front != 0;
      if (points_in || (is_interface && is_turned)) {
        std::swap(given.triangles[t][1], given.triangles[t][2]);
      }
    }
    const CheckedSurface checked = check_surface(given);
    EXPECT_THAT(checked.report.defects, IsEmpty());
    EXPECT_THAT(checked.report.remarks, IsEmpty());
    int interfaces = 0;
    for (const auto& [behind, in_front] : checked.surface.sides) {
      if (in_front == 0) continue;
      ++interfaces;
      EXPECT_EQ(behind, 1);
      EXPECT_EQ(in_front, 2);
    }
    EXPECT_EQ(interfaces, 2);
  }
}

std::string refusal_of(const OuterBoundary& outer, double growth = 0.3,
                       const SurfaceMesh& body = shapes::unit_cube()) {
  try {
    add_outer_boundary(body, outer, growth);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "none";
}

TEST(OuterBoundary, refuses_numbers_word_by_word) {
  using Kind = OuterBoundary::Kind;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal_of({.kind = Kind::box, .factor = 2}), "none");
  EXPECT_EQ(refusal_of({.kind = Kind::none, .factor = nan}), "none") << "nobody asked for one";
  EXPECT_EQ(refusal_of({.kind = Kind::box, .factor = 2}, 0.3, {}),
            "domain.outer: there is no body to put a boundary around");
  EXPECT_EQ(refusal_of({.kind = Kind::box, .factor = 1}),
            "domain.factor: the factor must be greater than 1, or the boundary touches the body; "
            "it is 1");
  EXPECT_EQ(refusal_of({.kind = Kind::sphere, .factor = HUGE_VAL}),
            "domain.factor: the factor must be greater than 1, or the boundary touches the body; "
            "it is inf");
  EXPECT_EQ(refusal_of({.kind = Kind::box, .factor = 2, .spacing = -0.5}),
            "domain.spacing: the spacing must be positive, or 0 for the default; it is -0.5");
  EXPECT_EQ(refusal_of({.kind = Kind::box, .factor = 2, .default_spacing = -2}),
            "spacing.default: the spacing must be positive, or 0 for none; it is -2");
  EXPECT_EQ(refusal_of({.kind = Kind::box, .factor = 2}, -0.1),
            "spacing.growth: the growth must not be negative; it is -0.1");
  EXPECT_EQ(refusal_of({.kind = Kind::box, .factor = 2}, 0), "none");
  EXPECT_EQ(refusal_of({.kind = Kind::sphere, .factor = 1.01}),
            "domain.factor: with a factor of 1.01 the boundary touches the body; give a larger "
            "factor or a finer spacing");
  // 12 n^2 triangles: 912 parts of a side of 2 are 9 980 928, one more would be too many.
  EXPECT_EQ(refusal_of({.kind = Kind::box, .factor = 2, .spacing = 0.002}),
            "domain.spacing: a spacing of 0.002 would make more than 10000000 triangles on the "
            "outer boundary; the smallest that does not is 0.00219298246");
  EXPECT_EQ(refusal_of({.kind = Kind::box, .factor = 2, .default_spacing = 0.001}),
            "spacing.default: a spacing of 0.001 would make more than 10000000 triangles on the "
            "outer boundary; the smallest that does not is 0.00219298246");
  EXPECT_EQ(refusal_of({.kind = Kind::box, .factor = 2, .spacing = 0.0001, .is_sketch = true}),
            "none");
}

}  // namespace
}  // namespace tetfarm
