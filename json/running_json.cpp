#include "json/running_json.h"

#include "proto/doing.h"

namespace tetfarm {

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

}  // namespace tetfarm
