#include "store/attempt_scratch.h"

#include <charconv>
#include <chrono>
#include <optional>
#include <string>
#include <system_error>

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

const std::string stem = "attempt-";

/// The 7 of "attempt-7"; nothing for other names.
std::optional<AttemptId> attempt_of(const std::string& name) {
  if (!name.starts_with(stem)) return std::nullopt;
  AttemptId attempt;
  const char* end = name.data() + name.size();
  const auto [stopped, error] = std::from_chars(name.data() + stem.size(), end, attempt.value);
  return error == std::errc{} && stopped == end ? std::optional(attempt) : std::nullopt;
}

/// False when it cannot be told.
bool was_touched_before(const fs::path& path, std::int64_t wall_ms) {
  std::error_code error;
  const auto touched = fs::last_write_time(path, error);
  if (error) return false;
  const auto since_1970 = std::chrono::file_clock::to_sys(touched).time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(since_1970).count() < wall_ms;
}

}  // namespace

fs::path attempt_scratch(const ArtifactStore& store, AttemptId attempt) {
  return store.scratch_folder() / (stem + std::to_string(attempt.value));
}

void remove_attempt_scratch(const ArtifactStore& store, AttemptId attempt) noexcept {
  std::error_code ignored;
  fs::remove_all(attempt_scratch(store, attempt), ignored);
}

void sweep_leftovers(const ArtifactStore& store, const std::set<AttemptId>& running,
                     std::int64_t untouchable_since_ms) {
  std::error_code ignored;
  for (fs::directory_iterator entry(store.scratch_folder(), ignored), end; entry != end;
       entry.increment(ignored)) {
    const fs::path& path = entry->path();
    const std::string name = path.filename().string();
    const std::optional<AttemptId> attempt = attempt_of(name);
    const bool is_over = attempt && !running.contains(*attempt);
    const bool is_probe = name.starts_with(probe_stem);
    const bool is_old = name.ends_with(".tmp") && was_touched_before(path, untouchable_since_ms);
    if (is_over || is_probe || is_old) fs::remove_all(path, ignored);
    ignored.clear();
  }
}

}  // namespace tetfarm
