#include <unistd.h>

#include <cstdio>
#include <string>

#include "base/clock.h"
#include "cli/commands.h"
#include "cli/farm_screen.h"
#include "cli/farm_view.h"
#include "cli/keyboard.h"
#include "cli/terminal.h"

namespace tetfarm {
namespace {

constexpr const char* begin_of_screen = "\033[H\033[2J";
constexpr std::size_t usual_lines = 24;

SeenFarm look_at_farm(FarmView& view) {
  SeenFarm seen;
  seen.status = view.status();
  wire::Query query;
  query.set_subject(wire::Query::WORKERS);
  view.ask(query, [&seen](const wire::QueryReply& page) {
    seen.workers.insert(seen.workers.end(), page.workers().begin(), page.workers().end());
  });
  return seen;
}

void show(const std::string& text) {
  const std::size_t lines = terminal_lines(stdout);
  const std::string shown =
      cut_to_screen(text, (lines < 2 ? usual_lines : lines) - 1, terminal_columns(stdout));
  steer_terminal(stdout, begin_of_screen);
  std::fputs((shown + "\nq quits").c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace

ExitCode top_command(const TopCommand& command) {
  FarmView view(command.view);
  FarmScreen screen;
  const bool is_watched =
      !command.once && ::isatty(STDOUT_FILENO) == 1 && ::isatty(STDIN_FILENO) == 1;
  if (!is_watched) {
    std::fputs(screen.text(look_at_farm(view), steady_ms()).c_str(), stdout);
    return ExitCode::ok;
  }
  const auto interval_ms = static_cast<std::int64_t>(command.interval_s * 1000);
  Keyboard keyboard;
  while (true) {
    show(screen.text(look_at_farm(view), steady_ms()));
    const std::optional<char> key = keyboard.wait_for_key(interval_ms);
    if (key == 'q' || key == 'Q') return ExitCode::ok;
  }
}

}  // namespace tetfarm
