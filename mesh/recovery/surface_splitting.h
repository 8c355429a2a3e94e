/// A working copy of the boundary triangles in which edges and faces that flips could not recover
/// are split by Steiner points. The parts of one boundary triangle may be cut in any way: they lie
/// in one plane.
///
/// Source: docs/kernel.md, "Boundary recovery", steps 4 and 5; George, Borouchaki, Saltel (2003).
/// Cost: O(n) a change.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// A Steiner point and the boundary triangles that it came to lie on.
struct SteinerSplit {
  std::int32_t node = -1;
  std::vector<std::int32_t> sources;
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

/// The boundary triangles that have parts on the edge ab.
std::vector<std::int32_t> sources_at(const SplitSurface& surface, std::int32_t a, std::int32_t b);

/// The other corners of the two triangles on the edge ab, when both are parts of one boundary
/// triangle.
std::optional<std::array<std::int32_t, 2>> opposite_corners(const SplitSurface& surface,
                                                            std::int32_t a, std::int32_t b);

/// These two triangles are cut along the other diagonal. @pre opposite_corners is not empty, and
/// the diagonals cross.
void swap_edge(SplitSurface& surface, std::int32_t a, std::int32_t b);

/// A triangle with what it is a part of.
struct SurfacePart {
  Triangle triangle;
  std::int32_t source;
};
/// Puts `parts` in place of the triangles at the node.
void replace_fan(SplitSurface& surface, std::int32_t node, const std::vector<SurfacePart>& parts);

}  // namespace tetfarm
