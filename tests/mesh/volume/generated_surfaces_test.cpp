#include "tests/mesh/volume/generated_surfaces_checks.h"

namespace tetfarm {
namespace {

constexpr std::uint64_t seeds = 26;

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
  EXPECT_GE(all, 300U);
}

}  // namespace
}  // namespace tetfarm
