#include "cli/keyboard.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>

#include "base/clock.h"
#include "cli/terminal.h"

namespace tetfarm {
namespace {

constexpr const char* other_screen = "\033[?1049h\033[?25l";
constexpr const char* usual_screen = "\033[?25h\033[?1049l";
constexpr char quit_key = 'q';

volatile std::sig_atomic_t is_to_quit = 0;

void note_quit(int) { is_to_quit = 1; }

}  // namespace

Keyboard::Keyboard() {
  ::tcgetattr(STDIN_FILENO, &before_);
  termios now = before_;
  now.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  ::tcsetattr(STDIN_FILENO, TCSANOW, &now);
  struct sigaction action {};
  action.sa_handler = note_quit;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(signal, &action, nullptr);
  steer_terminal(stdout, other_screen);
}

Keyboard::~Keyboard() {
  steer_terminal(stdout, usual_screen);
  ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_DFL);
}

std::optional<char> Keyboard::wait_for_key(std::int64_t timeout_ms) {
  const std::int64_t until = steady_ms() + timeout_ms;
  while (is_to_quit == 0) {
    const std::int64_t left_ms = std::max<std::int64_t>(0, until - steady_ms());
    pollfd input{STDIN_FILENO, POLLIN, 0};
    const int ready = ::poll(&input, 1, static_cast<int>(left_ms));
    if (ready == 0) return std::nullopt;
    if (ready < 0) continue;  // a signal, which may be one to quit
    char key = quit_key;
    return ::read(STDIN_FILENO, &key, 1) == 1 ? key : quit_key;
  }
  return quit_key;
}

}  // namespace tetfarm
