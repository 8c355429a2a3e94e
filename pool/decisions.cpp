#include "pool/decisions.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

constexpr std::int64_t minute_ms = 60'000;
constexpr std::uint64_t mib = std::uint64_t{1} << 20U;

}  // namespace

std::uint64_t task_bytes(std::uint64_t job_bytes) {
  return job_bytes - std::min(job_bytes, std::max(job_bytes / 8, 128 * mib));
}

/// The batch system or a new worker failed: the next submission waits, longer each time.
void PoolDecisions::trouble(std::int64_t now_ms) {
  TF_CHECK(rules_.first_backoff_ms > 0);
  std::int64_t wait_ms = rules_.first_backoff_ms;
  for (int i = 0; i < troubles_ && wait_ms < rules_.longest_backoff_ms; ++i) wait_ms *= 2;
  ++troubles_;
  quiet_until_ms_ = now_ms + std::min(wait_ms, rules_.longest_backoff_ms);
}

void PoolDecisions::submitted(const WorkerOrder& order, const std::vector<std::string>& ids,
                              std::int64_t now_ms) {
  TF_CHECK(order.count > 0);
  for (const std::string& id : ids) {
    jobs_[id] = {.bytes = order.bytes, .submitted_ms = now_ms};
    submissions_ms_.push_back(now_ms);
  }
}

void PoolDecisions::submission_failed(const WorkerOrder& order, std::int64_t now_ms) {
  submissions_ms_.insert(submissions_ms_.end(), order.count, now_ms);
  TF_CHECK(order.count > 0);
  trouble(now_ms);
}

/// Jobs that are gone are forgotten. One whose worker never came to the coordinator, though nobody
/// told it to leave, speaks against submitting more of the kind.
void PoolDecisions::note_listing(const std::vector<PoolJob>& jobs, bool farm_answers,
                                 std::int64_t now_ms) {
  std::set<std::string> listed;
  for (const PoolJob& job : jobs) {
    listed.insert(job.id);
    Known& known = jobs_.try_emplace(job.id, Known{.submitted_ms = now_ms}).first->second;
    known.was_listed = true;
    known.bytes = job.bytes;
  }
  bool failed = false;
  std::erase_if(jobs_, [&](const auto& entry) {
    const Known& known = entry.second;
    if (listed.contains(entry.first)) return false;
    if (!known.was_listed && now_ms - known.submitted_ms < rules_.listing_ms) return false;
    const bool left = known.had_worker || known.leaves_ms >= 0 || known.cancelled_ms >= 0;
    failed = failed || (farm_answers && !left);
    return true;
  });
  if (failed) trouble(now_ms);
}

void PoolDecisions::cancel(const std::string& job, std::int64_t now_ms) {
  Known& known = jobs_[job];
  if (known.cancelled_ms >= 0 && now_ms - known.cancelled_ms < minute_ms) return;
  if (actions_.cancel.size() >= rules_.most_at_once) return;
  known.cancelled_ms = now_ms;
  actions_.cancel.push_back(job);
}

void PoolDecisions::take_job(const PoolJob& job, const PoolWorker* worker, std::int64_t now_ms) {
  Known& known = jobs_.at(job.id);
  if (job.state == PoolJobState::ending) return;
  if (worker != nullptr) {
    known.had_worker = true;
    troubles_ = 0;
  }
  const bool is_late = known.leaves_ms >= 0 && now_ms - known.leaves_ms > rules_.leave_ms;
  if (job.state == PoolJobState::broken || known.cancelled_ms >= 0 || is_late) {
    if (job.state == PoolJobState::broken && known.cancelled_ms < 0) trouble(now_ms);
    return cancel(job.id, now_ms);
  }
  if (worker != nullptr) {
    known.running_ms = -1;
    if (worker->drains && known.leaves_ms < 0) known.leaves_ms = now_ms;
    if (worker->is_shunned) drain(*worker, job.id, now_ms);
    if (known.leaves_ms >= 0) return;
    ++serving_;
    if (worker->is_busy) {
      known.surplus_ms = -1;
    } else {
      idle_.emplace(worker->bytes, Server{worker->bytes, job.id, worker->worker});
    }
    return;
  }
  if (known.leaves_ms >= 0) return;
  if (job.state == PoolJobState::pending) known.running_ms = -1;
  if (job.state == PoolJobState::running) {
    if (known.running_ms < 0) known.running_ms = now_ms;
    if (now_ms - known.running_ms > rules_.start_ms) {
      trouble(now_ms);
      return cancel(job.id, now_ms);
    }
  }
  ++serving_;
  coming_.emplace(task_bytes(job.bytes), Server{task_bytes(job.bytes), job.id, 0});
}

void PoolDecisions::sort_servers(const PoolView& view, std::int64_t now_ms) {
  std::map<std::string, const PoolWorker*> ours;
  const std::string prefix = rules_.name + "/";
  for (const PoolWorker& worker : view.farm->workers) {
    if (worker.tag.starts_with(prefix)) {
      ours[worker.tag.substr(prefix.size())] = &worker;
    } else if (!worker.is_busy && !worker.drains && !worker.is_shunned) {
      idle_.emplace(worker.bytes, Server{worker.bytes, "", worker.worker});
    }
  }
  for (const PoolJob& job : *view.jobs) {
    const auto worker = ours.find(job.id);
    take_job(job, worker == ours.end() ? nullptr : worker->second, now_ms);
  }
  for (const auto& [id, known] : jobs_) {
    if (known.was_listed) continue;
    ++serving_;
    coming_.emplace(task_bytes(known.bytes), Server{task_bytes(known.bytes), id, 0});
  }
  present_ = jobs_.size();
}

/// Gives each task the smallest free worker that holds it, the largest tasks first; idle workers
/// before those to come. Returns the memory of the tasks that none is left for, at most `max`.
std::vector<std::uint64_t> PoolDecisions::match(
    const std::map<std::uint64_t, std::uint64_t>& demand) {
  std::vector<std::uint64_t> missing;
  for (auto need = demand.rbegin(); need != demand.rend(); ++need) {
    const std::uint64_t bytes = std::min(need->first, task_bytes(rules_.most_bytes));
    for (std::uint64_t i = 0; i < need->second && missing.size() < rules_.max; ++i) {
      Free& from = idle_.lower_bound(bytes) != idle_.end() ? idle_ : coming_;
      const auto server = from.lower_bound(bytes);
      if (server == from.end()) {
        missing.push_back(bytes);
        continue;
      }
      wanted_.insert(server->second.id);
      from.erase(server);
    }
  }
  return missing;
}

/// The smallest job whose worker holds the task, of the least size doubled again and again: few
/// sizes, so that jobs serve other tasks too.
std::uint64_t PoolDecisions::size_for(std::uint64_t need) const {
  std::uint64_t bytes = rules_.least_bytes;
  while (task_bytes(bytes) < need && bytes < rules_.most_bytes) bytes *= 2;
  TF_CHECK(bytes > 0);
  return std::min(bytes, rules_.most_bytes);
}

/// How many jobs may be submitted now.
std::size_t PoolDecisions::budget(std::int64_t now_ms) {
  while (!submissions_ms_.empty() && submissions_ms_.front() <= now_ms - minute_ms) {
    submissions_ms_.pop_front();
  }
  if (now_ms < quiet_until_ms_ || present_ >= rules_.max) return 0;
  const std::size_t used = std::min(submissions_ms_.size(), rules_.jobs_a_minute);
  return std::min(rules_.max - present_, rules_.jobs_a_minute - used);
}

void PoolDecisions::order(const std::vector<std::uint64_t>& missing, std::int64_t now_ms) {
  std::size_t left = budget(now_ms);
  std::map<std::uint64_t, std::size_t> counts;
  for (const std::uint64_t need : missing) {
    if (left == 0) break;
    ++counts[size_for(need)];
    --left;
    ++serving_;
  }
  while (serving_ < rules_.min && left > 0) {
    ++counts[rules_.least_bytes];
    --left;
    ++serving_;
  }
  for (auto [bytes, count] : counts) {
    for (; count > 0; count -= std::min(count, rules_.most_at_once)) {
      actions_.submit.push_back({std::min(count, rules_.most_at_once), bytes});
    }
  }
  TF_CHECK(left <= rules_.jobs_a_minute);
}

/// Whether nobody has wanted it for a while, and the minimum can do without.
bool PoolDecisions::is_spare(const Server& server, bool at_once, std::int64_t patience_ms,
                             std::int64_t now_ms) {
  if (server.id.empty()) return false;
  Known& known = jobs_.at(server.id);
  if (known.surplus_ms < 0) known.surplus_ms = now_ms;
  return serving_ > rules_.min && (at_once || now_ms - known.surplus_ms >= patience_ms);
}

void PoolDecisions::drain(const PoolWorker& worker, const std::string& job, std::int64_t now_ms) {
  Known& known = jobs_.at(job);
  if (known.leaves_ms >= 0) return;
  known.leaves_ms = now_ms;
  actions_.drain.push_back(worker.worker);
}

/// Waiting jobs are cancelled, workers drained; without a coordinator to do it, cancelled too.
void PoolDecisions::let_all_go(const PoolView& view, std::int64_t now_ms) {
  std::map<std::string, const PoolWorker*> ours;
  const std::string prefix = rules_.name + "/";
  if (view.farm) {
    for (const PoolWorker& worker : view.farm->workers) {
      if (worker.tag.starts_with(prefix)) ours[worker.tag.substr(prefix.size())] = &worker;
    }
  }
  for (const PoolJob& job : *view.jobs) {
    const auto worker = ours.find(job.id);
    const Known& known = jobs_.at(job.id);
    const bool is_late = known.leaves_ms >= 0 && now_ms - known.leaves_ms > rules_.leave_ms;
    if (worker != ours.end() && !is_late) {
      drain(*worker->second, job.id, now_ms);
    } else if (job.state != PoolJobState::ending && (known.leaves_ms < 0 || is_late)) {
      cancel(job.id, now_ms);
    }
  }
}

void PoolDecisions::let_go(std::int64_t now_ms) {
  for (const std::string& id : wanted_) {
    const auto known = jobs_.find(id);
    if (known != jobs_.end()) known->second.surplus_ms = -1;
  }
  std::size_t excess = serving_ - std::min(serving_, rules_.max);
  for (const auto& [bytes, server] : coming_) {
    if (!is_spare(server, excess > 0, rules_.unwanted_ms, now_ms)) continue;
    if (!jobs_.at(server.id).was_listed) continue;
    cancel(server.id, now_ms);
    --serving_;
    excess -= std::min<std::size_t>(excess, 1);
  }
  for (const auto& [bytes, server] : idle_) {
    if (!is_spare(server, excess > 0, rules_.idle_ms, now_ms)) continue;
    actions_.drain.push_back(server.worker);
    jobs_.at(server.id).leaves_ms = now_ms;
    --serving_;
    excess -= std::min<std::size_t>(excess, 1);
  }
}

PoolActions PoolDecisions::decide(const PoolView& view, std::int64_t now_ms) {
  actions_ = {};
  serving_ = 0;
  idle_.clear();
  coming_.clear();
  wanted_.clear();
  if (!view.jobs) {
    trouble(now_ms);
    return {};
  }
  note_listing(*view.jobs, view.farm.has_value(), now_ms);
  if (rules_.stops) {
    let_all_go(view, now_ms);
  } else if (view.farm) {
    sort_servers(view, now_ms);
    order(match(view.farm->demand), now_ms);
    let_go(now_ms);
  }
  return actions_;
}

}  // namespace tetfarm
