/// How long the processes of a run live, when one that died is started again, and what it said
/// last. Units: milliseconds of the steady clock.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace tetfarm {

/// Of one member: who ends by itself again and again soon after its start waits longer each time.
struct MemberLife {
  std::int64_t started_ms = 0;
  std::int64_t start_again_ms = 0;
  int short_lives = 0;  ///< in a row

  /// @param by_itself not killed by a signal, which says nothing of whether it can work.
  void note_death(bool by_itself, std::int64_t now_ms);
};

/// The last "error: …" of a log without that word, or "". Looks at the log's end only.
/// @throws IoError.
std::string last_error(const std::filesystem::path& log);

}  // namespace tetfarm
