/// The folders out of which jobs may name surfaces (`--allow-root`), and taking a file out of them.
///
/// The coordinator may read what a submitter may not; so a path counts only where it really leads,
/// after all symbolic links, and the file that was opened is the file that is checked.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
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
  /// @throws UsageError for a root that is no folder.
  explicit SurfaceRoots(const std::vector<std::filesystem::path>& folders);

  /// Copies the file into the store.
  /// @throws OutsideRoots, UsageError for a relative path, no regular file or one larger than
  /// max_taken_bytes, IoError. Cost: one pass to copy, one for the checksum.
  StoredArtifact take(const std::filesystem::path& path, const ArtifactStore& store) const;

 private:
  bool contain(const std::filesystem::path& real) const;
  std::string list() const;

  std::vector<std::filesystem::path> roots_;  ///< without links
};

}  // namespace tetfarm
