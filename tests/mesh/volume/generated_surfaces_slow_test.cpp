#include "tests/mesh/volume/generated_surfaces_checks.h"

namespace tetfarm {
namespace {

class ManyGeneratedSurfaces : public testing::TestWithParam<shapes::SurfaceGenerator> {};

TEST_P(ManyGeneratedSurfaces, are_all_meshed_when_they_are_valid) {
  std::int64_t meshed = 0;
  for (std::uint64_t seed = 100; seed < 1000; ++seed) {
    const Outcome outcome = mesh_generated_surface(GetParam(), seed, 1);
    EXPECT_NE(outcome, Outcome::refused) << GetParam().name << ", seed " << seed;
    meshed += outcome == Outcome::meshed ? 1 : 0;
  }
  // 15 generators: more than 13,000 surfaces.
  EXPECT_GT(meshed, 850);
}

TEST_P(ManyGeneratedSurfaces, are_all_meshed_when_they_are_larger) {
  std::int64_t meshed = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (const int size : {2, 3}) {
      const Outcome outcome = mesh_generated_surface(GetParam(), seed, size);
      EXPECT_NE(outcome, Outcome::refused) << GetParam().name << ", seed " << seed;
      meshed += outcome == Outcome::meshed ? 1 : 0;
    }
  }
  EXPECT_GT(meshed, 30);
}

INSTANTIATE_TEST_SUITE_P(Generators, ManyGeneratedSurfaces,
                         testing::ValuesIn(shapes::surface_generators().begin(),
                                           shapes::surface_generators().end()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tetfarm
