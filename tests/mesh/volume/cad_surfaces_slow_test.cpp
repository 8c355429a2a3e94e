// Thousands of CAD-like surfaces. Each case prints its seeds and the ten that took longest.
//
// TETFARM_CAD_SEEDS=N has each generator make N surfaces of size 0; 1600, which makes 20,000 with
// the larger ones, takes twenty minutes of processor time.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "tests/mesh/volume/cad_surfaces_checks.h"

namespace tetfarm {
namespace {

struct Cost {
  double seconds = 0;
  std::uint64_t seed = 0;
  int size = 1;
};

class ManyCadSurfaces : public testing::TestWithParam<shapes::SurfaceGenerator> {
 protected:
  void mesh_seeds(std::uint64_t first, std::uint64_t end, int size) {
    for (std::uint64_t seed = first; seed < end; ++seed) {
      const double seconds = mesh_cad_surface(GetParam(), seed, size);
      costs_.push_back({seconds, seed, size});
    }
    std::printf("%s: size %d, seeds %llu to %llu\n", GetParam().name, size,
                static_cast<unsigned long long>(first), static_cast<unsigned long long>(end - 1));
  }

  void TearDown() override {
    std::sort(costs_.begin(), costs_.end(),
              [](const Cost& a, const Cost& b) { return a.seconds > b.seconds; });
    double all = 0;
    for (const Cost& cost : costs_) all += cost.seconds;
    std::printf("%zu surfaces, %.1f s; the longest:\n", costs_.size(), all);
    costs_.resize(std::min<std::size_t>(costs_.size(), 10));
    for (const Cost& cost : costs_) {
      std::printf("  %s: %.3f s\n", name_of(GetParam(), cost.seed, cost.size).c_str(),
                  cost.seconds);
    }
  }

 private:
  std::vector<Cost> costs_;
};

std::uint64_t wanted_seeds() {
  const char* wanted = std::getenv("TETFARM_CAD_SEEDS");
  return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 100;
}

// 12 generators: 1,200 and 720 surfaces.
TEST_P(ManyCadSurfaces, are_all_meshed_at_a_bounded_cost) {
  mesh_seeds(1000, 1000 + wanted_seeds(), 0);
}

TEST_P(ManyCadSurfaces, are_all_meshed_when_they_are_larger) { mesh_seeds(0, 60, 1); }

TEST_P(ManyCadSurfaces, are_all_meshed_when_they_have_thousands_of_triangles) {
  mesh_seeds(0, 4, 2);
  mesh_seeds(0, 1, 3);
}

INSTANTIATE_TEST_SUITE_P(Generators, ManyCadSurfaces,
                         testing::ValuesIn(shapes::cad_surface_generators().begin(),
                                           shapes::cad_surface_generators().end()),
                         [](const auto& test) { return std::string(test.param.name); });

struct HardSurface {
  const char* generator;
  int size;
  std::uint64_t seed;
};

/// Large faces cut by ear-clipping, which flips in space and splits alone do not bring.
constexpr HardSurface hard_surfaces[] = {
    {"split_extrusion", 2, 38}, {"split_extrusion", 3, 0}, {"perforated_plate", 2, 2}};

class HardCadSurface : public testing::TestWithParam<HardSurface> {};

TEST_P(HardCadSurface, is_meshed_by_swaps_in_its_facets) {
  const auto& [name, size, seed] = GetParam();
  const auto all = shapes::cad_surface_generators();
  const auto generator = std::find_if(all.begin(), all.end(), [&](const auto& candidate) {
    return std::string_view(candidate.name) == name;
  });
  ASSERT_NE(generator, all.end());
  const double seconds = mesh_cad_surface(*generator, seed, size);
  std::printf("%s: %.3f s\n", name_of(*generator, seed, size).c_str(), seconds);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, HardCadSurface, testing::ValuesIn(hard_surfaces),
                         [](const auto& test) {
                           return std::string(test.param.generator) + "_" +
                                  std::to_string(test.param.size) + "_" +
                                  std::to_string(test.param.seed);
                         });

}  // namespace
}  // namespace tetfarm
