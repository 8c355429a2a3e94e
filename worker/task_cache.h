/// The files that a worker keeps when it does not see the store: a small store of its own, by
/// checksum too, whose oldest files go when there is no room.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include "store/artifact_store.h"
#include "store/folder_lock.h"

namespace tetfarm {

class TaskCache {
 public:
  /// Takes the first of the folders DIR/0, DIR/1, … that no other worker has. What is in it from
  /// earlier serves again; half-fetched files go.
  /// @throws IoError.
  TaskCache(const std::filesystem::path& folder, std::uint64_t max_bytes);

  const ArtifactStore& store() const { return store_; }

  /// Removes the files that were not used for longest, until those that stay and `coming_bytes`
  /// more are no more than the limit; those in `needed` stay in any case.
  /// Cost: looks at every file's size. @throws IoError.
  void make_room(std::uint64_t coming_bytes, const std::set<std::string>& needed) const;

  /// It is used now.
  void touch(const std::string& hash) const;
  /// It was found damaged.
  void drop(const std::string& hash) const;

 private:
  using OwnFolder = std::pair<std::filesystem::path, FolderLock>;
  static OwnFolder take_folder(const std::filesystem::path& folder);
  TaskCache(OwnFolder own, std::uint64_t max_bytes);

  FolderLock lock_;
  ArtifactStore store_;
  std::uint64_t max_bytes_;
};

}  // namespace tetfarm
