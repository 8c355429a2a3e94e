#include "json/query_json.h"

#include <nlohmann/json.hpp>

#include "json/json_line.h"
#include "json/reply_values.h"
#include "json/running_json.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

Json task_values(const wire::TaskLine& task) {
  Json json = {{"type", "task"},
               {"task", task.task()},
               {"job", task.job()},
               {"kind", task.kind()},
               {"path", task.path()},
               {"place", subdomain_name(task.path())},
               {"state", task.state()},
               {"attempt", task.attempt()},
               {"worker", worker_name(task.worker())},
               {"host", task.host()},
               {"errors", task.crashes()},
               {"losses", task.losses()},
               {"out_of_memory", task.oom_count()},
               {"seconds", task.seconds()},
               {"peak_rss_bytes", task.peak_rss_bytes()},
               {"memory_bytes", task.memory_bytes()},
               {"expected_seconds", task.expected_seconds()},
               {"cpu_seconds", task.cpu_seconds()},
               {"expected_bytes", task.expected_bytes()},
               {"expected_elements", task.expected_elements()},
               {"elements", task.elements()},
               {"min_dihedral_deg", task.min_dihedral_deg()},
               {"exit_code", task.exit_code()},
               {"message", task.message()}};
  add_doing(task, json);
  return json;
}

Json attempt_values(const wire::AttemptLine& attempt) {
  return {{"type", "attempt"},
          {"attempt", attempt.attempt()},
          {"job", attempt.job()},
          {"task", attempt.task()},
          {"kind", attempt.kind()},
          {"path", attempt.path()},
          {"worker", worker_name(attempt.worker())},
          {"host", attempt.host()},
          {"process", attempt.process()},
          {"state", attempt.state()},
          {"races", attempt.races()},
          {"started_ms", attempt.started_ms()},
          {"ended_ms", attempt.ended_ms()},
          {"seconds", seconds_of(attempt)},
          {"memory_bytes", attempt.memory_bytes()},
          {"peak_rss_bytes", attempt.peak_rss_bytes()},
          {"message", attempt.message()}};
}

std::string task_json(const wire::TaskLine& task) { return json_line(task_values(task)); }

std::string worker_json(const wire::WorkerLine& worker) {
  return json_line({{"type", "worker"},
                    {"worker", worker_name(worker.worker())},
                    {"host", worker.host()},
                    {"process", worker.process()},
                    {"state", worker.state()},
                    {"task", worker.task()},
                    {"cores", worker.cores()},
                    {"memory_bytes", worker.memory_bytes()},
                    {"version", worker.program_version()},
                    {"since_ms", worker.seen_ms()},
                    {"attempts_done", worker.done()},
                    {"attempts_not_done", worker.not_done()},
                    {"busy_seconds", worker.busy_seconds()},
                    {"host_in_quarantine", worker.host_in_quarantine()}});
}

std::string event_json(const wire::EventLine& event) {
  return json_line({{"type", "event"},
                    {"event", event.event()},
                    {"wall_ms", event.wall_ms()},
                    {"job", event.job()},
                    {"task", event.task()},
                    {"attempt", event.attempt()},
                    {"worker", worker_name(event.worker())},
                    {"what", event.what()},
                    {"message", event.message()}});
}

std::string attempt_json(const wire::AttemptLine& attempt, bool with_log) {
  Json json = attempt_values(attempt);
  if (with_log) json["log"] = attempt.log();
  return json_line(json);
}

std::string explanation_json(const wire::Explanation& explanation) {
  Json json = task_values(explanation.task());
  json["type"] = "explanation";
  json["subdomain"] = explanation.subdomain_state();
  json["reasons"] = Json::array();
  for (const std::string& reason : explanation.reasons()) json["reasons"].push_back(reason);
  json["expected_seconds"] = explanation.expected_seconds();
  json["limit_seconds"] = explanation.limit_seconds();
  json["room_bytes"] = explanation.room_bytes();
  json["attempts"] = Json::array();
  for (const wire::AttemptLine& attempt : explanation.attempts()) {
    json["attempts"].push_back(attempt_values(attempt));
  }
  json["inputs"] = Json::array();
  for (const wire::InputLine& input : explanation.inputs()) {
    json["inputs"].push_back({{"name", input.name()},
                              {"hash", input.hash()},
                              {"size", input.size()},
                              {"is_there", input.is_there()},
                              {"made_by_task", input.made_by()}});
  }
  return json_line(json);
}

}  // namespace tetfarm
