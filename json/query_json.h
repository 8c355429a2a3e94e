/// The answers to a viewer's questions as lines of JSON. The keys are documented in
/// docs/operations.md and do not change.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "proto/messages.pb.h"

namespace tetfarm {

// One object, one line, no end.
std::string task_json(const wire::TaskLine& task);
std::string worker_json(const wire::WorkerLine& worker);
std::string event_json(const wire::EventLine& event);
/// With "log" when `with_log`.
std::string attempt_json(const wire::AttemptLine& attempt, bool with_log);
std::string explanation_json(const wire::Explanation& explanation);

// What task_json and (without the log) attempt_json print, key by key.
nlohmann::ordered_json task_values(const wire::TaskLine& task);
nlohmann::ordered_json attempt_values(const wire::AttemptLine& attempt);

}  // namespace tetfarm
