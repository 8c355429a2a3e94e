/// Triangles that are wrong by themselves, or twice there.
#pragma once

#include <vector>

#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/surface_report.h"

namespace tetfarm {

/// Which triangles the later checks can use.
struct TriangleSieve {
  /// Indices that exist and differ, finite corners; of equal triangles only the first.
  std::vector<char> for_edges;
  /// Of those, the ones with area: exact tests make sense.
  std::vector<char> for_contact;
};

struct TriangleCheck {
  std::vector<SurfaceDefect> defects;
  TriangleSieve sieve;
};

/// Finds: vertex numbers out of range ("bad vertex number"), coordinates that are not finite or
/// outside what the exact predicates take ("bad coordinate"), fewer than four triangles ("too few
/// triangles"), area of exactly zero ("degenerate triangle"), triangles with the same three
/// vertices ("duplicate triangle"). Cost: O(n log n).
TriangleCheck check_triangles(const SurfaceMesh& surface);

}  // namespace tetfarm
