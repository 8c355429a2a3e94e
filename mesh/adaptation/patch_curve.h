/// The true curve of some patches, and which part of it a piece of their boundary is.
///
/// Source: none; the thesis leaves the curve (3.3.3.4). Cost: O(nodes · samples of the curve).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/adaptation/boundary_curve.h"

namespace tetfarm {

struct PatchCurve {
  std::vector<std::int32_t> patches;
  std::string name;  ///< as the user wrote it, for messages
  /// Smooth ones between the corners of the curve. None: every piece of boundary is the straight
  /// line between its own corners.
  std::vector<std::shared_ptr<const TrueCurve>> parts;
};

/// Null where the patch has none.
const PatchCurve* curve_of_patch(std::span<const PatchCurve> curves, std::int32_t patch);

/// A piece of boundary as a part of a curve, with the parameters of its nodes from 0 on.
struct PieceOnCurve {
  CurvePart part;
  std::vector<double> parameters;
  /// The first node that does not follow the one before it on the curve.
  std::optional<std::size_t> fold;
};

/// The part that is nearest to the nodes and the middles of the edges. `points`: of the nodes of
/// the piece in their order; of a loop with one corner that comes twice. @pre at least two points,
/// three when closed
PieceOnCurve piece_on_curve(const PatchCurve& curve, const std::vector<Vec2>& points,
                            bool is_closed);

/// @pre the points lie on the curve, and follow one another there
BoundaryCurve boundary_curve_of(const PatchCurve& curve, const std::vector<Vec2>& points,
                                bool is_closed);

}  // namespace tetfarm
