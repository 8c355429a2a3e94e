#include "store/garbage.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <system_error>

#include "base/error.h"
#include "base/file_system.h"
#include "tasks/task_kind.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

/// By so much may clocks of hosts differ.
constexpr std::int64_t margin_ms = 600'000;
constexpr std::int64_t ms_per_s = 1'000;
constexpr std::int64_t ns_per_ms = 1'000'000;

void add(const std::vector<ArtifactRef>& files, std::set<std::string>& needed) {
  for (const ArtifactRef& file : files) needed.insert(file.hash);
}

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, error);
  if (error == std::errc::no_such_file_or_directory) return files;
  for (const fs::recursive_directory_iterator end; !error && entry != end; entry.increment(error)) {
    if (!entry->is_directory()) files.push_back(entry->path());
  }
  if (error) throw IoError("cannot list", folder.string(), error.value());
  return files;
}

}  // namespace

std::set<std::string> needed_files(const DurableState& state, bool all_finished) {
  std::set<std::string> needed;
  for (const auto& [id, task] : state.tasks) {
    const JobPhase phase = state.jobs.at(task.job).phase;
    if (phase == JobPhase::cancelled || task.state == TaskState::replaced) continue;
    const bool only_ends = phase == JobPhase::done && all_finished;
    if (!only_ends || traits_of(task.kind).begins_job) add(task.inputs, needed);
    if (!only_ends || traits_of(task.kind).ends_job) add(task.outputs, needed);
  }
  return needed;
}

std::int64_t untouchable_since_ms(const DurableState& state) {
  std::int64_t since = std::numeric_limits<std::int64_t>::max();
  for (const auto& [id, attempt] : state.running_attempts) {
    since = std::min(since, attempt.started_ms - margin_ms);
  }
  return since;
}

Garbage find_garbage(const ArtifactStore& store, const std::set<std::string>& needed,
                     std::int64_t untouchable_since_ms) {
  Garbage garbage;
  const auto consider = [&](const fs::path& path) {
    struct stat about {};
    if (::lstat(path.c_str(), &about) != 0) return;
    const std::int64_t touched_ms =
        about.st_mtim.tv_sec * ms_per_s + about.st_mtim.tv_nsec / ns_per_ms;
    if (touched_ms >= untouchable_since_ms) {
      ++garbage.too_young;
      return;
    }
    garbage.files.push_back(path);
    garbage.bytes += static_cast<std::uint64_t>(about.st_size);
  };
  for (const fs::path& path : files_below(store.folder() / "artifacts")) {
    if (!needed.contains(path.filename().string())) consider(path);
  }
  for (const fs::path& path : files_below(store.scratch_folder())) consider(path);
  for (const fs::path& path : files_below(store.folder() / "damaged")) consider(path);
  std::sort(garbage.files.begin(), garbage.files.end());
  return garbage;
}

void remove_garbage(const ArtifactStore& store, const Garbage& garbage) {
  const std::set<fs::path> stay = {store.folder() / "artifacts", store.scratch_folder(),
                                   store.folder()};
  for (const fs::path& path : garbage.files) {
    remove_file(path);
    for (fs::path folder = path.parent_path(); !stay.contains(folder);
         folder = folder.parent_path()) {
      std::error_code not_empty;
      if (!fs::remove(folder, not_empty)) break;
    }
  }
}

}  // namespace tetfarm
