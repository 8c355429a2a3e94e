#include "coordinator/leftovers.h"

#include <algorithm>

namespace tetfarm {

std::vector<FileOrder> Leftovers::orders_after(const ChangeSet& changes) {
  std::vector<FileOrder> orders;
  for (const AttemptRow& attempt : changes.attempts) {
    // A worker that lives clears up itself.
    if (attempt.state != AttemptState::lost) continue;
    FileOrder order;
    order.kind = FileOrder::Kind::clear;
    order.attempt = attempt.id;
    orders.push_back(std::move(order));
  }
  for (const WorkerRow& worker : changes.workers) {
    auto known = worker.gone ? probes_.extract(worker.id) : decltype(probes_)::node_type{};
    if (known.empty()) continue;
    const std::string& name = known.mapped();
    const bool is_in_use = std::any_of(probes_.begin(), probes_.end(),
                                       [&](const auto& other) { return other.second == name; });
    if (is_in_use) continue;
    FileOrder order;
    order.kind = FileOrder::Kind::forget;
    order.file.hash = name;
    orders.push_back(std::move(order));
  }
  return orders;
}

}  // namespace tetfarm
