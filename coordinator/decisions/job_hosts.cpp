/// JobState, the part about hosts on which tasks crash: who has to wait for another host, and which
/// host comes into quarantine.
#include <algorithm>

#include "coordinator/decisions/job_state.h"

namespace tetfarm {

void JobState::note_crash_on_host(const TaskRow& task, WorkerId worker,
                                  const std::string& message) {
  if (!workers_.has(worker)) return;
  host_crashes_.note_crash(workers_.at(worker).row.host, task, message,
                           [this](TaskId id) { return durable_.tasks.contains(id); });
}

/// Whether the task crashed on the host since something was last done there, and a worker of
/// another host, where it has not crashed, has the room and the time for it: that one goes first.
bool JobState::waits_for_another_host(const TaskRow& task, const std::string& host,
                                      Moment now) const {
  if (!host_crashes_.crashed_on(host, task.id)) return false;
  return std::any_of(workers_.all().begin(), workers_.all().end(), [&](const auto& entry) {
    const WorkerSession& session = entry.second;
    const WorkerRow& other = session.row;
    return other.host != host && !session.drains && does_kind(session, task.kind) &&
           memory_for(task) <= other.memory_bytes &&
           !durable_.quarantined_hosts.contains(other.host) &&
           !host_crashes_.crashed_on(other.host, task.id) && has_time_for(session, task, now);
  });
}

/// Whether all that is known of the task is that this host does not do it, and another can try.
bool JobState::counts_against_host(const TaskRow& task, WorkerId worker, Moment now) const {
  return workers_.has(worker) && host_crashes_.hosts_where_it_crashed(task.id) == 1 &&
         waits_for_another_host(task, workers_.at(worker).row.host, now);
}

void JobState::note_done_on_host(TaskId task, const std::string& host, Moment now) {
  if (const auto suspect = host_crashes_.note_done(host, task)) quarantine_if_proven(*suspect, now);
}

void JobState::quarantine_if_proven(const std::string& host, Moment now) {
  const auto proof = host_crashes_.proof_against(host, rules_.host_tasks);
  if (!proof || durable_.quarantined_hosts.contains(host) || !has_host_besides(host)) return;
  for (const auto& [id, count] : proof->crashes) {
    if (!durable_.tasks.contains(id)) continue;  // its job is over
    TaskRow& blamed = edit(id);
    blamed.crashes -= std::min(blamed.crashes, count);
  }
  const HostRow quarantined{host, true, now.wall_ms, proof->reason};
  durable_.quarantined_hosts[host] = quarantined;
  changes_.put(quarantined);
  changes_.add({now.wall_ms, {}, {}, {}, {}, "host quarantined", host + ": " + proof->reason});
  host_crashes_.forget(host);
}

bool JobState::has_host_besides(const std::string& host) const {
  return std::any_of(workers_.all().begin(), workers_.all().end(), [&](const auto& entry) {
    const std::string& other = entry.second.row.host;
    return other != host && !durable_.quarantined_hosts.contains(other);
  });
}

bool JobState::release_host(const std::string& host, Moment now) {
  const auto found = durable_.quarantined_hosts.find(host);
  if (found == durable_.quarantined_hosts.end()) return false;
  HostRow row = found->second;
  row.is_quarantined = false;
  row.since_ms = now.wall_ms;
  changes_.put(row);
  durable_.quarantined_hosts.erase(found);
  changes_.add({now.wall_ms, {}, {}, {}, {}, "host let go", host});
  return true;
}

}  // namespace tetfarm
