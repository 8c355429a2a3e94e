// How fast the spacing field is built, asked, and turned into lattice nodes.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "mesh/spacing/spacing_field.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

SurfaceMesh ball_in_a_shell() {
  return shapes::between(shapes::sphere({}, 4, 3), shapes::sphere({}, 1, 6));
}

std::vector<Vec3> scattered_points(std::size_t count) {
  std::uint64_t state = 1;
  const auto next = [&state] {
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state >> 11U) / 9007199254740992.0 - 0.5;
  };
  std::vector<Vec3> points(count);
  for (Vec3& p : points) p = {3 * next(), 3 * next(), 3 * next()};
  return points;
}

void build(benchmark::State& state) {
  const SurfaceMesh surface = ball_in_a_shell();
  for (auto _ : state) benchmark::DoNotOptimize(make_spacing_field(surface, {}));
  state.counters["triangles/s"] = benchmark::Counter(static_cast<double>(surface.triangles.size()),
                                                     benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(build)->Unit(benchmark::kMillisecond);

void at(benchmark::State& state) {
  const SpacingField field = make_spacing_field(ball_in_a_shell(), {});
  const std::vector<Vec3> points = scattered_points(1U << 16U);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(field.at(points[i++ % points.size()]));
}
BENCHMARK(at);

void lattice(benchmark::State& state) {
  const SurfaceMesh surface = ball_in_a_shell();
  const SpacingField field = make_spacing_field(surface, {});
  std::size_t nodes = 0;
  for (auto _ : state) nodes = field.lattice_nodes(bounding_box(surface.vertices)).size();
  state.counters["nodes/s"] =
      benchmark::Counter(static_cast<double>(nodes), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(lattice)->Unit(benchmark::kMillisecond);

void lattice_of_constant(benchmark::State& state) {
  Box3 box;
  box.add(Vec3{0, 0, 0});
  box.add(Vec3{1, 1, 1});
  const SpacingField field(0.01);
  std::size_t nodes = 0;
  for (auto _ : state) nodes = field.lattice_nodes(box).size();
  state.counters["nodes/s"] =
      benchmark::Counter(static_cast<double>(nodes), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(lattice_of_constant)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tetfarm

BENCHMARK_MAIN();
