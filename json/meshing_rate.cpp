#include "json/meshing_rate.h"

#include <algorithm>

namespace tetfarm {
namespace {

/// Rates of shorter times say nothing.
constexpr std::int64_t least_ms = 1'000;

}  // namespace

double made_elements(const wire::JobStatus& status) {
  return static_cast<double>(status.elements()) + std::max(status.elements_under_way(), 0.0);
}

std::optional<double> seconds_of_meshing_left(const wire::JobStatus& status,
                                              double tets_per_second) {
  const double left = status.estimated_elements() - made_elements(status);
  if (status.stage() != "mesh" || tets_per_second <= 0 || left <= 0) return std::nullopt;
  return left / tets_per_second;
}

void MeshingRate::note(const wire::JobStatus& status, std::int64_t now_ms) {
  const double made = made_elements(status);
  if (!has_begun_) {
    if (status.stage() != "mesh" && made == 0) return;
    has_begun_ = true;
    first_ms_ = now_ms;
    first_elements_ = made;
  }
  last_ms_ = now_ms;
  // A leaf that is done has a little more or less than its share stood for.
  most_elements_ = std::max(most_elements_, made);
  if (status.estimated_elements() > 0) {
    share_ = std::clamp(most_elements_ / status.estimated_elements(), share_, 1.0);
  }
}

double MeshingRate::tets_per_second() const {
  const std::int64_t ms = last_ms_ - first_ms_;
  if (ms < least_ms) return 0;
  return std::max(most_elements_ - first_elements_, 0.0) * 1000 / static_cast<double>(ms);
}

}  // namespace tetfarm
