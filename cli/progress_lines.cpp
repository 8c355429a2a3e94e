#include "cli/progress_lines.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/clock.h"
#include "cli/terminal.h"
#include "json/job_share.h"

namespace tetfarm {
namespace {

constexpr std::int64_t between_changes_ms = 1'000;
constexpr std::int64_t longest_silence_ms = 5'000;

/// Its colours are for people.
std::string without_colours(std::string_view text) {
  std::string plain(text);
  for (const std::string_view colour : {red_begins, red_ends}) {
    for (std::size_t at = plain.find(colour); at != std::string::npos; at = plain.find(colour)) {
      plain.erase(at, colour.size());
    }
  }
  return plain;
}

std::string message_line(std::string_view text) {
  return message_json(without_colours(text), wall_ms());
}

}  // namespace

bool asks_for_json_progress(int argc, const char* const* argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--progress=json") return true;
    if (word == "--progress" && i + 1 < argc && std::string_view(argv[i + 1]) == "json") {
      return true;
    }
  }
  return false;
}

void tell_messages_in_json() { rewrite_error_lines(message_line); }

void tell_end(ProgressStyle style, CommandEnd end) {
  if (style != ProgressStyle::json) return;
  end.wall_ms = wall_ms();
  write_error_line(end_json(end));
}

std::string ProgressLines::due(const wire::JobStatus& status, std::uint32_t workers,
                               std::int64_t now_ms, std::int64_t wall_ms) {
  rate_.note(status, now_ms);
  share_ = std::max(share_, share_of_job(status, rate_.share()));
  JobFigures figures;
  figures.share = share_;
  figures.workers = workers;
  const std::int64_t since_ms = last_ms_ ? now_ms - *last_ms_ : longest_silence_ms;
  const std::string told = progress_json(status, figures);
  const bool is_due = status.stage() != last_stage_ || since_ms >= longest_silence_ms ||
                      (since_ms >= between_changes_ms && told != last_told_);
  if (!is_due) return {};
  last_ms_ = now_ms;
  last_stage_ = status.stage();
  last_told_ = told;
  figures.wall_ms = wall_ms;
  figures.eta_seconds = seconds_of_meshing_left(status, rate_.tets_per_second());
  return progress_json(status, figures);
}

}  // namespace tetfarm
