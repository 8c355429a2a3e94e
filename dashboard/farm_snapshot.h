/// What the dashboard saw of a farm at one moment, as lines of JSON, and what of it differs from
/// the moment before. Plain structures and functions; no clock.
///
/// At most 1,000 jobs and 1,000 events, the newest of them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tetfarm {

/// JSON of something that has a number.
struct NumberedLine {
  std::uint64_t number = 0;
  std::string json;
};

struct FarmSnapshot {
  bool has_seen = false;   ///< the farm, once at least; without, all below is empty
  bool connected = false;  ///< a coordinator answers
  bool at_rest = false;    ///< these are the rows of a store
  std::string trouble;     ///< why nobody answers; "": somebody does
  std::string endpoint;
  std::int64_t time_ms = 0;                         ///< when this was so, since 1970
  std::string farm;                                 ///< of farm_json, with all jobs counted
  std::vector<NumberedLine> jobs;                   ///< the newest first
  std::vector<std::string> workers;                 ///< that are here
  std::vector<NumberedLine> events;                 ///< the newest last
  std::map<std::string, std::string> running_jobs;  ///< all that is known of each, by its name
};

inline constexpr std::size_t most_jobs_seen = 1'000;
inline constexpr std::size_t most_events_seen = 1'000;

// Bodies of answers.
std::string farm_body(const FarmSnapshot& snapshot);
std::string jobs_body(const FarmSnapshot& snapshot);
std::string workers_body(const FarmSnapshot& snapshot);
/// The newest `last` of them.
std::string events_body(const FarmSnapshot& snapshot, std::size_t last);

/// A server-sent event. @pre `json` is on one line.
std::string event_message(const std::string& kind, const std::string& json);

/// What a watcher is told who comes now: the farm and all jobs; "" when nothing was seen yet.
std::string first_messages(const FarmSnapshot& snapshot);

/// What those are told who know `before`; "" when nothing has changed but the time.
/// @param with_farm the farm in any case
std::string messages_of_changes(const FarmSnapshot& before, const FarmSnapshot& now,
                                bool with_farm);

}  // namespace tetfarm
