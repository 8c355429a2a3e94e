#include "coordinator/decisions/leases.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {

void Leases::begin(const AttemptRow& attempt, std::int64_t now_ms) {
  const bool is_new = leases_.emplace(attempt.id, Lease{now_ms, now_ms + lease_ms_}).second;
  TF_CHECK(is_new);
  if (!attempt.nonce_hash.empty()) process2attempt_[process_of(attempt)] = attempt.id;
}

void Leases::renew(AttemptId attempt, std::int64_t now_ms) {
  leases_.at(attempt).ends_ms = now_ms + lease_ms_;
}

void Leases::end(const AttemptRow& attempt) {
  const std::size_t ended = leases_.erase(attempt.id);
  TF_CHECK(ended == 1);
  process2attempt_.erase(process_of(attempt));
}

std::optional<AttemptId> Leases::held_by(const WorkerProcess& process) const {
  const auto held = process2attempt_.find(process);
  return held == process2attempt_.end() ? std::nullopt : std::optional(held->second);
}

std::vector<AttemptId> Leases::run_out(std::int64_t now_ms) const {
  std::vector<AttemptId> over;
  for (const auto& [attempt, lease] : leases_) {
    if (lease.ends_ms < now_ms) over.push_back(attempt);
  }
  return over;
}

std::optional<std::int64_t> Leases::first_end_ms() const {
  if (leases_.empty()) return std::nullopt;
  return std::min_element(
             leases_.begin(), leases_.end(),
             [](const auto& a, const auto& b) { return a.second.ends_ms < b.second.ends_ms; })
      ->second.ends_ms;
}

void Leases::note_work(AttemptId attempt, const WorkCount& count, double share) {
  std::optional<AttemptWork>& work = leases_.at(attempt).work;
  if (!work) work.emplace();
  work->note(count, share);
}

const AttemptWork* Leases::work_of(AttemptId attempt) const {
  const auto found = leases_.find(attempt);
  return found == leases_.end() || !found->second.work ? nullptr : &*found->second.work;
}

std::vector<std::string> Leases::validate(const std::map<AttemptId, AttemptRow>& running) const {
  std::vector<std::string> broken;
  std::map<WorkerProcess, AttemptId> held;
  for (const auto& [id, attempt] : running) {
    const std::string name = "attempt " + std::to_string(id.value);
    if (!has(id)) broken.push_back(name + " runs without a lease");
    if (attempt.nonce_hash.empty()) continue;
    if (!held.emplace(process_of(attempt), id).second) {
      broken.push_back(name + " runs in a process with another");
    }
  }
  if (held != process2attempt_) broken.emplace_back("a process holds what it does not run");
  for (const auto& [id, lease] : leases_) {
    const std::string name = "the lease of attempt " + std::to_string(id.value);
    if (!running.contains(id)) broken.push_back(name + ", which does not run");
    if (lease.ends_ms < lease.started_ms) broken.push_back(name + " ends before it begins");
  }
  return broken;
}

}  // namespace tetfarm
