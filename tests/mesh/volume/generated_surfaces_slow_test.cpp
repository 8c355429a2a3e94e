#include "tests/mesh/volume/generated_surfaces_checks.h"

namespace tetfarm {
namespace {

class ManyGeneratedSurfaces : public testing::TestWithParam<shapes::SurfaceGenerator> {};

TEST_P(ManyGeneratedSurfaces, are_all_meshed_when_they_are_valid) {
  const struct {
    std::uint64_t first, last;
    int size;
  } rounds[] = {{100, 1100, 1}, {2000, 2080, 2}, {3000, 3010, 3}};
  std::uint64_t valid = 0;
  for (const auto& [first, last, size] : rounds) {
    for (std::uint64_t seed = first; seed < last; ++seed) {
      valid += expect_is_meshed_if_valid(GetParam(), seed, size) ? 1U : 0U;
    }
  }
  RecordProperty("valid_surfaces", static_cast<int>(valid));
  EXPECT_GT(valid, 545U);
}

INSTANTIATE_TEST_SUITE_P(Generators, ManyGeneratedSurfaces,
                         testing::ValuesIn(shapes::surface_generators().begin(),
                                           shapes::surface_generators().end()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tetfarm
