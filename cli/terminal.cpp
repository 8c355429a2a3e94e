#include "cli/terminal.h"

#include <sys/ioctl.h>
#include <sys/types.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include "base/check.h"
#include "base/printable_text.h"

namespace tetfarm {
namespace {

constexpr std::array<std::string_view, 2> our_own = {red_begins, red_ends};
constexpr std::size_t longest_character = 4;

struct Stream {
  int fd;
  std::string kept_back;
};

bool write_all(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(fd, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// stdio takes 0 for an error.
ssize_t write_guarded(void* cookie, const char* bytes, std::size_t size) {
  Stream& stream = *static_cast<Stream*>(cookie);
  Guarded now = guarded(stream.kept_back + std::string(bytes, size));
  stream.kept_back = std::move(now.kept_back);
  return write_all(stream.fd, now.shown) ? static_cast<ssize_t>(size) : 0;
}

std::FILE* guarded_stream(Stream& stream, std::FILE* usual, int buffering) {
  std::fflush(usual);
  cookie_io_functions_t functions{};
  functions.write = write_guarded;
  std::FILE* file = ::fopencookie(&stream, "w", functions);
  if (file == nullptr) return usual;  // out of memory: what follows will say so
  std::setvbuf(file, nullptr, buffering, BUFSIZ);
  return file;
}

/// How much of the end may be the beginning of a character or of a sequence of ours.
std::size_t unfinished(std::string_view text) {
  for (const std::string_view sequence : our_own) {
    for (std::size_t size = std::min(sequence.size() - 1, text.size()); size > 0; --size) {
      if (text.ends_with(sequence.substr(0, size))) return size;
    }
  }
  for (std::size_t size = 1; size < longest_character && size <= text.size(); ++size) {
    const auto first = static_cast<unsigned char>(text[text.size() - size]);
    if ((first & 0xC0U) == 0x80U) continue;
    const std::size_t wanted = first >= 0xF0U ? 4 : first >= 0xE0U ? 3 : first >= 0xC0U ? 2 : 1;
    return wanted > size ? size : 0;
  }
  return 0;
}

int fd_of(const std::FILE* stream) { return stream == stdout ? STDOUT_FILENO : STDERR_FILENO; }

}  // namespace

Guarded guarded(std::string_view text) {
  const std::size_t kept = unfinished(text);
  TF_CHECK(kept <= text.size());
  Guarded result;
  result.kept_back = text.substr(text.size() - kept);
  text.remove_suffix(kept);
  while (!text.empty()) {
    std::size_t end = text.size();
    std::string_view next;
    for (const std::string_view sequence : our_own) {
      const std::size_t at = text.find(sequence);
      if (at >= end) continue;
      end = at;
      next = sequence;
    }
    TF_CHECK(end + next.size() > 0);  // it gets on
    result.shown += printable(text.substr(0, end), Lines::kept);
    result.shown += next;
    text.remove_prefix(end + next.size());
  }
  return result;
}

void guard_terminal() {
  static Stream out{STDOUT_FILENO, {}};
  static Stream err{STDERR_FILENO, {}};
  stdout = guarded_stream(out, stdout, ::isatty(STDOUT_FILENO) == 1 ? _IOLBF : _IOFBF);
  stderr = guarded_stream(err, stderr, _IONBF);
}

void steer_terminal(std::FILE* stream, std::string_view sequence) {
  std::fflush(stream);
  write_all(fd_of(stream), sequence);
}

std::size_t terminal_columns(std::FILE* stream) {
  winsize size{};
  return ::ioctl(fd_of(stream), TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace tetfarm
