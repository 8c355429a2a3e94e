#include "coordinator/views/farm_metrics.h"

#include <algorithm>
#include <cstdio>

#include "base/check.h"

namespace tetfarm {
namespace {

std::string number_text(double value) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.9g", value);
  return text.data();
}

std::string in_braces(const std::string& labels) {
  return labels.empty() ? "" : "{" + labels + "}";
}

/// A family of figures: its head, then its lines.
class Family {
 public:
  Family(std::string& text, std::string name, const char* type, const char* help)
      : text_(text), name_(std::move(name)) {
    text_ += "# HELP " + name_ + " " + help + "\n# TYPE " + name_ + " " + type + "\n";
  }
  Family& add(const std::string& labels, double value) {
    text_ += name_ + in_braces(labels) + " " + number_text(value) + "\n";
    return *this;
  }

 private:
  std::string& text_;
  std::string name_;
};

std::string label(const char* name, const std::string& value) {
  return std::string(name) + "=\"" + value + "\"";
}

void add_rows(std::string& text, const JobState& state) {
  const DurableState& rows = state.durable();
  std::map<std::string, double> tasks;
  const auto labels_of = [](TaskKind kind, TaskState task_state) {
    return label("kind", name_of(kind)) + "," + label("state", name_of(task_state));
  };
  double ready = 0;
  double bytes = 0;
  for (const auto& [id, task] : rows.tasks) {
    ++tasks[labels_of(task.kind, task.state)];
    if (task.state == TaskState::ready && rows.jobs.at(task.job).phase == JobPhase::running) {
      ++ready;
    }
    bytes = std::max(bytes, static_cast<double>(task.peak_rss_bytes));
  }
  for (const auto& [id, job] : state.finished().jobs()) {
    if (state.is_at_hand(id)) continue;
    for (const auto& [what, count] : job.tasks) {
      tasks[labels_of(what.first, what.second)] += static_cast<double>(count);
    }
    bytes = std::max(bytes, static_cast<double>(job.peak_rss_bytes));
  }
  Family by_kind(text, "tetfarm_tasks", "gauge", "Tasks of all jobs, by kind and state.");
  for (const auto& [labels, count] : tasks) by_kind.add(labels, count);
  Family(text, "tetfarm_queue_tasks", "gauge", "Tasks waiting for a worker.").add("", ready);
  Family(text, "tetfarm_task_peak_rss_bytes", "gauge", "Peak memory of the largest task.")
      .add("", bytes);
  std::map<std::string, double> jobs;
  for (const JobPhase phase : {JobPhase::waiting, JobPhase::running, JobPhase::done,
                               JobPhase::failed, JobPhase::cancelled}) {
    jobs[name_of(phase)] = 0;
  }
  for (const auto& [id, job] : rows.jobs) ++jobs[name_of(job.phase)];
  Family by_state(text, "tetfarm_jobs", "gauge", "Jobs, by state.");
  for (const auto& [phase, count] : jobs) by_state.add(label("state", phase), count);
  Family(text, "tetfarm_hosts_in_quarantine", "gauge", "Hosts in quarantine, which get no tasks.")
      .add("", static_cast<double>(rows.quarantined_hosts.size()));
}

void add_workers(std::string& text, const JobState& state) {
  std::map<std::string, double> workers = {{"busy", 0}, {"drains", 0}, {"idle", 0}};
  for (const WorkerAtWork& worker : state.workers_at_work()) {
    ++workers[worker.drains ? "drains" : worker.task ? "busy" : "idle"];
  }
  Family family(text, "tetfarm_workers", "gauge", "Connected workers, by state.");
  for (const auto& [what, count] : workers) family.add(label("state", what), count);
}

}  // namespace

void DurationHistogram::add(double value) {
  const auto* const bound = std::lower_bound(bounds.begin(), bounds.end(), value);
  const auto bin = static_cast<std::size_t>(bound - bounds.begin());
  TF_CHECK(bin < counts_.size());
  ++counts_[bin];
  sum_ += value;
}

std::string DurationHistogram::text(const std::string& name, const std::string& labels) const {
  std::string lines;
  const std::string prefix = labels.empty() ? "" : labels + ",";
  std::uint64_t below = 0;
  for (std::size_t i = 0; i <= bounds.size(); ++i) {
    below += counts_[i];
    const std::string bound = i == bounds.size() ? "+Inf" : number_text(bounds[i]);
    lines += name + "_bucket{" + prefix + label("le", bound) + "} " + std::to_string(below) + "\n";
  }
  return lines + name + "_sum" + in_braces(labels) + " " + number_text(sum_) + "\n" + name +
         "_count" + in_braces(labels) + " " + std::to_string(below) + "\n";
}

void FarmMetrics::note(const ChangeSet& changes, double commit_seconds) {
  if (changes.empty()) return;
  commit_seconds_.add(commit_seconds);
  events_ += changes.events.size();
  std::map<AttemptId, const TaskRow*> accepted;
  for (const TaskRow& task : changes.tasks) {
    if (task.state == TaskState::done) accepted[task.attempt] = &task;
  }
  for (const AttemptRow& attempt : changes.attempts) {
    if (attempt.state == AttemptState::running) continue;
    ++attempts_[name_of(attempt.state)];
    const auto task = accepted.find(attempt.id);
    if (task != accepted.end())
      task_seconds_[name_of(task->second->kind)].add(task->second->seconds);
  }
}

std::string FarmMetrics::text(const JobState& state, const Refusals& refusals,
                              const FarmSurroundings& surroundings) const {
  std::string text;
  add_rows(text, state);
  add_workers(text, state);
  Family attempts(text, "tetfarm_attempts_total", "counter",
                  "Attempts that have ended, by result.");
  for (const AttemptState result :
       {AttemptState::done, AttemptState::failed, AttemptState::crashed, AttemptState::killed,
        AttemptState::lost, AttemptState::returned, AttemptState::revoked, AttemptState::starved}) {
    const auto counted = attempts_.find(name_of(result));
    attempts.add(label("result", name_of(result)),
                 counted == attempts_.end() ? 0 : static_cast<double>(counted->second));
  }
  const Family seconds(text, "tetfarm_task_seconds", "histogram",
                       "Duration of accepted attempts, by kind.");
  for (const auto& [kind, histogram] : task_seconds_) {
    text += histogram.text("tetfarm_task_seconds", label("kind", kind));
  }
  const Family commits(text, "tetfarm_commit_seconds", "histogram",
                       "Duration of a database transaction.");
  text += commit_seconds_.text("tetfarm_commit_seconds", "");
  Family(text, "tetfarm_commits_failed_total", "counter", "Database transactions that failed.")
      .add("", static_cast<double>(failed_commits_));
  Family(text, "tetfarm_events_total", "counter", "Events written to the history.")
      .add("", static_cast<double>(events_));
  Family refused(text, "tetfarm_refusals_total", "counter", "Messages and handshakes refused.");
  for (std::size_t kind = 0; kind < refusal_kinds; ++kind) {
    const auto refusal = static_cast<Refusal>(kind);
    refused.add(label("reason", name_of(refusal)), static_cast<double>(refusals.of(refusal)));
  }
  Family(text, "tetfarm_connections", "gauge", "Connections of workers and clients.")
      .add("", static_cast<double>(surroundings.connections));
  Family(text, "tetfarm_store_free_bytes", "gauge", "Free space on the store's file system.")
      .add("", static_cast<double>(surroundings.store_free_bytes));
  Family(text, "tetfarm_store_size_bytes", "gauge", "Size of the store's file system.")
      .add("", static_cast<double>(surroundings.store_size_bytes));
  Family(text, "tetfarm_stuck", "gauge", "1 while no tasks are handed out for lack of room.")
      .add("", state.is_stuck() ? 1 : 0);
  Family(text, "tetfarm_start_time_seconds", "gauge",
         "When the coordinator started, in seconds since 1970.")
      .add("", static_cast<double>(started_wall_ms_) / 1000);
  return text;
}

}  // namespace tetfarm
