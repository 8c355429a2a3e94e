/// Shapes that are cut as far as the flat mesh: what the tests of lifting and checking begin with.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "base/array_index.h"
#include "mesh/decompose/cut_check.h"
#include "mesh/decompose/edge_path_smoothing.h"
#include "mesh/decompose/lift_heights.h"
#include "mesh/decompose/path_relaxation.h"
#include "tests/support/shapes.h"

namespace tetfarm {

/// A cut of one triangle in the plane z = 0 without a rim, of spacing 1.
inline InterdomainMesh one_triangle() {
  InterdomainMesh cut;
  cut.plane = make_cut_plane({0, 0, 1}, 0);
  cut.planar.points = {cut.plane.project({0, 0, 0}), cut.plane.project({1, 0, 0}),
                       cut.plane.project({0, 1, 0})};
  cut.planar.triangles = {{0, 1, 2}};
  cut.heights = {0, 0, 0};
  cut.spacing = {1, 1, 1};
  return cut;
}

/// A shape cut as far as the flat mesh.
struct FlatCut {
  Subdomain subdomain;
  SurfaceTopology topology;
  FaceColours colours;
  InterdomainMesh mesh;
  std::vector<RimCorner> corners;

  FlatCut(const SurfaceMesh& surface, const CutPlane& plane, double h)
      : subdomain(root_subdomain(surface)),
        topology(make_surface_topology(subdomain)),
        colours(colour_by_centroid(topology, plane)) {
    relax_path(colours, subdomain, topology, plane);
    tidy_path(colours, topology, subdomain.triangles);
    const EdgeLoops loops = find_edge_loops(colours, topology, subdomain.triangles);
    InterdomainResult result = mesh_interdomain(subdomain, topology, loops, plane, SpacingField(h));
    EXPECT_EQ(result.problem, "");
    mesh = std::move(result.mesh);
    for (const RimEdge& edge : mesh.rim) corners.push_back(rim_corner(subdomain, topology, edge));
  }

  std::vector<double> weights() const {
    return std::vector<double>(mesh.rim.size(), usual_bisector_weight);
  }
  double worst_cosine() const {
    const auto cosines = cosines_at_rim(mesh, subdomain, corners);
    return *std::max_element(cosines.begin(), cosines.end());
  }
};

inline FlatCut cap_of_sphere() {
  return {shapes::sphere({0, 0, 0}, 1, 3), make_cut_plane(normalized(Vec3{1, 2, 3}), 0.7), 0.15};
}

/// A box with a thin plate inside, just above (or through) where the cut lies, that has no loop on
/// it.
inline FlatCut cut_at_plate(double low, double high) {
  const SurfaceMesh plate = shapes::box({0.3, 0.3, low}, {0.7, 0.7, high}, 4);
  FlatCut cut(shapes::between(shapes::box({0, 0, 0}, {1, 1, 1}, 10), plate),
              make_cut_plane({0, 0, 1}, 0.5), 0.1);
  return cut;
}

}  // namespace tetfarm
