#include "cli/exit_codes.h"

#include <array>

namespace tetfarm {
namespace {

constexpr std::array<MeaningOfCode, 8> all_codes = {
    {{ExitCode::ok, "done"},
     {ExitCode::failed, "failed"},
     {ExitCode::usage, "invalid command line or job file"},
     {ExitCode::bad_geometry, "bad geometry"},
     {ExitCode::gate, "done, but below the quality gate"},
     {ExitCode::not_found, "not found or unreachable"},
     {ExitCode::out_of_resources, "out of disk or memory"},
     {ExitCode::stopped_at_checkpoint,
      "stopped at a checkpoint: run the same command again to continue"}}};

}  // namespace

std::span<const MeaningOfCode> exit_codes() { return all_codes; }

std::string exit_codes_text() {
  constexpr std::size_t longest_line = 80;
  std::string text;
  std::string line = "Exit codes:";
  for (const MeaningOfCode& code : all_codes) {
    const std::string next = std::to_string(static_cast<int>(code.code)) + " " + code.meaning +
                             (code.code == all_codes.back().code ? "." : ";");
    if (line.size() + 1 + next.size() > longest_line) {
      text += line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + next;
  }
  return text + line;
}

}  // namespace tetfarm
