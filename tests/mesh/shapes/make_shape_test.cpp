#include "mesh/shapes/make_shape.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "mesh/inspect/surface_check.h"
#include "tests/mesh/inspect/check_support.h"

namespace tetfarm {
namespace {

using ::testing::IsEmpty;

struct Made {
  const char* name;
  double spacing;
  const char* even_patch;  // "": all of them
  std::vector<std::string> patches;
  double volume;
  double tolerance;  // of the volume, relative
  double smallest_angle_deg;
};

void PrintTo(const Made& made, std::ostream* out) { *out << made.name << " " << made.spacing; }

class MakeShape : public testing::TestWithParam<Made> {};

/// Of the edges of one patch, each taken once for each of its triangles there.
double median_edge(const SurfaceMesh& mesh, const std::string& patch) {
  std::vector<double> lengths;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto number = static_cast<std::size_t>(mesh.patch_of_triangle[t]);
    if (!patch.empty() && mesh.patch_names[number] != patch) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](std::size_t corner) {
        return mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][corner])];
      };
      lengths.push_back(distance(at(i), at((i + 1) % 3)));
    }
  }
  std::ranges::sort(lengths);
  return lengths[lengths.size() / 2];
}

TEST_P(MakeShape, is_closed_and_does_not_meet_itself) {
  const SurfaceMesh mesh = make_shape(GetParam().name, {.spacing = GetParam().spacing});
  const CheckedSurface checked = check_surface(mesh);
  EXPECT_THAT(kinds(checked.report), IsEmpty());
  EXPECT_THAT(checked.report.remarks, IsEmpty());
  EXPECT_EQ(checked.report.unused_vertices, 0);
  EXPECT_EQ(checked.surface.triangles, mesh.triangles);
  EXPECT_NEAR(checked.report.volume, GetParam().volume, GetParam().tolerance * GetParam().volume);
  EXPECT_GT(checked.report.smallest_angle_deg, GetParam().smallest_angle_deg);
}

TEST_P(MakeShape, has_the_edge_length_that_was_asked_for) {
  const SurfaceMesh mesh = make_shape(GetParam().name, {.spacing = GetParam().spacing});
  EXPECT_NEAR(median_edge(mesh, GetParam().even_patch) / GetParam().spacing, 1, 0.15);
}

TEST_P(MakeShape, names_its_patches) {
  const SurfaceMesh mesh = make_shape(GetParam().name, {.spacing = GetParam().spacing});
  EXPECT_EQ(mesh.patch_names, GetParam().patches);
  ASSERT_EQ(mesh.patch_of_triangle.size(), mesh.triangles.size());
  for (std::size_t patch = 0; patch < mesh.patch_names.size(); ++patch) {
    EXPECT_TRUE(std::ranges::count(mesh.patch_of_triangle, static_cast<std::int32_t>(patch)) > 0);
  }
}

TEST_P(MakeShape, is_the_same_bit_by_bit_when_made_again) {
  const SurfaceMesh a = make_shape(GetParam().name, {.spacing = GetParam().spacing});
  const SurfaceMesh b = make_shape(GetParam().name, {.spacing = GetParam().spacing});
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
}

constexpr double pi = std::numbers::pi;
const std::vector<std::string> nested = {"outer", "inner"};
const std::vector<std::string> reflector = {"outer", "reflector", "body"};
const std::vector<std::string> duct = {"inlet", "wall", "outlet"};
const double s_duct_volume = 6.2 * pi * 0.225 * 0.225;  // of Pappus
const std::vector<std::string> trihedral = {"outer", "cavity", "body"};
const double trihedral_volume = std::pow(0.69, 3) - (std::pow(0.45, 3) - std::pow(0.36, 3)) / 6;
const std::vector<std::string> wing = {"symmetry", "wing", "far field"};

INSTANTIATE_TEST_SUITE_P(
    All, MakeShape,
    testing::Values(Made{"sphere-in-sphere", 0.3, "", nested, 28 * pi / 3, 0.03, 40},
                    Made{"sphere-in-sphere", 0.12, "", nested, 28 * pi / 3, 0.01, 40},
                    Made{"sphere-in-box", 0.25, "", nested, 64 - 4 * pi / 3, 0.01, 40},
                    Made{"corner-reflector", 1, "", reflector, 216 - 7, 1e-12, 40},
                    Made{"corner-reflector", 0.3, "", reflector, 216 - 7, 1e-12, 40},
                    Made{"duct", 0.2, "", duct, (2 + pi / 2) * pi / 4, 0.05, 20},
                    Made{"duct", 0.06, "", duct, (2 + pi / 2) * pi / 4, 0.01, 20},
                    Made{"s-duct", 0.1, "", duct, s_duct_volume, 0.1, 20},
                    Made{"s-duct", 0.03, "", duct, s_duct_volume, 0.01, 25},
                    Made{"trihedral", 0.1, "", trihedral, trihedral_volume, 1e-12, 15},
                    Made{"trihedral", 0.03, "", trihedral, trihedral_volume, 1e-12, 29.9},
                    Made{"trihedral", 0.015, "", trihedral, trihedral_volume, 1e-12, 29.9},
                    Made{"wing", 0.1, "wing", wing, 2000 * pi / 3, 0.05, 3},
                    Made{"wing", 0.033, "wing", wing, 2000 * pi / 3, 0.05, 3}),
    [](const auto& test) {
      std::string name = std::string(test.param.name) + "_" +
                         std::to_string(static_cast<int>(1000 * test.param.spacing));
      std::ranges::replace(name, '-', '_');
      return name;
    });

TEST(MakeShapes, every_name_makes_a_shape) {
  for (const std::string& name : shape_names()) {
    EXPECT_FALSE(make_shape(name, {.spacing = 0.2}).triangles.empty()) << name;
  }
}

TEST(MakeShapes, grow_as_asked_round_the_wing) {
  const std::size_t slow = make_shape("wing", {.spacing = 0.1, .growth = 0.1}).triangles.size();
  const std::size_t fast = make_shape("wing", {.spacing = 0.1, .growth = 0.4}).triangles.size();
  EXPECT_GT(slow, 3 * fast);
}

TEST(MakeShapes, refuse_what_makes_no_sense) {
  EXPECT_THROW(make_shape("teapot"), UsageError);
  for (const std::string& name : shape_names()) {
    EXPECT_THROW(make_shape(name, {.spacing = 0}), UsageError) << name;
    EXPECT_THROW(make_shape(name, {.spacing = -1}), UsageError) << name;
    EXPECT_THROW(make_shape(name, {.spacing = 1e-12}), UsageError) << name;
  }
  EXPECT_THROW(make_shape("wing", {.spacing = 0.1, .growth = 0}), UsageError);
  EXPECT_THROW(make_shape("wing", {.spacing = 5}), UsageError);
}

}  // namespace
}  // namespace tetfarm
