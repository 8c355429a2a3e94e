/// The folder of immutable files. A file's name is the checksum of its bytes.
///
/// Several processes on several hosts use one store at once without locks: publication is atomic,
/// and two publishers of the same name write the same bytes. The layout is in store/formats.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace tetfarm {

/// What names an artifact: its checksum (XXH3-128, 32 hexadecimal digits) and its size in bytes.
struct StoredArtifact {
  std::string hash;
  std::uint64_t size = 0;

  friend bool operator==(const StoredArtifact&, const StoredArtifact&) = default;
};

/// Checksum and size of a file. @throws IoError. Cost: one pass, constant memory.
StoredArtifact checksum_of_file(const std::filesystem::path& path);

class ArtifactStore;

/// What the names of such files begin with.
inline constexpr std::string_view probe_stem = "probe-";

/// Where a worker that wants to know whether it sees the coordinator's store leaves a file of that
/// name.
std::filesystem::path probe_path(const ArtifactStore& store, const std::string& name);

class ArtifactStore {
 public:
  /// Opens the store in `folder`, and makes its folders and its id file when they are missing.
  /// @throws IoError.
  explicit ArtifactStore(const std::filesystem::path& folder);

  /// Opens a store that must already be there; for workers, whose coordinator may be on another
  /// host.
  /// @throws IoError (not_found) when there is no id file.
  static ArtifactStore open_existing(const std::filesystem::path& folder);

  /// Publishes bytes. A damaged file of the same name is replaced. @throws IoError.
  StoredArtifact publish(std::string_view bytes) const;

  /// Publishes a finished file: moves it when it lies on the store's file system (in
  /// scratch_folder()), copies it otherwise. `path` is gone afterwards. @throws IoError.
  StoredArtifact publish_file(const std::filesystem::path& path) const;

  /// As publish_file, of a file that came over a network: it must be what was announced.
  /// @throws CorruptFile when it is not; it is removed.
  void adopt_file(const std::filesystem::path& path, const StoredArtifact& announced) const;
  /// The same of a file whose checksum the caller has computed. @throws IoError.
  void adopt_checked_file(const std::filesystem::path& path, const std::string& hash) const;

  /// Where the artifact lies, or would lie. @pre is_hash(hash).
  std::filesystem::path path_of(const std::string& hash) const;

  /// Whether a file of that size is there; does not read it. False for a malformed hash.
  bool has(const std::string& hash, std::uint64_t size) const;

  /// The bytes, after checking them. @throws CorruptFile on a malformed name, a wrong size or
  /// checksum, IoError (not_found) when missing.
  std::string read(const std::string& hash, std::uint64_t size) const;

  /// Reads the file and checks size and checksum. @throws as read does. Cost: constant memory.
  void verify(const std::string& hash, std::uint64_t size) const;

  /// Moves a file found damaged into damaged/ for a person to look at; one that is gone is fine.
  /// @throws IoError.
  void set_aside(const std::string& hash) const;

  /// A new, unused path inside the store for a file (or folder) in the making.
  std::filesystem::path scratch_path(std::string_view stem) const;
  std::filesystem::path scratch_folder() const { return folder_ / "scratch"; }

  /// Removes what lies in scratch_folder() and has not been touched for `age_ms`. What cannot be
  /// removed is left for the next time: another process may sweep too.
  void sweep_scratch(std::int64_t age_ms) const;

  /// The random text of the id file: a worker that reads the same text sees the same store.
  const std::string& probe() const { return probe_; }
  const std::filesystem::path& folder() const { return folder_; }

  /// Whether `text` is a well-formed checksum: 32 lower-case hexadecimal digits.
  static bool is_hash(std::string_view text);

 private:
  ArtifactStore(std::filesystem::path folder, std::string probe);

  std::filesystem::path folder_;
  std::string probe_;
};

}  // namespace tetfarm
