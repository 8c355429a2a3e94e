#include "coordinator/decisions/host_crashes.h"

#include <algorithm>
#include <set>

namespace tetfarm {

void HostCrashes::note_crash(const std::string& host, const TaskRow& task,
                             const std::string& message, const IsAtHand& is_at_hand) {
  Crashes& crashes = host2crashes_[host];
  crashes.last_message = message;
  std::erase_if(crashes.tasks, [&](const auto& entry) {
    return !entry.second.was_done_elsewhere && !is_at_hand(entry.first);
  });
  CrashesOfTask& of_task = crashes.tasks[task.id];
  of_task.job = task.job;
  ++of_task.count;
}

bool HostCrashes::crashed_on(const std::string& host, TaskId task) const {
  const auto found = host2crashes_.find(host);
  return found != host2crashes_.end() && found->second.tasks.contains(task);
}

std::size_t HostCrashes::hosts_where_it_crashed(TaskId task) const {
  return static_cast<std::size_t>(
      std::count_if(host2crashes_.begin(), host2crashes_.end(),
                    [task](const auto& host) { return host.second.tasks.contains(task); }));
}

std::optional<std::string> HostCrashes::note_done(const std::string& host, TaskId task) {
  const bool is_proof = hosts_where_it_crashed(task) == 1;
  host2crashes_.erase(host);
  if (!is_proof) return std::nullopt;
  for (auto& [other, crashes] : host2crashes_) {
    const auto found = crashes.tasks.find(task);
    if (found == crashes.tasks.end()) continue;
    found->second.was_done_elsewhere = true;
    return other;
  }
  return std::nullopt;
}

std::optional<HostCrashes::Proof> HostCrashes::proof_against(const std::string& host,
                                                             std::size_t least_tasks) const {
  const auto found = host2crashes_.find(host);
  if (found == host2crashes_.end()) return std::nullopt;
  Proof proof;
  std::size_t proofs = 0;
  std::set<JobId> jobs;
  for (const auto& [task, of_task] : found->second.tasks) {
    proof.crashes[task] = of_task.count;
    if (!of_task.was_done_elsewhere) continue;
    ++proofs;
    jobs.insert(of_task.job);
  }
  if (proofs < least_tasks || jobs.size() < 2) return std::nullopt;
  proof.reason =
      std::to_string(proofs) + " tasks of " + std::to_string(jobs.size()) +
      " jobs failed there and were done elsewhere; last failure: " + found->second.last_message;
  return proof;
}

std::vector<std::string> HostCrashes::validate() const {
  std::vector<std::string> broken;
  for (const auto& [host, crashes] : host2crashes_) {
    if (crashes.tasks.empty()) broken.push_back(host + " is listed, and nothing crashed there");
    for (const auto& [task, of_task] : crashes.tasks) {
      if (of_task.count > 0) continue;
      broken.push_back(host + " is listed for task " + std::to_string(task.value) +
                       ", which did not crash there");
    }
  }
  return broken;
}

}  // namespace tetfarm
