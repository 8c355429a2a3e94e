/// How fast the leaves of a job are meshed, and when all of them will be, from what is seen of the
/// job now and then. A leaf that is being meshed counts with the share of its elements that its
/// stage stands for, so that a job of one leaf has a rate too. Units: tets, seconds.
#pragma once

#include <cstdint>
#include <optional>

#include "proto/messages.pb.h"

namespace tetfarm {

/// Tets that are there, and those that stand for what running tasks have done.
double made_elements(const wire::JobStatus& status);

/// Until the leaves are meshed, at such a rate; nothing before and after that stage, and without a
/// rate.
std::optional<double> seconds_of_meshing_left(const wire::JobStatus& status,
                                              double tets_per_second);

class MeshingRate {
 public:
  /// @pre `now_ms` of a steady clock, not before that of the last call.
  void note(const wire::JobStatus& status, std::int64_t now_ms);

  /// Since meshing was first seen; 0 in the first second and when nothing was made since.
  double tets_per_second() const;
  /// How much of the job's elements is made, 0 to 1; it never falls.
  double share() const { return share_; }

 private:
  bool has_begun_ = false;
  std::int64_t first_ms_ = 0;
  std::int64_t last_ms_ = 0;
  double first_elements_ = 0;
  double most_elements_ = 0;
  double share_ = 0;
};

}  // namespace tetfarm
