/// JobState, the part about hosts on which tasks crash. A task is not to blame for a bad host, nor
/// a host for bad tasks: only a task that crashed on one host and was then done on another tells
/// which of the two it was.
#include <algorithm>

#include "coordinator/decisions/job_state.h"

namespace tetfarm {

void JobState::note_crash_on_host(const TaskRow& task, WorkerId worker,
                                  const std::string& message) {
  const auto row = workers_.find(worker);
  if (row == workers_.end()) return;
  HostCrashes& crashes = host2crashes_[row->second.host];
  crashes.last_message = message;
  std::erase_if(crashes.tasks, [this](const auto& entry) {
    return !entry.second.was_done_elsewhere && !durable_.tasks.contains(entry.first);
  });
  CrashesOfTask& of_task = crashes.tasks[task.id];
  of_task.job = task.job;
  ++of_task.count;
}

std::size_t JobState::hosts_where_it_crashed(TaskId task) const {
  return static_cast<std::size_t>(
      std::count_if(host2crashes_.begin(), host2crashes_.end(),
                    [task](const auto& host) { return host.second.tasks.contains(task); }));
}

/// Whether the task crashed on the host since something was last done there, and a worker of
/// another host, where it has not crashed, has the room and the time for it: that one goes first.
bool JobState::waits_for_another_host(const TaskRow& task, const std::string& host,
                                      Moment now) const {
  const auto crashed_on = [&](const std::string& where) {
    const auto found = host2crashes_.find(where);
    return found != host2crashes_.end() && found->second.tasks.contains(task.id);
  };
  if (!crashed_on(host)) return false;
  return std::any_of(sessions_.begin(), sessions_.end(), [&](const auto& entry) {
    const auto& [id, session] = entry;
    const WorkerRow& other = workers_.at(id);
    return other.host != host && !session.drains && memory_for(task) <= other.memory_bytes &&
           !durable_.quarantined_hosts.contains(other.host) && !crashed_on(other.host) &&
           has_time_for(session, task, now);
  });
}

/// Whether all that is known of the task is that this host does not do it, and another can try.
bool JobState::counts_against_host(const TaskRow& task, WorkerId worker, Moment now) const {
  const auto row = workers_.find(worker);
  return row != workers_.end() && hosts_where_it_crashed(task.id) == 1 &&
         waits_for_another_host(task, row->second.host, now);
}

/// The task is done on `host`: nothing that crashed there speaks against the host any more, and if
/// the task crashed on one other host, it speaks against that one.
void JobState::note_done_on_host(TaskId task, const std::string& host, Moment now) {
  const bool is_proof = hosts_where_it_crashed(task) == 1;
  host2crashes_.erase(host);
  if (!is_proof) return;
  for (auto& [other, crashes] : host2crashes_) {
    const auto found = crashes.tasks.find(task);
    if (found == crashes.tasks.end()) continue;
    found->second.was_done_elsewhere = true;
    quarantine_if_proven(other, now);
    return;
  }
}

/// Enough different tasks, of more than one job: nobody takes a host out of the farm with a job
/// made for it.
void JobState::quarantine_if_proven(const std::string& host, Moment now) {
  const auto found = host2crashes_.find(host);
  const HostCrashes& crashes = found->second;
  std::size_t proofs = 0;
  std::set<JobId> jobs;
  for (const auto& [task, of_task] : crashes.tasks) {
    if (!of_task.was_done_elsewhere) continue;
    ++proofs;
    jobs.insert(of_task.job);
  }
  if (proofs < rules_.host_tasks || jobs.size() < 2) return;
  if (durable_.quarantined_hosts.contains(host) || !has_host_besides(host)) return;
  for (const auto& [id, of_task] : crashes.tasks) {
    if (!durable_.tasks.contains(id)) continue;  // its job is over
    TaskRow& blamed = edit(id);
    blamed.crashes -= std::min(blamed.crashes, of_task.count);
  }
  const HostRow quarantined{
      host, true, now.wall_ms,
      std::to_string(proofs) + " tasks of " + std::to_string(jobs.size()) +
          " jobs failed there and were done elsewhere; last failure: " + crashes.last_message};
  durable_.quarantined_hosts[host] = quarantined;
  dirty_hosts_[host] = quarantined;
  new_events_.push_back(
      {now.wall_ms, {}, {}, {}, {}, "host quarantined", host + ": " + quarantined.reason});
  host2crashes_.erase(found);  // `host` may be its key
}

bool JobState::has_host_besides(const std::string& host) const {
  return std::any_of(sessions_.begin(), sessions_.end(), [&](const auto& session) {
    const std::string& other = workers_.at(session.first).host;
    return other != host && !durable_.quarantined_hosts.contains(other);
  });
}

bool JobState::release_host(const std::string& host, Moment now) {
  const auto found = durable_.quarantined_hosts.find(host);
  if (found == durable_.quarantined_hosts.end()) return false;
  HostRow row = found->second;
  row.is_quarantined = false;
  row.since_ms = now.wall_ms;
  dirty_hosts_[host] = row;
  durable_.quarantined_hosts.erase(found);
  new_events_.push_back({now.wall_ms, {}, {}, {}, {}, "host let go", host});
  return true;
}

}  // namespace tetfarm
