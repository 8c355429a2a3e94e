#include "coordinator/damage_checks.h"

#include <utility>

#include "base/check.h"
#include "tasks/failure_cause.h"

namespace tetfarm {

void DamageChecks::take(Failure failure, const std::vector<ArtifactRef>& claimed) {
  TF_CHECK(!claimed.empty());
  const auto [place, is_new] = pending_.try_emplace(failure.attempt);
  Pending& pending = place->second;
  if (!is_new) {
    pending.failure.worker = failure.worker;
    return;
  }
  for (const ArtifactRef& file : claimed) {
    if (!pending.unknown.insert(file.hash).second) continue;
    FileOrder order;
    order.kind = FileOrder::Kind::check;
    order.task = failure.task;
    order.attempt = failure.attempt;
    order.file = {file.hash, file.size};
    orders_.push_back(std::move(order));
  }
  pending.failure = std::move(failure);
  pending.failure.what.damaged_inputs.clear();
}

std::vector<FileOrder> DamageChecks::take_orders() { return std::exchange(orders_, {}); }

std::optional<DamageChecks::Failure> DamageChecks::note(const CheckedFile& checked) {
  const auto found = pending_.find(checked.attempt);
  if (found == pending_.end() || found->second.unknown.erase(checked.hash) == 0) {
    return std::nullopt;
  }
  Pending& pending = found->second;
  if (checked.verdict == CheckedFile::Verdict::unknown) {
    pending_.erase(found);  // when its worker says it again, it is tried again
    return std::nullopt;
  }
  TaskFailure& failure = pending.failure.what;
  if (checked.verdict == CheckedFile::Verdict::damaged) {
    failure.damaged_inputs.push_back(checked.hash);
  }
  if (!pending.unknown.empty()) return std::nullopt;
  // The worker could not read what is whole here: its view of the disk lags, or its disk fails.
  if (failure.damaged_inputs.empty()) failure.cause = FailureCause::killed;
  return std::move(pending_.extract(found).mapped().failure);
}

void DamageChecks::forget() {
  pending_.clear();
  orders_.clear();
}

}  // namespace tetfarm
