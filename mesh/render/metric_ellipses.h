/// Metrics as ellipses: the points at metric length 1 from a node, true to scale, at so few nodes
/// that they stay apart.
///
/// Source: thesis 3.2.1, where a metric is the ellipse of its unit length, and figs. 19 to 30. The
/// choice of nodes is ours: the smallest ellipses first, since they are what a metric was made
/// for; of equal ones the first node.
/// Units: those of the mesh. Cost: O(n log n) for n nodes, and for each that is not rejected at
/// once the cells of a grid that its ellipse reaches.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/metric/metric2.h"

namespace tetfarm {

/// Two points of the ellipse as seen from its middle, which span it: its points are
/// cos t · first + sin t · second.
struct EllipseRadii {
  Vec2 first;
  Vec2 second;
};
/// @pre is_metric
EllipseRadii unit_ellipse(const Metric2& metric);

/// So many points round the ellipse, as seen from its middle, the first radius first. Rational
/// functions alone, so that they are the same on every machine. @pre count is a multiple of 4
std::vector<Vec2> ellipse_points(const EllipseRadii& radii, int count);

struct EllipseChoice {
  Vec2 low;  ///< of the window in which nodes are looked for
  Vec2 high;
  double distance = 0;  ///< that is kept between two ellipses; above 0
  double smallest = 0;  ///< an ellipse that is less wide in every direction cannot be seen
};

/// Whether a straight line parts the two ellipses, at the distance from both: enough for them to
/// be apart, and true of nearly all that are.
bool are_apart(const Vec2& p, const Metric2& of_p, const Vec2& q, const Metric2& of_q,
               double distance);

/// Nodes whose ellipses are apart, in the order in which they were chosen. @pre as many metrics as
/// points; the window has an extent.
std::vector<std::int32_t> spaced_ellipses(std::span<const Vec2> points,
                                          std::span<const Metric2> metrics,
                                          const EllipseChoice& choice);

}  // namespace tetfarm
