/// Progress for programs, `--progress json`: which lines go to standard error when, and that
/// nothing else does.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/command_line.h"
#include "json/meshing_rate.h"
#include "json/progress_json.h"
#include "proto/messages.pb.h"

namespace tetfarm {

/// Whether a command line asks for JSON, before it is parsed: parsing may be what fails.
bool asks_for_json_progress(int argc, const char* const* argv);

/// From here on each line of text on standard error becomes a line {"type":"message", …}.
void tell_messages_in_json();

/// The last line; nothing with other styles. Its time is now.
void tell_end(ProgressStyle style, CommandEnd end);

/// Of one job: a line at each new stage, otherwise at most one a second, of what has changed, and
/// one every five seconds though nothing has.
class ProgressLines {
 public:
  /// "": none is due. The share in it is never less than in the line before.
  /// @pre `now_ms` of a steady clock, not before that of the last call.
  std::string due(const wire::JobStatus& status, std::uint32_t workers, std::int64_t now_ms,
                  std::int64_t wall_ms);

 private:
  MeshingRate rate_;
  double share_ = 0;
  std::optional<std::int64_t> last_ms_;
  std::string last_stage_;
  std::string last_told_;  ///< without its time
};

}  // namespace tetfarm
