/// Speed of the planar mesher: triangles a second for whole regions, and of its first half alone.
/// Run: ninja -C build/release planar_bench && build/release/bin/planar_bench
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "mesh/planar/constrained_delaunay.h"
#include "mesh/planar/planar_mesh.h"

namespace tetfarm {
namespace {

PlanarRegion square(int edges_a_side) {
  PlanarRegion region;
  const int n = edges_a_side;
  for (int i = 0; i < 4 * n; ++i) {
    const double t = static_cast<double>(i % n) / n;
    const int side = i / n;
    region.points.push_back(side == 0   ? Vec2{t, 0}
                            : side == 1 ? Vec2{1, t}
                            : side == 2 ? Vec2{1 - t, 1}
                                        : Vec2{0, 1 - t});
    region.edges.push_back({i, (i + 1) % (4 * n)});
  }
  return region;
}

void report(benchmark::State& state, std::size_t triangles) {
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["triangles/s"] =
      benchmark::Counter(static_cast<double>(triangles) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate);
}

void uniform_square(benchmark::State& state) {
  const auto n = static_cast<int>(state.range(0));
  const PlanarRegion region = square(n);
  const double h = 1.0 / n;
  std::size_t triangles = 0;
  for (auto _ : state)
    triangles = mesh_region(region, [h](const Vec2&) { return h; }).mesh.triangles.size();
  report(state, triangles);
}
BENCHMARK(uniform_square)->Arg(20)->Arg(70)->Arg(220)->Unit(benchmark::kMillisecond);

void graded_square(benchmark::State& state) {
  const PlanarRegion region = square(60);
  const auto spacing = [](const Vec2& p) {
    return std::min(1.0 / 60,
                    0.001 + 0.1 * std::sqrt((p.x - 0.4) * (p.x - 0.4) + (p.y - 0.6) * (p.y - 0.6)));
  };
  std::size_t triangles = 0;
  for (auto _ : state) triangles = mesh_region(region, spacing).mesh.triangles.size();
  report(state, triangles);
}
BENCHMARK(graded_square)->Unit(benchmark::kMillisecond);

void boundary_only(benchmark::State& state) {
  const PlanarRegion region = square(static_cast<int>(state.range(0)));
  std::size_t triangles = 0;
  for (auto _ : state) triangles = constrained_delaunay(region).complex.triangles.size();
  report(state, triangles);
}
BENCHMARK(boundary_only)->Arg(100)->Arg(5000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tetfarm

BENCHMARK_MAIN();
