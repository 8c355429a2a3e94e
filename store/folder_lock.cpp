#include "store/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <string_view>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"

namespace tetfarm {
namespace {

constexpr const char* file_of_store = "coordinator.lock";
/// A process and a name of a host: no more is looked at.
constexpr std::size_t longest_note = 300;

std::string this_host() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "?";
  return name.data();
}

/// Who has the lock is only told to people: a note that cannot be written is no trouble.
void write_note(int descriptor, const std::string& note) {
  TF_CHECK(descriptor >= 0);
  if (::ftruncate(descriptor, 0) != 0) return;
  [[maybe_unused]] const auto written = ::pwrite(descriptor, note.data(), note.size(), 0);
}

bool is_name_of_host(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '.' || c == '_' || c == '?';
  });
}

}  // namespace

std::string LockHolder::text() const {
  return "process " + std::to_string(process) + " on " + host;
}

bool LockHolder::may_live() const {
  return host != this_host() || ::kill(static_cast<pid_t>(process), 0) == 0 || errno != ESRCH;
}

std::optional<LockHolder> FolderLock::holder(const std::filesystem::path& folder,
                                             const std::string& file) {
  if (!size_of_file(folder / file)) return std::nullopt;
  const std::string note = read_part_of_file(folder / file, 0, longest_note);
  LockHolder holder;
  const char* end = note.data() + note.size();
  const auto [stopped, error] = std::from_chars(note.data(), end, holder.process);
  if (error != std::errc() || stopped == end || *stopped != ' ' || holder.process <= 0) {
    return std::nullopt;
  }
  holder.host = std::string(stopped + 1, std::find(stopped, end, '\n'));
  return is_name_of_host(holder.host) ? std::optional(holder) : std::nullopt;
}

std::optional<FolderLock> FolderLock::take(const std::filesystem::path& folder,
                                           const std::string& file) {
  std::optional<FolderLock> lock = take_unsigned(folder / file);
  if (lock) {
    write_note(lock->descriptor_, std::to_string(::getpid()) + " " + this_host() + "\n");
    lock->is_signed_ = true;
  }
  return lock;
}

std::optional<FolderLock> FolderLock::take_unsigned(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor < 0) throw IoError("cannot open", path.string(), errno);
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return FolderLock(descriptor, false);
  const int error_number = errno;
  ::close(descriptor);
  if (error_number == EWOULDBLOCK) return std::nullopt;
  throw IoError("cannot lock", path.string(), error_number);
}

FolderLock FolderLock::of_store(const std::filesystem::path& store) {
  std::optional<FolderLock> lock = take(store, file_of_store);
  if (lock) return std::move(*lock);
  const std::optional<LockHolder> other = holder_of_store(store);
  throw UsageError(
      "another coordinator is using this store" + (other ? ": " + other->text() : std::string()),
      store.string());
}

std::optional<LockHolder> FolderLock::holder_of_store(const std::filesystem::path& store) {
  return holder(store, file_of_store);
}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), is_signed_(other.is_signed_) {}

FolderLock::~FolderLock() {
  if (descriptor_ < 0) return;
  if (is_signed_) write_note(descriptor_, "");
  ::close(descriptor_);
}

}  // namespace tetfarm
