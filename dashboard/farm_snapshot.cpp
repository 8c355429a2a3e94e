#include "dashboard/farm_snapshot.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "base/check.h"
#include "dashboard/api_answer.h"
#include "json/json_line.h"

namespace tetfarm {
namespace {

std::string farm_at(const FarmSnapshot& snapshot, std::int64_t time_ms) {
  nlohmann::ordered_json json = {{"type", "farm"},
                                 {"connected", snapshot.connected},
                                 {"trouble", snapshot.trouble},
                                 {"at_rest", snapshot.at_rest},
                                 {"endpoint", snapshot.endpoint},
                                 {"time_ms", time_ms}};
  if (snapshot.farm.empty()) return json_line(json);
  const auto seen = nlohmann::ordered_json::parse(snapshot.farm);
  for (const auto& item : seen.items()) {
    // That nobody answers is worse than what whoever answered before was in trouble with.
    if (item.key() == "trouble" && !snapshot.trouble.empty()) continue;
    json[item.key()] = item.value();
  }
  return json_line(json);
}

std::string changed_jobs(const FarmSnapshot& before, const FarmSnapshot& now) {
  std::unordered_map<std::uint64_t, const std::string*> known;
  for (const NumberedLine& job : before.jobs) known[job.number] = &job.json;
  JsonList list("jobs");
  bool has_any = !before.has_seen && now.has_seen;
  for (const NumberedLine& job : now.jobs) {
    const auto old = known.find(job.number);
    if (old != known.end() && *old->second == job.json) continue;
    list.add(job.json);
    has_any = true;
  }
  return has_any ? event_message("jobs", list.take()) : "";
}

std::string new_events(const FarmSnapshot& before, const FarmSnapshot& now) {
  if (!before.has_seen) return {};
  const std::uint64_t known = before.events.empty() ? 0 : before.events.back().number;
  JsonList list("events");
  bool has_any = false;
  for (const NumberedLine& event : now.events) {
    if (event.number <= known) continue;
    list.add(event.json);
    has_any = true;
  }
  return has_any ? event_message("events", list.take()) : "";
}

}  // namespace

std::string farm_body(const FarmSnapshot& snapshot) { return farm_at(snapshot, snapshot.time_ms); }

std::string jobs_body(const FarmSnapshot& snapshot) {
  JsonList list("jobs");
  for (const NumberedLine& job : snapshot.jobs) list.add(job.json);
  return list.take();
}

std::string workers_body(const FarmSnapshot& snapshot) {
  JsonList list("workers");
  for (const std::string& worker : snapshot.workers) list.add(worker);
  return list.take();
}

std::string events_body(const FarmSnapshot& snapshot, std::size_t last) {
  JsonList list("events");
  const std::size_t count = std::min(last, snapshot.events.size());
  for (std::size_t i = snapshot.events.size() - count; i < snapshot.events.size(); ++i) {
    list.add(snapshot.events[i].json);
  }
  return list.take();
}

std::string event_message(const std::string& kind, const std::string& json) {
  TF_CHECK(json.find('\n') == std::string::npos);
  return "event: " + kind + "\ndata: " + json + "\n\n";
}

std::string first_messages(const FarmSnapshot& snapshot) {
  if (!snapshot.has_seen) return {};
  return event_message("farm", farm_body(snapshot)) + event_message("jobs", jobs_body(snapshot));
}

std::string messages_of_changes(const FarmSnapshot& before, const FarmSnapshot& now,
                                bool with_farm) {
  std::string messages;
  if (with_farm || before.has_seen != now.has_seen || farm_at(before, 0) != farm_at(now, 0)) {
    messages = event_message("farm", farm_body(now));
  }
  return messages + changed_jobs(before, now) + new_events(before, now);
}

}  // namespace tetfarm
