#include "coordinator/decisions/pending_changes.h"

namespace tetfarm {

ChangeSet PendingChanges::take(const DurableState& rows) {
  ChangeSet changes;
  for (const JobId id : jobs_) changes.jobs.push_back(rows.jobs.at(id));
  for (const SubdomainKey& key : subdomains_) {
    changes.subdomains.push_back(rows.subdomains.at(key));
  }
  for (const TaskId id : tasks_) changes.tasks.push_back(rows.tasks.at(id));
  for (auto& [id, worker] : workers_) changes.workers.push_back(std::move(worker));
  for (auto& [id, attempt] : attempts_) changes.attempts.push_back(std::move(attempt));
  for (auto& [name, host] : hosts_) changes.hosts.push_back(std::move(host));
  changes.events = std::move(events_);
  changes.removed_jobs = std::move(removed_);
  *this = {};
  return changes;
}

}  // namespace tetfarm
