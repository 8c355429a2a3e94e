#include "cli/chrome_trace.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "mesh/core/subdomain.h"
#include "tasks/task_kind.h"
#include "tasks/task_place.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

constexpr int waiting_process = 1;
constexpr std::int64_t us_per_ms = 1000;

/// The names of colours that the viewer knows. Perfetto colours by name instead, which is the kind.
const char* colour_of(const wire::AttemptLine& attempt) {
  if (attempt.state() == "running") return "white";
  if (attempt.state() != "done") return "terrible";
  const std::optional<TaskKind> kind = task_kind_named(attempt.kind());
  return kind ? traits_of(*kind).trace_colour : "grey";
}

std::string place_of(const wire::AttemptLine& attempt) {
  return task_place(attempt.kind(), attempt.path());
}

Json name_event(const char* what, int process, std::int64_t thread, const std::string& name) {
  return {
      {"name", what}, {"ph", "M"}, {"pid", process}, {"tid", thread}, {"args", {{"name", name}}}};
}

class Trace {
 public:
  Trace(const std::vector<wire::AttemptLine>& attempts, const std::vector<wire::EventLine>& events,
        std::int64_t now_wall_ms)
      : now_ms_(now_wall_ms), begin_ms_(now_wall_ms) {
    for (const wire::AttemptLine& attempt : attempts) {
      begin_ms_ = std::min(begin_ms_, attempt.started_ms());
      host2process_.try_emplace(attempt.host(), 0);
    }
    for (const wire::EventLine& event : events) {
      begin_ms_ = std::min(begin_ms_, event.wall_ms());
      const bool is_ready =
          event.what() == "ready" || event.what() == "again" || event.what() == "retried";
      if (is_ready && event.task() != 0) ready_ms_[event.task()].push_back(event.wall_ms());
    }
    int next = waiting_process + 1;
    for (auto& [host, process] : host2process_) process = next++;
  }

  void add_rows(const std::vector<wire::AttemptLine>& attempts) {
    add(name_event("process_name", waiting_process, 0, "waiting for a worker"));
    for (const auto& [host, process] : host2process_) {
      add(name_event("process_name", process, 0, host));
    }
    std::map<std::pair<std::string, std::int64_t>, std::uint64_t> named;
    for (const wire::AttemptLine& attempt : attempts) {
      if (!named.try_emplace({attempt.host(), attempt.process()}, attempt.worker()).second)
        continue;
      add(name_event("thread_name", host2process_.at(attempt.host()), attempt.process(),
                     "worker-" + std::to_string(attempt.worker()) + " (process " +
                         std::to_string(attempt.process()) + ")"));
    }
  }

  void add_attempt(const wire::AttemptLine& attempt) {
    const std::int64_t end_ms = attempt.ended_ms() == 0 ? now_ms_ : attempt.ended_ms();
    const bool is_good = attempt.state() == "done" || attempt.state() == "running";
    add({{"name", is_good ? attempt.kind() : attempt.kind() + " " + attempt.state()},
         {"cat", attempt.kind()},
         {"ph", "X"},
         {"ts", since_begin(attempt.started_ms())},
         {"dur", std::max<std::int64_t>(end_ms - attempt.started_ms(), 0) * us_per_ms},
         {"pid", host2process_.at(attempt.host())},
         {"tid", attempt.process()},
         {"cname", colour_of(attempt)},
         {"args",
          {{"place", place_of(attempt)},
           {"task", attempt.task()},
           {"attempt", attempt.attempt()},
           {"result", attempt.state()},
           {"races", attempt.races()},
           {"peak_rss_bytes", attempt.peak_rss_bytes()},
           {"message", attempt.message()}}}});
    add_waiting(attempt);
    free_ms_[attempt.task()] = end_ms;
  }

  std::string text() const {
    const Json json = {{"displayTimeUnit", "ms"}, {"traceEvents", events_}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  }

 private:
  void add(Json event) { events_.push_back(std::move(event)); }
  std::int64_t since_begin(std::int64_t ms) const { return (ms - begin_ms_) * us_per_ms; }

  /// From when the task was ready, or its last attempt was over, until a worker had it.
  void add_waiting(const wire::AttemptLine& attempt) {
    if (attempt.races()) return;
    const std::int64_t start_ms = attempt.started_ms();
    std::int64_t from_ms = -1;
    const auto consider = [&](std::int64_t ms) {
      if (ms <= start_ms) from_ms = std::max(from_ms, ms);
    };
    for (const std::int64_t ms : ready_ms_[attempt.task()]) consider(ms);
    const auto last = free_ms_.find(attempt.task());
    if (last != free_ms_.end()) consider(last->second);
    if (from_ms < 0 || from_ms == start_ms) return;
    for (const auto& [phase, ms] : {std::pair{"b", from_ms}, {"e", start_ms}}) {
      add({{"name", attempt.kind()},
           {"cat", "waiting"},
           {"ph", phase},
           {"id", attempt.attempt()},
           {"ts", since_begin(ms)},
           {"pid", waiting_process},
           {"tid", 0},
           {"args", {{"task", attempt.task()}, {"place", place_of(attempt)}}}});
    }
  }

  std::int64_t now_ms_;
  std::int64_t begin_ms_;
  std::map<std::string, int> host2process_;
  std::map<std::uint64_t, std::vector<std::int64_t>> ready_ms_;  ///< of tasks
  std::map<std::uint64_t, std::int64_t> free_ms_;                ///< end of a task's last attempt
  Json events_ = Json::array();
};

}  // namespace

std::string chrome_trace(const std::vector<wire::AttemptLine>& attempts,
                         const std::vector<wire::EventLine>& events, std::int64_t now_wall_ms) {
  Trace trace(attempts, events, now_wall_ms);
  trace.add_rows(attempts);
  for (const wire::AttemptLine& attempt : attempts) trace.add_attempt(attempt);
  return trace.text();
}

}  // namespace tetfarm
