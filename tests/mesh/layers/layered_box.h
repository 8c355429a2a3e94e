// A box with layers over a part of its floor, which run in three of its sides.
#pragma once

#include <optional>
#include <utility>

#include "mesh/layers/plane_retreat.h"
#include "tests/mesh/layers/boxes_with_planes.h"

namespace tetfarm::test {

/// The eastern half of the floor has none, so that lines towards it have fewer and fewer layers.
struct LayeredBox {
  SurfaceMesh surface;
  LayerPlan plan;

  explicit LayeredBox(int step = 1, bool in_tets = false) {
    SurfaceMesh box = box_with_patches({0, 0, 0}, {1, 1, 1}, 8);
    box.patch_names.emplace_back("eastern floor");
    for (std::size_t t = 0; t < box.triangles.size(); ++t) {
      double x = 0;
      for (const std::int32_t v : box.triangles[t]) x += box.vertices[at(v)].x / 3;
      if (box.patch_of_triangle[t] == floor_patch && x > 0.5) box.patch_of_triangle[t] = 6;
    }
    LayerRequest request = request_of({floor_patch}, 0.01, 5);
    request.step = step;
    request.in_tets = in_tets;
    std::optional<PlaneRetreat> retreat =
        retreat_planes(box, plan_layers(box, {&request, 1}),
                       [](const SurfaceMesh&) { return [](const Vec3&) { return 0.125; }; });
    surface = std::move(retreat.value().surface);
    plan = std::move(retreat.value().plan);
  }
};

}  // namespace tetfarm::test
