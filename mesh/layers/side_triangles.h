/// The triangles of the surface beside layers that run in a plane, from bottom to top.
///
/// Source: mesh/layers/layer_cells.h, whose cells have these sides.
#pragma once

#include <array>
#include <vector>

#include "mesh/layers/layer_plan.h"

namespace tetfarm {

/// A point of one of the two lines that a side is between.
struct SideNode {
  int end = 0;  ///< 0: of the line that the side runs from, 1: of the one that it runs to
  int level = 0;

  friend bool operator==(const SideNode&, const SideNode&) = default;
};
using SideTriangle = std::array<SideNode, 3>;

/// A side between two lines from a level on; normals are out of the domain where it runs as the
/// plane's border does.
struct LineSide {
  const LayerLine& from;
  const LayerLine& to;
  int first_level = 0;  ///< 1 above the triangle with which a fan ends in a plane
};

/// Whether triangles take the place of quads: where cells are divided into tets, and where only one
/// of the lines is early.
bool is_divided(const LineSide& side);

/// How many quads the side has: none where it is divided.
int quads_of(const LineSide& side);

/// Two for each layer that both lines have, where it is divided: the diagonal starts at the lower
/// level of the line that is not early, or by the rule of prism_division.h. Above these one for
/// each layer that only one of the lines has. @pre the last points of both lines are vertices of
/// the surface, where it is divided. Cost: O(layers).
std::vector<SideTriangle> triangles_of(const LineSide& side);

}  // namespace tetfarm
