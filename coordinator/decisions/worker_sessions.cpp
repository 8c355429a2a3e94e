#include "coordinator/decisions/worker_sessions.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {

void WorkerSessions::arrive(const WorkerRow& row, std::uint64_t reach_bytes) {
  WorkerSession& session = sessions_[row.id];
  session.row = row;
  session.reach_bytes = reach_bytes;
  memories_.insert(reach_bytes);
}

void WorkerSessions::introduce(WorkerId worker, const SessionTerms& terms, std::int64_t now_ms) {
  leave_seat(worker);
  WorkerSession& session = sessions_.at(worker);
  session.terms = terms;
  session.heard_ms = now_ms;
}

std::optional<WorkerId> WorkerSessions::take_seat(WorkerId worker) {
  const WorkerProcess& process = at(worker).terms.process;
  TF_CHECK(!process.nonce_hash.empty());
  const auto [seat, is_first] = process2worker_.emplace(process, worker);
  const WorkerId earlier = seat->second;
  seat->second = worker;
  return earlier == worker ? std::nullopt : std::optional(earlier);
}

void WorkerSessions::leave_seat(WorkerId worker) {
  const auto seat = process2worker_.find(at(worker).terms.process);
  if (seat != process2worker_.end() && seat->second == worker) process2worker_.erase(seat);
}

WorkerRow WorkerSessions::leave(WorkerId worker) {
  leave_seat(worker);
  idle_.erase(worker);
  auto session = sessions_.extract(worker);
  TF_CHECK(!session.mapped().attempt);
  memories_.erase(memories_.find(session.mapped().reach_bytes));
  return session.mapped().row;
}

void WorkerSessions::hold(WorkerId worker, AttemptId attempt) {
  sessions_.at(worker).attempt = attempt;
  idle_.erase(worker);
}

void WorkerSessions::let_go(WorkerId worker, AttemptId attempt) {
  const auto session = sessions_.find(worker);
  if (session != sessions_.end() && session->second.attempt == attempt) {
    session->second.attempt = {};
  }
}

void WorkerSessions::drain(WorkerId worker) {
  sessions_.at(worker).drains = true;
  idle_.erase(worker);
}

std::vector<WorkerId> WorkerSessions::silent_since(std::int64_t then_ms) const {
  std::vector<WorkerId> silent;
  for (const auto& [worker, session] : sessions_) {
    if (session.heard_ms < then_ms) silent.push_back(worker);
  }
  return silent;
}

std::optional<std::int64_t> WorkerSessions::longest_silent_ms() const {
  std::optional<std::int64_t> first_ms;
  for (const auto& [worker, session] : sessions_) {
    first_ms = std::min(first_ms.value_or(session.heard_ms), session.heard_ms);
  }
  return first_ms;
}

WorkerSessions::HostMemory WorkerSessions::used_memory(
    const std::map<AttemptId, AttemptRow>& running) const {
  HostMemory used;
  for (const auto& [id, attempt] : running) {
    const auto session = sessions_.find(attempt.worker);
    if (session != sessions_.end() && !session->second.terms.shares_memory) continue;
    used[attempt.host] += attempt.memory_bytes;
  }
  return used;
}

std::uint64_t WorkerSessions::free_memory(WorkerId worker, const HostMemory& used) const {
  const WorkerSession& session = at(worker);
  if (!session.terms.shares_memory) return session.row.memory_bytes;
  const auto found = used.find(session.row.host);
  const std::uint64_t used_bytes = found == used.end() ? 0 : found->second;
  return session.row.memory_bytes - std::min(used_bytes, session.row.memory_bytes);
}

void WorkerSessions::find_broken_session(const WorkerSession& session,
                                         const std::map<AttemptId, AttemptRow>& running,
                                         std::vector<std::string>& broken) const {
  const std::string worker = "worker " + std::to_string(session.row.id.value);
  const bool is_idle = idle_.contains(session.row.id);
  if (is_idle && session.drains) broken.push_back(worker + " is idle and drains");
  if (is_idle && session.attempt) broken.push_back(worker + " is idle and works");
  if (!session.attempt) return;
  const auto found = running.find(session.attempt);
  if (found == running.end() || found->second.worker != session.row.id) {
    broken.push_back(worker + " holds what is not its own");
  } else if (process_of(found->second) != session.terms.process) {
    broken.push_back(worker + " holds another process's attempt");
  }
}

std::vector<std::string> WorkerSessions::validate(
    const std::map<AttemptId, AttemptRow>& running) const {
  std::vector<std::string> broken;
  std::multiset<std::uint64_t> memories;
  for (const auto& [id, session] : sessions_) {
    find_broken_session(session, running, broken);
    memories.insert(session.reach_bytes);
  }
  for (const WorkerId worker : idle_) {
    if (has(worker)) continue;
    broken.push_back("worker " + std::to_string(worker.value) + " is idle and gone");
  }
  for (const auto& [process, worker] : process2worker_) {
    if (has(worker) && at(worker).terms.process == process) continue;
    broken.push_back("worker " + std::to_string(worker.value) + " is named for another's process");
  }
  if (memories_ != memories) broken.emplace_back("memory is counted wrongly");
  return broken;
}

}  // namespace tetfarm
