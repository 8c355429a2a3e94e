/// What the surface check found: defects, which forbid meshing, remarks, shells and figures.
///
/// Numbers of triangles and vertices are those of the input, from 0. Lengths in the unit of the
/// input.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tetfarm {

/// One kind of defect with every triangle it concerns (sorted) and where the first few are.
struct SurfaceDefect {
  std::string
      kind;  // "open edge", "non-manifold edge", "self-intersection", "degenerate triangle"…
  std::string message;  // what, how many, and the first few triangles with coordinates
  std::vector<std::int64_t> triangles;
};

struct Shell {
  std::vector<std::int32_t> triangles;
  double volume = 0;         // as enclosed, positive
  std::int32_t parent = -1;  // the shell that directly contains it
  int depth = 0;             // 0: outermost; even: domain inside, odd: hole
  bool was_flipped = false;  // more than half of its triangles were turned
};

/// A region that the surface bounds. Only of surfaces with several, or of which the job says more.
struct RegionFigures {
  std::int32_t number = 0;  // from 1; 0: not meshed
  std::string name;
  double volume = 0;  // 0 of the outside, which an outer boundary will bound
};

struct SurfaceReport {
  std::vector<SurfaceDefect> defects;  // empty: can be meshed
  std::vector<std::string> remarks;    // e.g. "shell 2 was oriented inward; turned by nesting"
  std::vector<RegionFigures> regions;
  std::vector<Shell> shells;  // parent and depth only without defects
  double volume = 0;          // of the domain; 0 when there are defects
  double shortest_edge = 0;
  double median_edge = 0;
  double longest_edge = 0;
  double smallest_angle_deg = 0;
  std::int64_t unused_vertices = 0;
};

}  // namespace tetfarm
