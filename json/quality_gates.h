/// The angles that a finished mesh had to keep ([quality] of the job file), and whether it did.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "proto/messages.pb.h"

namespace tetfarm {

struct QualityGate {
  std::string key;       ///< of the job file
  double limit_deg = 0;  ///< 0: no gate
  double smallest_deg = 0;
  std::array<double, 3> at{};  ///< where that is
  bool is_passed() const { return smallest_deg >= limit_deg; }
};

/// `min_dihedral` of all tets; `min_unforced_dihedral` of those where the surface forces no small
/// angles, when the job told of them.
std::vector<QualityGate> quality_gates_of(const wire::JobStatus& status);

/// The error of a gate that is not passed: two lines, with what to do.
std::string gate_text(const QualityGate& gate);

}  // namespace tetfarm
