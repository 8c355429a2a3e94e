#include "base/sanitizers.h"
#include "tests/mesh/volume/cad_surfaces_checks.h"

namespace tetfarm {
namespace {

/// Those that take some milliseconds each get more of the 600 surfaces than the others. Under a
/// sanitizer, where they take twenty times as long, each fifth is meshed.
std::uint64_t seeds_of(const shapes::SurfaceGenerator& generator) {
  const std::string name = generator.name;
  const bool is_quick = name == "capped_cylinder" || name == "fan_node" ||
                        name == "perforated_plate" || name == "split_extrusion" ||
                        name == "merged_voxels";
  return (is_quick ? 85 : 25) / (is_sanitized ? 5 : 1);
}

class CadSurfaces : public testing::TestWithParam<shapes::SurfaceGenerator> {};

TEST_P(CadSurfaces, are_all_meshed) {
  const std::uint64_t seeds = seeds_of(GetParam());
  for (std::uint64_t seed = 0; seed < seeds; ++seed) mesh_cad_surface(GetParam(), seed, 0);
}

INSTANTIATE_TEST_SUITE_P(Generators, CadSurfaces,
                         testing::ValuesIn(shapes::cad_surface_generators().begin(),
                                           shapes::cad_surface_generators().end()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tetfarm
