/// Puts nodes on edges that are too long, at even metric spacing.
///
/// Source: thesis 3.3.3.1 and 3.3.3.3 (the node in the middle of an edge, the cavity from its two
/// triangles). Departs: a long edge gets all its nodes at once, one a unit of length; a node comes
/// only where no new edge would be too short, so that what refines never works against what
/// coarsens; nodes of the boundary lie on the true curve. Cost: O(edges + new nodes).
#pragma once

#include "mesh/adaptation/ellipse_cavity.h"
#include "mesh/adaptation/metric_mesh.h"

namespace tetfarm {

struct RefinementLimits {
  double longest = 1.41421356;                ///< longer edges are divided
  double shortest = 0.70710678;               ///< no new edge is shorter
  std::int64_t most_triangles = 500'000'000;  ///< it ends where there are more
  /// One node in the middle of each long edge (thesis 3.3.3.1), however long it is.
  bool at_middles = false;
};

/// Goes over the edges once; over those on curves alone, where asked for: nodes inside that are too
/// near to a new one there join it. Returns how many nodes came.
std::int64_t refine_edges(MetricMesh& mesh, const MetricField& field, EllipseCavity& cavity,
                          const RefinementLimits& limits, EdgesToVisit which,
                          bool only_on_curves = false);

/// One node on the edge at the given share of its length from the node that it begins with. False,
/// with nothing changed, where a new edge would be shorter than `shortest`; on a curve that counts
/// for the ends of the edge alone.
bool divide_edge(MetricMesh& mesh, const MetricField& field, EllipseCavity& cavity, EdgeHandle edge,
                 double share, double shortest);

}  // namespace tetfarm
