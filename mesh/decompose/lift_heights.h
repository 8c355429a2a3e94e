/// Lifts the flat inter-domain mesh so that it meets the surface at good angles all along its rim.
///
/// Source: thesis 4.3.1.9 maps the mesh back as a plane; a departure, by far the most useful one
/// (measured): a harmonic height that decays away from the rim, pulled at the apex of every rim
/// triangle to the bisector of the material's angle at its edge.
#pragma once

#include <optional>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/decompose/interdomain_mesh.h"
#include "mesh/decompose/rim_angles.h"

namespace tetfarm {

struct LiftOptions {
  /// The height decays over this many spacings.
  double decay = 2;
  /// Tangent of the steepest slope of a rim triangle against the plane: 65 degrees.
  double steepest_slope = 2.1445069205095586;
};

inline constexpr double usual_bisector_weight = 4;

/// Sets mesh.heights. `bisector_weights` tell of each rim edge how strongly it pulls. `pushed`
/// holds a height for each node that is to lie there exactly, or is empty. Conjugate gradients: + -
/// * / sqrt in a fixed order. Cost: O(m) an iteration, some 30 iterations.
void lift_heights(InterdomainMesh& mesh, const std::vector<RimCorner>& corners,
                  const std::vector<double>& bisector_weights,
                  const std::vector<std::optional<double>>& pushed,
                  const LiftOptions& options = {});

}  // namespace tetfarm
