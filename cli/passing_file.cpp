#include "cli/passing_file.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/retry_on_eintr.h"

namespace tetfarm {
namespace {

/// Of the child: until nobody holds the other end. It calls what may be called after a fork beside
/// threads, and no signal of the terminal ends it.
[[noreturn]] void remove_after_parent(const char* path, int parent_is_over) {
  ::setsid();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::signal(signal, SIG_IGN);
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
  // Connections of the parent shall end when it closes them.
  constexpr int kept = STDERR_FILENO + 1;
  if (parent_is_over != kept) ::dup2(parent_is_over, kept);
  ::close_range(kept + 1, ~0U, 0);
  char byte = 0;
  retry_on_eintr([&] { return ::read(kept, &byte, 1); });
  ::unlink(path);
  ::_exit(0);
}

}  // namespace

PassingFile::PassingFile(const std::filesystem::path& folder) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw IoError("cannot create a pipe for", folder.string(), errno);
  std::string name = (folder / "tetfarm.XXXXXX").string();
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  const int file_error = errno;
  if (file >= 0) ::close(file);
  const pid_t process = file < 0 ? -1 : ::fork();
  if (process == 0) {
    ::close(ends[1]);
    remove_after_parent(name.c_str(), ends[0]);
  }
  const int fork_error = errno;
  ::close(ends[0]);
  if (process > 0) {
    path_ = name;
    alive_ = ends[1];
    remover_ = process;
    return;
  }
  ::close(ends[1]);
  if (file < 0) throw IoError("cannot create a file in", folder.string(), file_error);
  ::unlink(name.c_str());
  throw IoError("cannot start a process to remove", name, fork_error);
}

PassingFile::PassingFile(PassingFile&& other) noexcept
    : path_(std::move(other.path_)),
      alive_(std::exchange(other.alive_, -1)),
      remover_(std::exchange(other.remover_, -1)) {}

PassingFile& PassingFile::operator=(PassingFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(alive_, other.alive_);
  std::swap(remover_, other.remover_);
  return *this;
}

PassingFile::~PassingFile() {
  if (remover_ < 0) return;
  ::close(alive_);
  retry_on_eintr([this] { return ::waitpid(remover_, nullptr, 0); });
}

}  // namespace tetfarm
