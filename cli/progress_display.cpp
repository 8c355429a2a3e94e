#include "cli/progress_display.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "base/check.h"
#include "base/clock.h"
#include "base/counted.h"
#include "base/printable_text.h"
#include "base/utf8.h"
#include "cli/terminal.h"
#include "proto/doing.h"
#include "tasks/task_kind.h"
#include "worker/job_forecast.h"

namespace tetfarm {
namespace {

constexpr std::int64_t between_lines_ms = 5'000;
constexpr std::int64_t between_task_stages_ms = 1'000;
constexpr std::size_t longest_bar = 24;
constexpr std::size_t shortest_bar = 4;
constexpr const char* erase_line = "\r\033[K";

template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  char text[160];
  std::snprintf(text, sizeof text, pattern, arguments...);
  return text;
}

/// The longest running one that has said something; null when none has.
const wire::RunningTask* task_to_show(const wire::JobStatus& status) {
  for (const wire::RunningTask& task : status.running()) {
    if (task.has_doing()) return &task;
  }
  return nullptr;
}

}  // namespace

std::string short_count(double count) {
  if (count < 1e4) return format("%.0f", count);
  if (count < 1e6) return format("%.1fk", count / 1e3);
  if (count < 1e9) return format("%.1fM", count / 1e6);
  return format("%.2fG", count / 1e9);
}

std::string clock_text(double seconds) {
  const auto whole = std::lround(seconds);
  if (whole < 3600) return format("%02ld:%02ld", whole / 60, whole % 60);
  return format("%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string progress_text(const wire::JobStatus& status, double tets_per_second, bool says_rate) {
  if (status.waits_for_size() > 0) {
    std::string jobs;
    for (const std::string& job : status.waits_for()) jobs += (jobs.empty() ? "" : ", ") + job;
    return "waits for " + printable(jobs);
  }
  std::string text = format("%-10s", printable(status.stage()).c_str());
  if (status.leaves_made() > 0) {
    text += format(" %u/%u sub-domains", status.leaves_meshed(), status.leaves_made());
  }
  if (status.leaves_mended() > 0) text += format("  %u improved at cuts", status.leaves_mended());
  if (status.elements() > 0) {
    text += "  " + short_count(static_cast<double>(status.elements())) + " tets";
  }
  if (says_rate && tets_per_second > 0) text += "  " + short_count(tets_per_second) + " tets/s";
  const std::optional<double> left_s = seconds_of_meshing_left(status, tets_per_second);
  if (left_s) text += "  eta " + clock_text(*left_s);
  if (status.attempts_lost() > 0) {
    text += format("  %llu lost", static_cast<unsigned long long>(status.attempts_lost()));
  }
  return text;
}

std::string running_text(const wire::JobStatus& status) {
  const wire::RunningTask* task = task_to_show(status);
  if (task == nullptr) return {};
  std::string text = task->kind() == status.stage() ? "" : printable(task->kind()) + " ";
  text += printable(doing_text(task->doing()));
  if (status.tasks_running() <= 1) return text;
  const std::uint64_t others = status.tasks_running() - 1;
  return text + " (+" + counted(others, "task") + ")";
}

std::string bar_line(double share, const std::vector<std::string>& texts, std::size_t columns) {
  TF_CHECK(!texts.empty());
  // The last column stays free: a line that wraps could not be erased.
  const std::size_t room = columns == 0                 ? std::string::npos
                           : columns > shortest_bar + 2 ? columns - shortest_bar - 2
                                                        : 1;
  const auto fits = [room](const std::string& text) { return text.size() <= room; };
  const auto found = std::find_if(texts.begin(), texts.end(), fits);
  const std::string text(found == texts.end() ? cut_utf8(texts.back(), room) : *found);
  const std::size_t bar = shortest_bar + std::min(longest_bar - shortest_bar, room - text.size());
  const auto full = static_cast<std::size_t>(share * static_cast<double>(bar));
  std::string line;
  for (std::size_t i = 0; i < bar; ++i) line += i < full ? "█" : "─";
  return line + " " + text;
}

std::string forecast_text(const wire::JobStatus& status) {
  const auto& numbers = status.numbers();
  if (!numbers.contains("forecast_seconds")) return "";
  const auto number = [&numbers](const char* name) {
    const auto found = numbers.find(name);
    return found == numbers.end() ? 0 : found->second;
  };
  return forecast_text({.elements = status.estimated_elements(),
                        .subdomains = number("parts"),
                        .task_bytes = number("forecast_bytes"),
                        .disk_bytes = number("forecast_disk_bytes"),
                        .seconds = number("forecast_seconds")});
}

double share_done(const wire::JobStatus& status, const MeshingRate& rate) {
  const std::optional<TaskKind> stage = task_kind_named(status.stage());
  if (stage == TaskKind::mesh) return rate.share();
  return stage > TaskKind::mesh ? 1 : 0;
}

ProgressDisplay::ProgressDisplay(ProgressStyle style)
    : style_(style), is_bar_(style == ProgressStyle::automatic && ::isatty(STDERR_FILENO) == 1) {}

void ProgressDisplay::show(const wire::JobStatus& status, std::uint32_t workers) {
  if (style_ == ProgressStyle::none) return;
  const std::int64_t now = steady_ms();
  if (style_ == ProgressStyle::json) {
    const std::string line = lines_.due(status, workers, now, wall_ms());
    if (!line.empty()) write_error_line(line);
    return;
  }
  show_forecast(status);
  rate_.note(status, now);
  const std::string running = running_text(status);
  if (is_bar_) return draw_bar(status, running.empty() ? "" : "  " + running);
  if (!is_line_due(status, now)) return;
  last_stage_ = status.stage();
  const wire::RunningTask* task = task_to_show(status);
  last_running_ = task == nullptr ? wire::RunningTask() : *task;
  last_line_ms_ = now;
  const std::string text = progress_text(status, rate_.tets_per_second());
  std::fprintf(stderr, "%s%s%s\n", text.c_str(), running.empty() ? "" : "  ", running.c_str());
}

/// At once with each stage of the job, sooner than otherwise with each of the task that is shown.
bool ProgressDisplay::is_line_due(const wire::JobStatus& status, std::int64_t now_ms) const {
  const std::int64_t since_ms = now_ms - last_line_ms_;
  if (status.stage() != last_stage_ || since_ms >= between_lines_ms) return true;
  const wire::RunningTask* running = task_to_show(status);
  if (running == nullptr || since_ms < between_task_stages_ms) return false;
  const bool shows_another =
      last_running_.attempt() != 0 && running->attempt() != last_running_.attempt();
  return !shows_another && running->doing().stage() != last_running_.doing().stage();
}

void ProgressDisplay::show_forecast(const wire::JobStatus& status) {
  if (style_ == ProgressStyle::none || style_ == ProgressStyle::json || told_forecast_) return;
  const std::string text = forecast_text(status);
  if (text.empty()) return;
  end();
  std::fprintf(stderr, "expected   %s\n", text.c_str());
  told_forecast_ = true;
}

void ProgressDisplay::draw_bar(const wire::JobStatus& status, const std::string& running) {
  TF_CHECK(is_bar_);
  const double rate = rate_.tets_per_second();
  const std::string line = bar_line(
      share_done(status, rate_),
      {progress_text(status, rate) + running, progress_text(status, rate, false) + running},
      terminal_columns(stderr));
  steer_terminal(stderr, erase_line);
  std::fprintf(stderr, "%s", line.c_str());
  std::fflush(stderr);
  bar_is_drawn_ = true;
}

void ProgressDisplay::end() {
  if (bar_is_drawn_) steer_terminal(stderr, erase_line);
  bar_is_drawn_ = false;
}

}  // namespace tetfarm
