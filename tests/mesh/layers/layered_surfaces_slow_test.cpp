#include <gtest/gtest.h>

#include "mesh/layers/layer_chunk_file.h"
#include "mesh/layers/plane_retreat.h"
#include "tests/mesh/layers/boxes_with_planes.h"
#include "tests/mesh/layers/layered_bodies.h"
#include "tests/mesh/layers/layered_sphere.h"
#include "tests/mesh/layers/layered_surfaces.h"
#include "tests/support/cad_surfaces.h"
#include "tests/support/generated_surfaces.h"

namespace tetfarm {
namespace {

/// Surfaces until there are enough of them, or of their triangles: a gear has a thousand times as
/// many as a prism.
class ManyLayeredSurfaces : public testing::TestWithParam<shapes::SurfaceGenerator> {
 protected:
  void count(const SurfaceMesh& surface) {
    ++planned_;
    triangles_ += std::ssize(surface.triangles);
  }

  bool are_enough() const { return planned_ >= few && triangles_ > many_triangles; }

  /// Of those that were asked for.
  void expect_most_of(std::int64_t seeds) const {
    EXPECT_GT(planned_, are_enough() ? few - 1 : seeds / 2);
  }

  static constexpr std::int64_t few = 80;
  static constexpr std::int64_t many_triangles = 40'000;
  std::int64_t planned_ = 0;
  std::int64_t triangles_ = 0;
};

/// Layers of any height and number: thin ones, and such as are higher than there is room.
TEST_P(ManyLayeredSurfaces, have_layers_that_are_a_mesh) {
  std::int64_t cells = 0;
  for (std::uint64_t seed = 100; seed < 550 && !are_enough(); ++seed) {
    SCOPED_TRACE(std::string(GetParam().name) + ", seed " + std::to_string(seed));
    const CheckedSurface checked = check_surface(GetParam().make(seed, 1));
    if (!checked.report.defects.empty() || region_count(checked.surface) > 1) continue;
    const SurfaceMesh& surface = checked.surface;
    const double share = seed % 3 == 0 ? 1e-3 : seed % 3 == 1 ? 0.02 : 0.3;
    LayerRequest request =
        test::request_of_all(surface, share * checked.report.median_edge, seed % 2 == 0 ? 6 : 0);
    request.room = static_cast<RoomRule>(seed / 3 % 3);
    request.step = seed % 5 == 0 ? 3 : 1;
    const LayerPlan plan = plan_layers(surface, std::span(&request, 1));
    const test::LayerFigures figures = test::expect_valid_layers(plan, surface, request.step);
    cells += figures.prisms + figures.pyramids + figures.tets;
    count(surface);
    if (HasFailure()) return;
  }
  expect_most_of(450);
  EXPECT_GT(cells, 10 * planned_);
}

/// The same with flat pieces of each surface that do not grow.
TEST_P(ManyLayeredSurfaces, have_layers_that_end_on_planes) {
  std::int64_t with_planes = 0;
  for (std::uint64_t seed = 100; seed < 400 && !are_enough(); ++seed) {
    SCOPED_TRACE(std::string(GetParam().name) + ", seed " + std::to_string(seed));
    const CheckedSurface checked =
        check_surface(test::with_flat_patches(GetParam().make(seed, 1), seed));
    if (!checked.report.defects.empty() || region_count(checked.surface) > 1) continue;
    const SurfaceMesh& surface = checked.surface;
    const double share = seed % 3 == 0 ? 1e-3 : seed % 3 == 1 ? 0.02 : 0.3;
    LayerRequest request =
        test::request_of({0}, share * checked.report.median_edge, seed % 2 == 0 ? 6 : 0);
    request.room = static_cast<RoomRule>(seed / 3 % 3);
    if (seed % 4 < 3) request.fan_cosine = 0.5;
    request.step = seed % 5 == 0 ? 3 : 1;
    const LayerPlan plan = plan_layers(surface, std::span(&request, 1));
    const double size = checked.report.median_edge;
    const auto retreat = retreat_planes(
        surface, plan, [size](const SurfaceMesh&) { return [size](const Vec3&) { return size; }; });
    if (retreat) {
      test::expect_valid_layers(retreat->plan, retreat->surface, request.step);
      ++with_planes;
    } else {
      test::expect_valid_layers(plan, surface, request.step);
    }
    count(surface);
    if (HasFailure()) return;
  }
  expect_most_of(300);
  EXPECT_GT(with_planes, planned_ / 10) << planned_;
}

/// In small chunks, with fans that end in planes; every other of tets alone and of listed heights.
TEST_P(ManyLayeredSurfaces, have_layers_that_close_beside_planes) {
  std::int64_t with_planes = 0;
  for (std::uint64_t seed = 100; seed < 250 && !are_enough(); ++seed) {
    SCOPED_TRACE(std::string(GetParam().name) + ", seed " + std::to_string(seed));
    const CheckedSurface checked =
        check_surface(test::with_flat_patches(GetParam().make(seed, 1), seed));
    if (!checked.report.defects.empty() || region_count(checked.surface) > 1) continue;
    SurfaceMesh surface = checked.surface;
    const double size = checked.report.median_edge;
    const double first = (seed % 3 == 0 ? 1e-3 : seed % 3 == 1 ? 0.02 : 0.3) * size;
    LayerRequest request = test::request_of({0}, first, 6);
    if (seed % 4 < 2) {
      request.law = law_of_heights(
          std::vector<double>{first, 1.5 * first, first, 2 * first, 3 * first, 3 * first});
    }
    request.in_tets = seed % 2 == 0;
    request.room = static_cast<RoomRule>(seed / 3 % 3);
    if (seed % 7 < 5) request.fan_cosine = 0.5;
    request.step = seed % 5 == 0 ? 3 : 1;
    LayerPlan plan = plan_layers(surface, std::span(&request, 1));
    auto retreat = retreat_planes(
        surface, plan, [size](const SurfaceMesh&) { return [size](const Vec3&) { return size; }; });
    if (retreat) {
      surface = std::move(retreat->surface);
      plan = std::move(retreat->plan);
      ++with_planes;
    }
    test::expect_valid_layers(plan, surface, request.step);
    EXPECT_EQ(test::grown_whole(plan, surface, 200).open_faces(), 0U);
    for (const LayerChunk& chunk : chunks_of(plan, surface, 200)) {
      EXPECT_EQ(layer_chunk_from_bytes(layer_chunk_to_bytes(chunk), "chunk"), chunk);
      const ChunkCounts counts = counts_of(chunk);
      EXPECT_TRUE(!request.in_tets || counts.cells() == counts.tets);
    }
    count(surface);
    if (HasFailure()) return;
  }
  expect_most_of(150);
  EXPECT_GT(with_planes, planned_ / 10) << planned_;
}

/// Bodies in a box, with several lines at their sharp edges.
TEST_P(ManyLayeredSurfaces, have_layers_that_fan) {
  std::int64_t with_fans = 0;
  for (std::uint64_t seed = 100; seed < 400 && !are_enough(); ++seed) {
    SCOPED_TRACE(std::string(GetParam().name) + ", seed " + std::to_string(seed));
    const SurfaceMesh body = GetParam().make(seed, 1);
    if (!check_surface(body).report.defects.empty()) continue;
    const CheckedSurface checked = check_surface(test::in_a_box(body));
    if (!checked.report.defects.empty() || region_count(checked.surface) > 1) continue;
    const SurfaceMesh& surface = checked.surface;
    const double share = seed % 3 == 0 ? 1e-3 : seed % 3 == 1 ? 0.02 : 0.3;
    LayerRequest request = test::fanned(share * check_surface(body).report.median_edge,
                                        seed % 2 == 0 ? 6 : 0, seed % 7 < 4 ? 60 : 35);
    request.step = seed % 5 == 0 ? 3 : 1;
    const LayerPlan plan = plan_layers(surface, std::span(&request, 1));
    test::expect_valid_layers(plan, surface, request.step);
    with_fans += plan.fans.empty() ? 0 : 1;
    count(surface);
    if (HasFailure()) return;
  }
  expect_most_of(300);
  EXPECT_GT(with_fans, planned_ / 10) << planned_;
}

std::vector<shapes::SurfaceGenerator> all_generators() {
  std::vector<shapes::SurfaceGenerator> all(shapes::surface_generators().begin(),
                                            shapes::surface_generators().end());
  all.insert(all.end(), shapes::cad_surface_generators().begin(),
             shapes::cad_surface_generators().end());
  return all;
}

INSTANTIATE_TEST_SUITE_P(Generators, ManyLayeredSurfaces, testing::ValuesIn(all_generators()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tetfarm
