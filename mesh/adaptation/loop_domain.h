/// The domain between closed loops, as triangles on their points alone: the mesh that adaptation
/// begins with.
///
/// Whatever way the loops run, the domain is what an odd number of them encloses.
/// Source: thesis 3.1. Cost: O(n log n), and O(loops · n) for which loop lies in which.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/adaptation/checked_plane_mesh.h"
#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

struct DomainLoop {
  std::vector<Vec2> points;
  std::int32_t patch = 0;
  std::string name;             ///< for messages
  std::string patch_name = {};  ///< may be empty
};

/// The points are those of the loops, in order.
/// @throws InvalidInput when loops cross or touch along an edge, or points coincide: with places.
PlaneMesh domain_of_loops(const std::vector<DomainLoop>& loops);

/// The domain with points inside, and at each point a size: on the boundary the mean length of its
/// edges, from there on growing in proportion to the way (between short edges and long ones far
/// away, sizes whose logarithms are linear would stay small for most of the way).
MeshWithMetrics sized_by_boundary(const PlaneMesh& domain);

}  // namespace tetfarm
