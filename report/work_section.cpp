#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <optional>

#include "base/check.h"
#include "mesh/assemble/global_numbering.h"
#include "mesh/core/subdomain.h"
#include "report/html_table.h"
#include "report/html_text.h"
#include "report/report_page.h"
#include "report/svg_charts.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

constexpr const char* lost_colour = "#111111";

/// In the order in which the kinds come; those that this program does not know are the last.
std::size_t place_of_kind(std::string_view name) {
  const std::optional<TaskKind> kind = task_kind_named(name);
  return kind ? static_cast<std::size_t>(*kind) : all_task_kinds.size();
}
std::string colour_of(std::string_view name) {
  const std::optional<TaskKind> kind = task_kind_named(name);
  return kind ? traits_of(*kind).colour : "#999999";
}

template <class... Arguments>
std::string format(const char* pattern, Arguments... arguments) {
  char text[300];
  std::snprintf(text, sizeof text, pattern, arguments...);
  return text;
}

std::string place_of(std::uint64_t path) { return path == 0 ? "" : TreePath{path}.text(); }

/// Those that are done, kind by kind, in tree order.
std::vector<wire::TaskLine> done_tasks(const ReportedWork& work) {
  std::vector<wire::TaskLine> tasks;
  for (const wire::TaskLine& task : work.tasks) {
    if (task.state() == "done") tasks.push_back(task);
  }
  std::stable_sort(tasks.begin(), tasks.end(), [](const auto& a, const auto& b) {
    if (place_of_kind(a.kind()) != place_of_kind(b.kind()))
      return place_of_kind(a.kind()) < place_of_kind(b.kind());
    return a.path() != 0 && b.path() != 0 && comes_before({a.path()}, {b.path()});
  });
  return tasks;
}

/// What the tasks of one kind were expected to take and took.
struct KindSums {
  int count = 0;
  double expected_seconds = 0;
  double cpu_seconds = 0;
  double seconds = 0;
  double expected_bytes = 0;  ///< the largest, as the next
  double bytes = 0;
  double expected_elements = 0;
  double elements = 0;

  void add(const wire::TaskLine& task) {
    ++count;
    expected_seconds += task.expected_seconds();
    cpu_seconds += task.cpu_seconds();
    seconds += task.seconds();
    expected_bytes = std::max(expected_bytes, task.expected_bytes());
    bytes = std::max(bytes, static_cast<double>(task.peak_rss_bytes()));
    // Only a mesh has both the estimate and the count of one sub-domain.
    if (task.kind() != "mesh") return;
    expected_elements += task.expected_elements();
    elements += task.elements();
  }
};

std::string by_kind(const std::vector<wire::TaskLine>& tasks) {
  std::map<std::size_t, KindSums> sums;
  for (const wire::TaskLine& task : tasks) sums[place_of_kind(task.kind())].add(task);
  std::vector<std::vector<std::string>> rows;
  for (const auto& [place, sum] : sums) {
    const bool is_mesh = sum.elements > 0;
    rows.push_back({place < all_task_kinds.size() ? name_of(all_task_kinds.at(place)) : "other",
                    std::to_string(sum.count), format("%.2f", sum.expected_seconds),
                    format("%.2f", sum.cpu_seconds), format("%.2f", sum.seconds),
                    format("%.1f", sum.expected_bytes / 1e6), format("%.1f", sum.bytes / 1e6),
                    is_mesh ? short_number(sum.expected_elements) : "",
                    is_mesh ? short_number(sum.elements) : ""});
  }
  return "<div class=\"scroll\">" +
         html_table({"kind", "tasks", "expected s", "CPU s", "s", "bound MB", "peak MB",
                     "estimated tets", "tets made"},
                    rows) +
         "</div>\n<p class=\"note\">Seconds are sums; expected seconds are for one core of the "
         "machine that they were measured on. Memory is that of the largest task; no task should "
         "reach the bound.</p>\n";
}

PointChart points_of(const std::vector<wire::TaskLine>& tasks, bool is_memory) {
  PointChart chart{.title = is_memory ? "Memory of each task, MB" : "Time of each task, s",
                   .x_name = is_memory ? "expected bound" : "expected",
                   .y_name = is_memory ? "peak" : "CPU"};
  for (const wire::TaskLine& task : tasks) {
    const double x = is_memory ? task.expected_bytes() / 1e6 : task.expected_seconds();
    const double y =
        is_memory ? static_cast<double>(task.peak_rss_bytes()) / 1e6 : task.cpu_seconds();
    chart.points.push_back(
        {x, y, colour_of(task.kind()),
         task.kind() + " " + place_of(task.path()) + format(": %.3g expected, %.3g", x, y)});
  }
  return chart;
}

std::string all_tasks(const std::vector<wire::TaskLine>& tasks) {
  constexpr std::size_t most = 2000;
  std::vector<std::vector<std::string>> rows;
  for (const wire::TaskLine& task : tasks) {
    if (rows.size() == most) break;
    const bool is_mesh = task.kind() == "mesh";
    rows.push_back({task.kind() + " " + place_of(task.path()),
                    format("%.3f", task.expected_seconds()), format("%.3f", task.cpu_seconds()),
                    format("%.3f", task.seconds()), format("%.1f", task.expected_bytes() / 1e6),
                    format("%.1f", static_cast<double>(task.peak_rss_bytes()) / 1e6),
                    is_mesh ? format("%.0f", task.expected_elements()) : "",
                    is_mesh ? format("%.0f", task.elements()) : "",
                    task.losses() + task.crashes() + task.oom_count() == 0
                        ? ""
                        : std::to_string(task.losses() + task.crashes() + task.oom_count())});
  }
  return format("<details><summary>Each task (%zu of %zu)</summary><div class=\"scroll\">",
                rows.size(), tasks.size()) +
         html_table({"task", "expected s", "CPU s", "s", "bound MB", "peak MB", "estimated tets",
                     "tets made", "failed attempts"},
                    rows) +
         "</div></details>\n";
}

Timeline timeline_of(const std::vector<wire::AttemptLine>& attempts) {
  Timeline timeline;
  std::map<std::pair<std::string, std::int64_t>, std::size_t> worker2row;
  std::int64_t begin_ms = 0;
  for (const wire::AttemptLine& attempt : attempts) {
    worker2row[{attempt.host(), attempt.process()}] = 0;
    if (begin_ms == 0 || attempt.started_ms() < begin_ms) begin_ms = attempt.started_ms();
  }
  for (auto& [worker, row] : worker2row) {
    row = timeline.rows.size();
    timeline.rows.push_back(worker.first + " " + std::to_string(worker.second));
  }
  const auto seconds = [&](std::int64_t ms) { return static_cast<double>(ms - begin_ms) / 1000; };
  for (const wire::AttemptLine& attempt : attempts) {
    if (attempt.ended_ms() == 0) continue;
    TF_CHECK(timeline.rows.size() == worker2row.size());
    const bool is_good = attempt.state() == "done";
    timeline.spans.push_back(
        {worker2row.at({attempt.host(), attempt.process()}), seconds(attempt.started_ms()),
         seconds(attempt.ended_ms()), is_good ? colour_of(attempt.kind()) : lost_colour,
         attempt.kind() + " " + place_of(attempt.path()) + (is_good ? "" : " " + attempt.state()) +
             format(", %.3f s", seconds(attempt.ended_ms()) - seconds(attempt.started_ms()))});
  }
  return timeline;
}

std::string legend(const std::vector<wire::AttemptLine>& attempts) {
  std::string html = "<p class=\"note\">";
  const auto key = [&](std::string_view colour, std::string_view name) {
    html += "<span class=\"key\" style=\"background:" + std::string(colour) + "\"></span>" +
            escaped(name);
  };
  for (const TaskKind kind : all_task_kinds) {
    const TaskKindTraits& traits = traits_of(kind);
    const bool is_there = std::any_of(attempts.begin(), attempts.end(), [&](const auto& attempt) {
      return attempt.kind() == traits.name;
    });
    if (is_there) key(traits.colour, traits.name);
  }
  const bool has_lost = std::any_of(attempts.begin(), attempts.end(), [](const auto& attempt) {
    return attempt.ended_ms() != 0 && attempt.state() != "done";
  });
  if (has_lost) key(lost_colour, "failed or lost");
  return html + "</p>\n";
}

/// The share of the time from first to last in which the workers that were there had an attempt.
std::string facts(const ReportedWork& work) {
  const wire::JobStatus& status = work.status;
  double busy = 0;
  for (const wire::AttemptLine& attempt : work.attempts) {
    if (attempt.ended_ms() != 0) {
      busy += static_cast<double>(attempt.ended_ms() - attempt.started_ms()) / 1000;
    }
  }
  std::vector<std::vector<std::string>> rows = {
      {"job", status.job() + " (" + status.state() + ")"},
      {"from submission to end", format("%.1f s", status.seconds())},
      {"attempts", std::to_string(work.attempts.size())},
      {"busy with attempts", format("%.1f s, all workers together", busy)},
      {"memory of the largest task",
       format("%.1f MB", static_cast<double>(status.peak_rss_bytes_worker()) / 1e6)},
      {"attempts lost", std::to_string(status.attempts_lost())}};
  if (!status.message().empty()) rows.push_back({"message", status.message()});
  const auto digest = status.texts().find("digest");
  if (digest != status.texts().end()) rows.push_back({"digest of the mesh", digest->second});
  return html_table({}, rows);
}

}  // namespace

std::string work_section(const ReportedWork& work) {
  const std::vector<wire::TaskLine> tasks = done_tasks(work);
  std::string html(measured_part);
  html += "\n<h2>Work</h2>\n" + facts(work);
  if (!work.attempts.empty()) {
    html += "<h3>What each worker did</h3>\n" + legend(work.attempts) +
            svg_of(timeline_of(work.attempts)) + "\n";
  }
  html += "<h3>Expected and measured</h3>\n" + by_kind(tasks) + "<div class=\"pair\">" +
          svg_of(points_of(tasks, false)) + svg_of(points_of(tasks, true)) + "</div>\n" +
          all_tasks(tasks);
  return html + "</section>\n";
}

std::vector<double> estimated_elements_of_leaves(const ReportedWork& work) {
  std::vector<double> estimated;
  for (const wire::TaskLine& task : done_tasks(work)) {
    if (task.kind() == "mesh") estimated.push_back(task.expected_elements());
  }
  return estimated;
}

}  // namespace tetfarm
