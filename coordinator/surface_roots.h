/// The folders out of which jobs may name surfaces (`--allow-root`), and taking a file out of them.
///
/// The coordinator may read what a submitter may not; so a path counts only where it really leads,
/// after all symbolic links, and the file that was opened is the file that is checked. What lies in
/// the store, and keys, database and logs wherever they are, are never taken.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "coordinator/closed_places.h"
#include "store/artifact_store.h"

namespace tetfarm {

/// A job names a path that it may not name. Its message says which, and what it may.
class OutsideRoots : public Error {
 public:
  explicit OutsideRoots(const std::string& message) : Error(ExitCode::usage, message) {}
};

/// The largest surface that the coordinator copies itself: it answers nobody meanwhile.
inline constexpr std::uint64_t max_taken_bytes = std::uint64_t{2} << 30U;

class SurfaceRoots {
 public:
  /// A folder that holds the store does not open it; one below the store's own folder may be named.
  /// @throws UsageError for a root that is no folder, or one of the closed ones.
  SurfaceRoots(const std::vector<std::filesystem::path>& folders, ClosedPlaces closed);

  /// Copies the file into the store.
  /// @throws OutsideRoots, UsageError for a relative path, one with a NUL, no regular file or one
  /// larger than max_taken_bytes, IoError. Cost: one pass to copy, one for the checksum; see
  /// is_closed.
  StoredArtifact take(const std::filesystem::path& path, const ArtifactStore& store) const;

 private:
  bool contain(const std::filesystem::path& real) const;
  std::string list() const;

  ClosedPlaces closed_;
  std::filesystem::path store_;               ///< without links, "": none
  std::vector<std::filesystem::path> roots_;  ///< without links
};

}  // namespace tetfarm
