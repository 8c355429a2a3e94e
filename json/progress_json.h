/// What `--progress json` tells on standard error, an object a line. The keys are documented in
/// docs/progress.md; new ones may be added, and whatever else changes raises `progress_version`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "proto/messages.pb.h"

namespace tetfarm {

inline constexpr int progress_version = 1;

// One object, one line, no end. Times are milliseconds since 1970.

struct JobFigures {
  std::int64_t wall_ms = 0;
  double share = 0;                   ///< of the job that is done, 0 to 1
  std::uint32_t workers = 0;          ///< that are there
  std::optional<double> eta_seconds;  ///< until the sub-domains are meshed; nothing: not known
};
/// {"type":"progress", …}. @pre 0 <= figures.share <= 1.
std::string progress_json(const wire::JobStatus& status, const JobFigures& figures);

struct TransferFigures {
  std::int64_t wall_ms = 0;
  std::uint64_t there_bytes = 0;
  std::uint64_t size_bytes = 0;
};
/// {"type":"transfer", …}. @param what "fetching wing.vtkhdf"
std::string transfer_json(const std::string& what, const TransferFigures& figures);

/// {"type":"message", …}: a line of text that people would have read.
std::string message_json(std::string_view text, std::int64_t wall_ms);

/// How a command ended.
struct CommandEnd {
  std::int64_t wall_ms = 0;
  std::string state;    ///< done, submitted, stopped (it can be continued) or failed
  std::string job;      ///< "": none was there, or it failed
  int exit_code = 0;    ///< that of the process
  std::string message;  ///< of an error; "": there was none
  std::string help;     ///< what to do about it; "": nothing is known
  std::vector<std::filesystem::path> files;
};
/// {"type":"end", …}: the last line.
std::string end_json(const CommandEnd& end);

}  // namespace tetfarm
