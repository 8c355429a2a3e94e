#include "tests/mesh/volume/generated_surfaces_checks.h"

namespace tetfarm {
namespace {

class ManyGeneratedSurfaces : public testing::TestWithParam<shapes::SurfaceGenerator> {};

TEST_P(ManyGeneratedSurfaces, are_meshed_but_for_a_few_that_are_refused_with_the_place) {
  std::int64_t meshed = 0;
  std::int64_t refused = 0;
  for (std::uint64_t seed = 100; seed < 1000; ++seed) {
    const Outcome outcome = mesh_generated_surface(GetParam(), seed, 1);
    meshed += outcome == Outcome::meshed ? 1 : 0;
    refused += outcome == Outcome::refused ? 1 : 0;
  }
  EXPECT_GT(meshed, 450);
  EXPECT_LE(100 * refused, meshed);
}

INSTANTIATE_TEST_SUITE_P(Generators, ManyGeneratedSurfaces,
                         testing::ValuesIn(shapes::surface_generators().begin(),
                                           shapes::surface_generators().end()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tetfarm
