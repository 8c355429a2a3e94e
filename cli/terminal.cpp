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
  std::string (*rewritten)(std::string_view line) = nullptr;
};

Stream& error_stream() {
  static Stream err{STDERR_FILENO, {}};
  return err;
}

bool write_all(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(fd, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// Every line of the text that is whole; the rest is kept back.
bool write_rewritten(Stream& stream, std::string_view text) {
  stream.kept_back += text;
  std::size_t begin = 0;
  bool is_written = true;
  for (std::size_t end = 0; (end = stream.kept_back.find('\n', begin)) != std::string::npos;
       begin = end + 1) {
    if (end == begin) continue;
    const std::string line =
        stream.rewritten(std::string_view(stream.kept_back).substr(begin, end - begin)) + "\n";
    is_written = write_all(stream.fd, line) && is_written;
  }
  stream.kept_back.erase(0, begin);
  return is_written;
}

/// stdio takes 0 for an error.
ssize_t write_guarded(void* cookie, const char* bytes, std::size_t size) {
  Stream& stream = *static_cast<Stream*>(cookie);
  if (stream.rewritten != nullptr) {
    return write_rewritten(stream, {bytes, size}) ? static_cast<ssize_t>(size) : 0;
  }
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
  stdout = guarded_stream(out, stdout, ::isatty(STDOUT_FILENO) == 1 ? _IOLBF : _IOFBF);
  stderr = guarded_stream(error_stream(), stderr, _IONBF);
}

void steer_terminal(std::FILE* stream, std::string_view sequence) {
  std::fflush(stream);
  write_all(fd_of(stream), sequence);
}

void rewrite_error_lines(std::string (*rewritten)(std::string_view line)) {
  TF_CHECK(rewritten != nullptr);
  std::fflush(stderr);
  error_stream().rewritten = rewritten;
}

void write_error_line(std::string_view line) {
  TF_CHECK(line.find('\n') == std::string_view::npos);
  std::fflush(stderr);
  Stream& stream = error_stream();
  if (stream.rewritten != nullptr && !stream.kept_back.empty()) write_rewritten(stream, "\n");
  write_all(STDERR_FILENO, std::string(line) + "\n");
}

std::size_t terminal_columns(std::FILE* stream) {
  winsize size{};
  return ::ioctl(fd_of(stream), TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

std::size_t terminal_lines(std::FILE* stream) {
  winsize size{};
  return ::ioctl(fd_of(stream), TIOCGWINSZ, &size) == 0 ? size.ws_row : 0;
}

}  // namespace tetfarm
