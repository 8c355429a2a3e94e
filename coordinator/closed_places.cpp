#include "coordinator/closed_places.h"

#include <algorithm>
#include <array>
#include <string>
#include <system_error>

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

const std::string database_name = "tetfarm.db";

bool is_same(const fs::path& path, const struct stat& file) {
  struct stat about {};
  return ::stat(path.c_str(), &about) == 0 && about.st_dev == file.st_dev &&
         about.st_ino == file.st_ino;
}

bool is_same(const fs::path& one, const fs::path& other) {
  struct stat about {};
  return ::stat(other.c_str(), &about) == 0 && is_same(one, about);
}

/// Whether the file is directly in the folder, under a name that begins so.
bool holds(const fs::path& folder, const struct stat& file, const std::string& beginning = "") {
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(beginning) && is_same(entry->path(), file)) return true;
  }
  return false;
}

bool holds_at_any_depth(const fs::path& folder, const struct stat& file) {
  std::error_code ignored;
  for (fs::recursive_directory_iterator entry(folder, ignored), end; entry != end;
       entry.increment(ignored)) {
    if (is_same(entry->path(), file)) return true;
  }
  return false;
}

/// Whether `real` is the folder or lies below it, also where that is mounted at another place.
bool is_or_lies_in(const fs::path& folder, const fs::path& real) {
  struct stat about {};
  if (::stat(folder.c_str(), &about) != 0) return false;
  for (fs::path above = real;; above = above.parent_path()) {
    if (is_same(above, about)) return true;
    if (above == above.parent_path()) return false;
  }
}

/// Of the store: the coordinator's own, whatever is in them.
std::array<fs::path, 2> folders_in_the_making(const ClosedPlaces& places) {
  return {places.store / "scratch", places.store / "damaged"};
}
fs::path artifacts(const ClosedPlaces& places) { return places.store / "artifacts"; }

}  // namespace

bool is_closed(const ClosedPlaces& places, const struct stat& file, const fs::path& real) {
  const auto is_it = [&](const fs::path& path) { return is_same(path, file); };
  const auto is_in = [&](const fs::path& folder) { return holds(folder, file); };
  if (std::any_of(places.files.begin(), places.files.end(), is_it) ||
      std::any_of(places.keys.begin(), places.keys.end(), is_in)) {
    return true;
  }
  if (!places.database.empty() && holds(places.database, file, database_name)) return true;
  if (places.store.empty()) return false;
  if (holds(places.store, file) || is_or_lies_in(artifacts(places), real)) return true;
  for (const fs::path& folder : folders_in_the_making(places)) {
    if (is_or_lies_in(folder, real) || holds_at_any_depth(folder, file)) return true;
  }
  return file.st_nlink > 1 && holds_at_any_depth(artifacts(places), file);
}

bool is_closed_folder(const ClosedPlaces& places, const fs::path& real) {
  const auto is_it = [&](const fs::path& folder) { return is_same(folder, real); };
  if (std::any_of(places.keys.begin(), places.keys.end(), is_it)) return true;
  if (places.store.empty()) return false;
  const auto making = folders_in_the_making(places);
  return is_it(places.store) || is_or_lies_in(artifacts(places), real) ||
         std::any_of(making.begin(), making.end(),
                     [&](const fs::path& folder) { return is_or_lies_in(folder, real); });
}

}  // namespace tetfarm
