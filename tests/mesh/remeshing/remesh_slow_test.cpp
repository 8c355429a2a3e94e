#include <gmock/gmock.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/mesh/remeshing/remesh_outcome.h"
#include "tests/support/cad_families.h"

namespace tetfarm {
namespace {

using Family = std::function<SurfaceMesh(std::uint64_t, int)>;

TEST(Remesh, of_parts_as_cad_writes_them_is_sound_and_near) {
  const std::vector<std::pair<std::string, Family>> families = {
      {"cylinder", shapes::capped_cylinder}, {"fan", shapes::fan_node},
      {"plate", shapes::perforated_plate},   {"gear", shapes::gear},
      {"block", shapes::rounded_block},      {"bar", shapes::filleted_bar},
      {"extrusion", shapes::split_extrusion}};
  for (const auto& [name, family] : families) {
    SCOPED_TRACE(name);
    const SurfaceMesh surface = family(2, 1);
    const RemeshOutcome part = remesh_outcome(surface, coarse_options(surface));
    EXPECT_THAT(defects_of_remeshed(part.result.surface), ::testing::IsEmpty());
    EXPECT_LE(part.figures.from_input.distance, part.options.tolerance);
    EXPECT_LE(part.figures.to_input.distance, 2 * part.options.tolerance);
    EXPECT_GE(part.figures.smallest_free_angle_deg, 15);
  }
}

struct NamedFamily {
  const char* name;
  SurfaceMesh (*make)(std::uint64_t, int);
};

class RemeshFamily : public testing::TestWithParam<NamedFamily> {};

/// Edges of a quarter of the diagonal, half or twice that: few triangles, and much that is narrower
/// than they are.
RemeshOptions rough_options(const SurfaceMesh& surface, std::uint64_t seed) {
  RemeshOptions options = coarse_options(surface);
  const double factor = 1.5 * static_cast<double>(1U << seed % 3);
  options.size *= factor;
  options.min_size *= factor;
  return options;
}

/// Distances are compared at points, and between those of the remesher lies a little more.
constexpr double nearly_the_tolerance = 1.05;

TEST_P(RemeshFamily, a_hundred_parts_come_out_sound_and_hardly_farther_off_than_the_tolerance) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const SurfaceMesh surface = GetParam().make(seed, 0);
    const RemeshOutcome part = remesh_outcome(surface, rough_options(surface, seed));
    EXPECT_THAT(defects_of_remeshed(part.result.surface), ::testing::IsEmpty());
    EXPECT_LE(part.figures.from_input.distance, part.options.tolerance * nearly_the_tolerance);
    EXPECT_LE(part.figures.to_input.distance, 2 * part.options.tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(AsCadWritesThem, RemeshFamily,
                         testing::Values(NamedFamily{"cylinder", shapes::capped_cylinder},
                                         NamedFamily{"fan", shapes::fan_node},
                                         NamedFamily{"thread", shapes::thread},
                                         NamedFamily{"plate", shapes::perforated_plate},
                                         NamedFamily{"lettering", shapes::lettering},
                                         NamedFamily{"gear", shapes::gear},
                                         NamedFamily{"block", shapes::rounded_block},
                                         NamedFamily{"bar", shapes::filleted_bar},
                                         NamedFamily{"extrusion", shapes::split_extrusion},
                                         NamedFamily{"levels", shapes::fine_levels},
                                         NamedFamily{"voxels", shapes::merged_voxels},
                                         NamedFamily{"boolean", shapes::box_boolean}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tetfarm
