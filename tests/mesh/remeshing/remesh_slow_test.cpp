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

}  // namespace
}  // namespace tetfarm
