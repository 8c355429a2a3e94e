#include "mesh/decompose/face_colouring.h"

#include "base/array_index.h"

namespace tetfarm {

FaceColours colour_by_centroid(const SurfaceTopology& topology, const CutPlane& plane) {
  FaceColours colours;
  colours.reserve(topology.centroid.size());
  for (const Vec3& c : topology.centroid) {
    colours.push_back(plane.height(c) < 0 ? Side::left : Side::right);
  }
  return colours;
}

int edges_between_colours(const FaceColours& colours, const SurfaceTopology& topology,
                          std::int32_t triangle) {
  int count = 0;
  for (int e = 0; e < 3; ++e) {
    const std::int32_t neighbour = triangle_of(topology.twin[at(half_edge(triangle, e))]);
    if (colours[at(neighbour)] != colours[at(triangle)]) ++count;
  }
  return count;
}

}  // namespace tetfarm
