/// Rows that were changed and events that happened since the last commit.
///
/// Jobs, tasks and sub-domains are kept where they are and noted here by their numbers; attempts,
/// workers and hosts that may be gone by then are kept as they are last told.
/// Cost: O(log rows) each.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "store/rows.h"

namespace tetfarm {

class PendingChanges {
 public:
  void note(JobId job) { jobs_.insert(job); }
  void note(TaskId task) { tasks_.insert(task); }
  void note(const SubdomainKey& subdomain) { subdomains_.insert(subdomain); }
  void put(const AttemptRow& attempt) { attempts_[attempt.id] = attempt; }
  void put(const WorkerRow& worker) { workers_[worker.id] = worker; }
  void put(const HostRow& host) { hosts_[host.host] = host; }
  /// @pre its tasks and sub-domains are noted by nobody.
  void remove(JobId job) {
    jobs_.erase(job);
    removed_.push_back(job);
  }
  void add(EventRow event) { events_.push_back(std::move(event)); }

  /// Whether nothing of a job is to be committed.
  bool has_no_job_rows() const { return jobs_.empty() && tasks_.empty() && subdomains_.empty(); }

  /// All of them, once. @pre what was noted is in `rows`. Cost: O(changes · log rows).
  ChangeSet take(const DurableState& rows);

 private:
  std::set<JobId> jobs_;
  std::set<TaskId> tasks_;
  std::set<SubdomainKey> subdomains_;
  std::map<AttemptId, AttemptRow> attempts_;
  std::map<WorkerId, WorkerRow> workers_;
  std::map<std::string, HostRow> hosts_;
  std::vector<EventRow> events_;
  std::vector<JobId> removed_;
};

}  // namespace tetfarm
