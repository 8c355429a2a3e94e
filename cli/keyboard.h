/// The keys of a terminal, one by one, while a program has its screen: neither shown nor kept until
/// the line ends.
#pragma once

#include <termios.h>

#include <cstdint>
#include <optional>

namespace tetfarm {

/// While it lives the terminal has another screen, without a cursor; then all is as it was, also
/// after SIGINT, SIGTERM and SIGHUP, which end wait_for_key.
class Keyboard {
 public:
  /// @pre standard input and output are a terminal.
  Keyboard();
  ~Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;

  /// The next key; nothing when none comes in time. A signal that ends the program, and the end of
  /// the input, are the key q.
  std::optional<char> wait_for_key(std::int64_t timeout_ms);

 private:
  termios before_{};
};

}  // namespace tetfarm
