/// A working copy of the boundary triangles in which edges and faces that flips could not recover
/// are split by Steiner points; each split is remembered so that it can be undone.
///
/// Source: kernel notes, boundary recovery, steps 4 and 5; George, Borouchaki, Saltel (2003).
/// Cost: O(n) a split of an edge or face.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// A Steiner point and the triangles that were whole before it came.
struct SteinerSplit {
  std::int32_t node = -1;
  std::vector<Triangle> originals;
  std::vector<std::int32_t> sources;  // of these: the boundary triangles that they are parts of
};

struct SplitSurface {
  std::vector<Triangle> triangles;
  std::vector<std::int32_t> source;  // of a triangle: the boundary triangle that it is a part of
  std::vector<SteinerSplit> splits;  // in the order in which they were made
};

SplitSurface unsplit(const std::vector<Triangle>& triangles);

/// Every triangle on the edge ab becomes two.
void split_edge(SplitSurface& surface, std::int32_t a, std::int32_t b, std::int32_t node);

/// One triangle becomes three.
void split_face(SplitSurface& surface, std::int32_t triangle, std::int32_t node);

}  // namespace tetfarm
