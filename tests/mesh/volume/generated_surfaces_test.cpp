#include "base/sanitizers.h"
#include "tests/mesh/volume/generated_surfaces_checks.h"

namespace tetfarm {
namespace {

// Fewer under a sanitizer, where they take twenty times as long.
constexpr std::uint64_t seeds = is_sanitized ? 6 : 26;

TEST(GeneratedSurfaces, are_all_meshed_when_they_are_valid) {
  std::uint64_t all = 0;
  for (const shapes::SurfaceGenerator& generator : shapes::surface_generators()) {
    std::uint64_t meshed = 0;
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const Outcome outcome = mesh_generated_surface(generator, seed, 1);
      EXPECT_NE(outcome, Outcome::refused) << generator.name << ", seed " << seed;
      meshed += outcome == Outcome::meshed ? 1U : 0U;
    }
    EXPECT_GT(2 * meshed, seeds) << generator.name;
    all += meshed;
  }
  EXPECT_GE(26 * all, 300 * seeds);
}

}  // namespace
}  // namespace tetfarm
