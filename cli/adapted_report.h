/// What the commands for meshes of the plane have in common: how they tell what they made.
#pragma once

#include <cstdint>
#include <string>

#include "mesh/adaptation/adapt_to_metric.h"
#include "mesh/job_file/plane_sources.h"
#include "worker/curve_option.h"

namespace tetfarm {

struct AdaptedTelling {
  std::string command;  ///< "adapt" or "plane"
  std::string output;
  bool json = false;
  std::int64_t start_ms = 0;  ///< by steady_ms
  const CurvesOfMesh* curved = nullptr;
  /// Those of `sources_file`, where there is one.
  const PlaneSources* sources = nullptr;
  std::string sources_file = {};
};

/// Prints size, lengths and shapes of the mesh, what each limit did, how far nodes went to their
/// curves, and the digest.
void tell_adapted(const AdaptedTelling& telling, const AdaptedMesh& adapted);

/// @throws InvalidInput when no source of the file asks anywhere in the domain for more than the
/// background does.
void check_that_sources_act(const AdaptedTelling& telling, const AdaptedMesh& adapted);

/// The number of --gradation, 0 for "off", `otherwise` for "".
double gradation_of(const std::string& text, double otherwise);

}  // namespace tetfarm
