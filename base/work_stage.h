/// What a task is busy with, as people are told: a stage of its work, and how much of that is done.
///
/// The names are those of messages, logs and JSON: they do not change. Whoever reads one that it
/// does not know leaves it out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tetfarm {

/// In the order in which a task that has them goes through them for the first time.
enum class WorkStage : std::uint8_t {
  read,
  check,
  spacing,
  cut,
  graph,
  join,
  boundary,
  edges,
  faces,
  splits,
  added_points,
  points,
  cosmetics,
  validate,
  order,
  extract,
  number,
  write,
  layers,
  solve,
  adapt,
  transfer,
  cycles,
  remeshing,
  assemble,
};
inline constexpr std::size_t work_stages = static_cast<std::size_t>(WorkStage::assemble) + 1;

struct WorkCount {
  WorkStage stage = WorkStage::read;
  std::uint64_t pass = 0;   ///< from 1; 0: it is not made in passes
  std::uint64_t done = 0;   ///< of all passes together
  std::uint64_t total = 0;  ///< of what is known so far; 0: not known

  friend bool operator==(const WorkCount&, const WorkCount&) = default;
};

/// "edges".
const char* name_of(WorkStage stage);

/// What name_of names so; nothing for another text.
std::optional<WorkStage> work_stage_of(std::string_view name);

/// For people: "recovery pass 3: 312 of 1,204 edges", "cosmetics pass 2: 5,310 tries", "cutting".
std::string work_text(const WorkCount& count);

/// "1,204"; from a million on "1.20 M" and "3.45 G".
std::string grouped_count(std::uint64_t count);

}  // namespace tetfarm
