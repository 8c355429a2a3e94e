// A sphere with layers inside it, as chunks, and what they come to when all are put together.
#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "mesh/layers/layer_chunks.h"
#include "mesh/layers/layer_growth.h"
#include "mesh/layers/unlayered_domain.h"
#include "tests/support/shapes.h"

namespace tetfarm::test {

struct LayeredSphere {
  SurfaceMesh surface = shapes::sphere({0.1, 0.2, 0.3}, 1, 2);
  LayerPlan plan;

  /// Five layers, all over it.
  LayeredSphere() {
    LayerRequest request;
    request.patches = {0};
    request.law.first = 0.01;
    request.count = 5;
    plan = plan_layers(surface, {&request, 1});
  }

  /// Fewer layers towards the south, and none at the pole: all kinds of cells.
  static LayeredSphere uneven() {
    LayeredSphere sphere;
    for (LayerLine& line : sphere.plan.lines) {
      const double height = (line.at.z - 0.3 + 1) / 2;
      line.stop = std::min(line.stop, static_cast<int>(std::floor(7 * height)));
    }
    return sphere;
  }
};

/// Grown chunks as one mesh: nodes by their origins.
class GrownWhole {
 public:
  void add(const GrownLayers& layers) {
    const std::vector<Origin>& origins = layers.subdomain.node_origin;
    for (std::size_t v = 0; v < origins.size(); ++v) {
      const auto [known, is_new] = places_.emplace(origins[v], layers.mesh.nodes[v]);
      EXPECT_EQ(known->second, layers.mesh.nodes[v]) << "two places of one node";
    }
    for (const Tet& tet : layers.mesh.tets) add_cell(origins, ElementType::tet, tet);
    for_each_block_cell(layers.blocks, [&](ElementType type, std::span<const std::int32_t> nodes,
                                           std::int32_t) { add_cell(origins, type, nodes); });
  }
  /// Triangles that bound it, as those behind them see them: normals out of it.
  void bound_by(const std::vector<Origin>& origins, Triangle triangle) {
    take_face({origins[at(triangle[0])], origins[at(triangle[2])], origins[at(triangle[1])]});
  }
  void bound_by_quad(const std::vector<Origin>& origins, std::span<const std::int32_t> quad) {
    Face face;
    for (const std::int32_t v : quad) face.insert(face.begin(), origins[at(v)]);
    take_face(face);
  }
  /// How many faces are left that nobody is on the other side of.
  std::size_t open_faces() const { return open_.size(); }
  std::size_t nodes() const { return places_.size(); }
  double volume() const { return volume_; }

 private:
  using Face = std::vector<Origin>;

  static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
  static Face turned(Face face) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
  }

  void add_cell(const std::vector<Origin>& origins, ElementType type,
                std::span<const std::int32_t> nodes) {
    std::vector<Vec3> corners;
    for (const std::int32_t v : nodes) corners.push_back(places_.at(origins[at(v)]));
    volume_ += static_cast<double>(element_volume(type, corners));
    for_each_face_of(type, nodes, [&](ElementType, std::span<const std::int32_t> face) {
      Face named;
      for (const std::int32_t v : face) named.push_back(origins[at(v)]);
      take_face(named);
    });
  }

  /// Closes the same face as it was seen from the other side, or leaves this one open.
  void take_face(Face face) {
    Face reversed = face;
    std::reverse(reversed.begin(), reversed.end());
    const auto other = open_.find(turned(reversed));
    if (other != open_.end()) {
      open_.erase(other);
    } else {
      EXPECT_TRUE(open_.emplace(turned(face), 0).second) << "a face twice from one side";
    }
  }

  std::map<Origin, Vec3> places_;
  std::map<Face, int> open_;
  double volume_ = 0;
};

/// All chunks of so many cells, grown, with the wall and the top on both sides of them.
inline GrownWhole grown_whole(const LayerPlan& plan, const SurfaceMesh& surface,
                              std::int64_t cells) {
  GrownWhole whole;
  for (const LayerChunk& chunk : chunks_of(plan, surface, cells)) {
    const GrownLayers layers = grow(chunk);
    EXPECT_THAT(validate(layers), testing::IsEmpty());
    whole.add(layers);
    for (const Triangle& triangle : layers.subdomain.triangles) {
      whole.bound_by(layers.subdomain.node_origin, triangle);
    }
    for_each_block_face(layers.blocks, [&](ElementType, std::span<const std::int32_t> quad,
                                           std::int32_t, std::int32_t) {
      whole.bound_by_quad(layers.subdomain.node_origin, quad);
    });
  }
  const Subdomain rest = unlayered_domain(plan, surface, unlayered_path, top_of_layers).root;
  for (std::size_t t = 0; t < rest.triangles.size(); ++t) {
    const auto& [a, b, c] = rest.triangles[t];
    if (rest.triangle_origin[t].owner != 0) whole.bound_by(rest.node_origin, {a, c, b});
  }
  return whole;
}

}  // namespace tetfarm::test
