#include "cli/seen_times.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "base/check.h"
#include "base/error.h"
#include "cli/run_folder.h"
#include "store/job_database.h"

namespace tetfarm {
namespace {

constexpr const char* database_file = "tetfarm.db";
constexpr std::size_t tasks_in_page = 1000;

void learn_from(const TaskRow& task, TaskTimes& times) {
  if (task.state != TaskState::done || !task.numbers.contains("cpu_seconds") ||
      !task.numbers.contains("size_elements")) {
    return;
  }
  const auto told = [&task](const char* name) {
    const auto found = task.numbers.find(name);
    return found == task.numbers.end() ? 0 : found->second;
  };
  times.learn(task.kind, {told("size_elements"), told("size_triangles"), told("size_needles")},
              told("cpu_seconds"));
}

/// With two significant digits, and no more decimals than these need.
std::string two_digits(double value) {
  char text[40];
  if (value < 10) {
    std::snprintf(text, sizeof text, "%.2g", value);
  } else {
    const double step = std::pow(10, std::floor(std::log10(value)) - 1);
    std::snprintf(text, sizeof text, "%.0f", std::round(value / step) * step);
  }
  return text;
}

}  // namespace

TaskTimes times_seen_in(const std::string& store, const std::string& database) {
  TaskTimes times;
  if (store.empty()) return times;
  const std::optional<std::filesystem::path> folder = store_of(store);
  if (!folder) {
    throw Error(ExitCode::not_found,
                "\"" + store + "\" is neither a store nor the output folder of a run");
  }
  const std::filesystem::path at = database.empty() ? *folder : std::filesystem::path(database);
  const JobDatabase rows = JobDatabase::open_to_read(at / database_file);
  const JobHistory history = rows.history();
  TaskId after;
  while (true) {
    const std::vector<TaskRow> page = history.tasks({}, after, tasks_in_page);
    if (page.empty()) return times;
    for (const TaskRow& task : page) learn_from(task, times);
    TF_CHECK(page.back().id > after);  // or it would never end
    after = page.back().id;
  }
}

std::string range_text(double low_seconds, double high_seconds) {
  constexpr double minute = 60;
  constexpr double hour = 3600;
  double unit = 1;
  const char* name = "s";
  if (high_seconds >= 3 * hour) {
    unit = hour;
    name = "h";
  } else if (high_seconds >= 10 * minute) {
    unit = minute;
    name = "min";
  }
  const std::string low = two_digits(low_seconds / unit);
  const std::string high = two_digits(high_seconds / unit);
  return (low == high ? low : low + " to " + high) + " " + name;
}

}  // namespace tetfarm
