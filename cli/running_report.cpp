#include "cli/running_report.h"

#include <cmath>

#include "cli/progress_display.h"
#include "mesh/core/subdomain.h"
#include "proto/doing.h"

namespace tetfarm {
namespace {

constexpr int most_shown = 5;

}  // namespace

template <class Task>
void add_doing(const Task& task, nlohmann::ordered_json& json) {
  json["doing"] = doing_text(task.doing());
  json["doing_stage"] = task.doing().stage();
  json["doing_pass"] = task.doing().pass();
  json["doing_done"] = task.doing().done();
  json["doing_total"] = task.doing().total();
  json["share"] = task.share();
}

template void add_doing(const wire::TaskLine& task, nlohmann::ordered_json& json);
template void add_doing(const wire::RunningTask& task, nlohmann::ordered_json& json);

nlohmann::ordered_json running_json(const wire::JobStatus& status) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const wire::RunningTask& task : status.running()) {
    nlohmann::ordered_json& json = list.emplace_back();
    json["task"] = task.task();
    json["kind"] = task.kind();
    json["path"] = task.path();
    json["attempt"] = task.attempt();
    json["seconds"] = task.seconds();
    add_doing(task, json);
  }
  return list;
}

std::string running_tasks_text(const wire::JobStatus& status) {
  std::string text;
  int shown = 0;
  for (const wire::RunningTask& task : status.running()) {
    if (!task.has_doing()) continue;
    if (++shown > most_shown) break;
    text += "         task " + std::to_string(task.task()) + ", " + task.kind() +
            (task.path() == 0 ? "" : " " + TreePath{task.path()}.text()) + ", " +
            clock_text(task.seconds()) + ": " + doing_text(task.doing()) + "\n";
  }
  return text;
}

std::string doing_with_share(const wire::TaskLine& task) {
  const std::string text = doing_text(task.doing());
  if (text.empty() || !(task.share() > 0)) return text;
  return text + ", about " + std::to_string(std::lround(100 * task.share())) + " % of the task";
}

}  // namespace tetfarm
