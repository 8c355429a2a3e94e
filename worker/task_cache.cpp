#include "worker/task_cache.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "base/error.h"
#include "base/file_system.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

struct Cached {
  fs::file_time_type used;
  std::string hash;
  std::uint64_t size = 0;
};

/// By rising time of use.
std::vector<Cached> files_of(const ArtifactStore& store) {
  std::vector<Cached> files;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(store.folder() / "artifacts", error)) {
    if (!entry.is_regular_file(error)) continue;
    const std::uint64_t size = entry.file_size(error);
    const fs::file_time_type used = entry.last_write_time(error);
    files.push_back({used, entry.path().filename().string(), size});
  }
  std::sort(files.begin(), files.end(), [](const Cached& a, const Cached& b) {
    return std::tie(a.used, a.hash) < std::tie(b.used, b.hash);
  });
  return files;
}

}  // namespace

TaskCache::OwnFolder TaskCache::take_folder(const fs::path& folder) {
  for (int number = 0;; ++number) {
    const fs::path own = folder / std::to_string(number);
    make_folders(own);
    if (auto lock = FolderLock::take(own, "worker.lock")) return {own, std::move(*lock)};
  }
}

TaskCache::TaskCache(const fs::path& folder, std::uint64_t max_bytes)
    : TaskCache(take_folder(folder), max_bytes) {}

TaskCache::TaskCache(OwnFolder own, std::uint64_t max_bytes)
    : lock_(std::move(own.second)), store_(own.first), max_bytes_(max_bytes) {
  store_.sweep_scratch(0);
  make_room(0, {});
}

void TaskCache::make_room(std::uint64_t coming_bytes, const std::set<std::string>& needed) const {
  const std::vector<Cached> files = files_of(store_);
  std::uint64_t total = coming_bytes;
  for (const Cached& file : files) total += file.size;
  for (const Cached& file : files) {
    if (total <= max_bytes_) return;
    if (needed.contains(file.hash)) continue;
    remove_file(store_.path_of(file.hash));
    total -= file.size;
  }
}

void TaskCache::touch(const std::string& hash) const {
  std::error_code ignored;
  fs::last_write_time(store_.path_of(hash), fs::file_time_type::clock::now(), ignored);
}

void TaskCache::drop(const std::string& hash) const {
  if (ArtifactStore::is_hash(hash)) remove_file(store_.path_of(hash));
}

}  // namespace tetfarm
