/// What the commands for meshes of the plane have in common: how they tell what they made.
#pragma once

#include <cstdint>
#include <string>

#include "mesh/adaptation/adapt_to_metric.h"
#include "worker/curve_option.h"

namespace tetfarm {

struct AdaptedTelling {
  std::string command;  ///< "adapt" or "plane"
  std::string output;
  bool json = false;
  std::int64_t start_ms = 0;  ///< by steady_ms
  const CurvesOfMesh* curved = nullptr;
};

/// Prints size, lengths and shapes of the mesh, what each limit did, how far nodes went to their
/// curves, and the digest.
void tell_adapted(const AdaptedTelling& telling, const AdaptedMesh& adapted);

/// The number of --gradation, 0 for "off", `otherwise` for "".
double gradation_of(const std::string& text, double otherwise);

}  // namespace tetfarm
