/// Solids with a flat bottom and level terraces: plates with holes, letters on a plate, gears,
/// prisms of any outline.
///
/// All faces are horizontal or vertical and all coordinates whole numbers, so flat is exactly flat:
/// valid by construction when the outlines do not touch each other.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/surface_mesh.h"
#include "tests/support/ear_clipping.h"

namespace tetfarm::shapes {

/// An outline, the height within it, and what is cut out of or put upon it.
struct Terrace {
  Loop outline;             ///< anticlockwise
  std::int64_t height = 0;  ///< over the bottom; 0: a hole through everything, with nothing inside
  std::vector<Terrace> inside;  ///< neither touch each other nor the outline
};

struct ReliefOptions {
  /// At most so many points are put within a side, at the top and at the bottom others: 0 to 63.
  int most_splits = 0;
  /// Corners of level faces are raised by up to so much: nearly flat instead of flat. Heights
  /// differ by more; only without splits.
  int most_raise = 0;
  EarOrder order = EarOrder::lowest;
  /// Walls get all triangles of their lower side first: fans.
  bool has_wall_fans = false;
};

/// The solid, 64 times as large, so that points within sides have whole coordinates too.
/// @pre coordinates up to 2^21.
SurfaceMesh relief(const Terrace& whole, const ReliefOptions& options, Chance& chance);

}  // namespace tetfarm::shapes
