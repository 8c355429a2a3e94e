#include "store/artifact_store.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <system_error>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "base/hash.h"
#include "base/ids.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

constexpr const char* id_file = "store_id";
constexpr std::size_t id_bytes = 16;

std::string make_id(const fs::path& folder) {
  make_folders(folder);
  const fs::path path = folder / id_file;
  if (!size_of_file(path)) write_file_atomically(path, random_hex(id_bytes) + "\n");
  return read_file(path);
}

}  // namespace

StoredArtifact checksum_of_file(const fs::path& path) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError("cannot open", path.string(), errno != 0 ? errno : ENOENT);
  Hasher hasher;
  StoredArtifact artifact;
  std::array<char, 1U << 16U> buffer;
  do {
    file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    const auto got = static_cast<std::size_t>(file.gcount());
    hasher.add(buffer.data(), got);
    artifact.size += got;
  } while (file);
  if (file.bad()) throw IoError("cannot read", path.string(), errno != 0 ? errno : EIO);
  artifact.hash = hasher.finish().hex();
  return artifact;
}

fs::path probe_path(const ArtifactStore& store, const std::string& name) {
  return store.scratch_folder() / (std::string(probe_stem) + name);
}

ArtifactStore::ArtifactStore(fs::path folder, std::string probe)
    : folder_(std::move(folder)), probe_(std::move(probe)) {}

ArtifactStore::ArtifactStore(const fs::path& folder) : ArtifactStore(folder, make_id(folder)) {
  make_folders(scratch_folder());
  make_folders(folder_ / "artifacts");
}

ArtifactStore ArtifactStore::open_existing(const fs::path& folder) {
  return {folder, read_file(folder / id_file)};
}

bool ArtifactStore::is_hash(std::string_view text) {
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  return text.size() == 32 && std::all_of(text.begin(), text.end(), is_digit);
}

fs::path ArtifactStore::path_of(const std::string& hash) const {
  TF_CHECK(is_hash(hash));
  return folder_ / "artifacts" / hash.substr(0, 2) / hash;
}

StoredArtifact ArtifactStore::publish(std::string_view bytes) const {
  const StoredArtifact artifact{hash128(bytes).hex(), bytes.size()};
  const fs::path path = path_of(artifact.hash);
  make_folders(path.parent_path());
  write_file_atomically(path, bytes);
  return artifact;
}

StoredArtifact ArtifactStore::publish_file(const fs::path& path) const {
  const StoredArtifact artifact = checksum_of_file(path);
  adopt_checked_file(path, artifact.hash);
  return artifact;
}

void ArtifactStore::adopt_file(const fs::path& path, const StoredArtifact& announced) const {
  if (checksum_of_file(path) != announced) {
    remove_file(path);
    throw CorruptFile("does not match the announced checksum " + announced.hash, path.string());
  }
  adopt_checked_file(path, announced.hash);
}

void ArtifactStore::adopt_checked_file(const fs::path& path, const std::string& hash) const {
  TF_CHECK(is_hash(hash));
  const fs::path target = path_of(hash);
  make_folders(target.parent_path());
  try {
    publish_by_rename(path, target);
  } catch (const IoError& error) {
    if (error.error_number() != EXDEV) throw;
    link_or_copy_file(path, target);
    remove_file(path);
  }
}

bool ArtifactStore::has(const std::string& hash, std::uint64_t size) const {
  if (!is_hash(hash)) return false;
  // Asked for each file of each task: a path would be taken to pieces and put together again.
  std::string path = folder_.native();
  path.append("/artifacts/").append(hash, 0, 2).append("/").append(hash);
  struct stat about {};
  if (::stat(path.c_str(), &about) == 0) return static_cast<std::uint64_t>(about.st_size) == size;
  if (errno == ENOENT || errno == ENOTDIR) return false;
  throw IoError("cannot stat", path, errno);
}

std::string ArtifactStore::read(const std::string& hash, std::uint64_t size) const {
  if (!is_hash(hash)) throw CorruptFile("is not the name of an artifact", hash);
  const fs::path path = path_of(hash);
  std::string bytes = read_file(path);
  if (bytes.size() != size) {
    throw CorruptFile(
        "has " + std::to_string(bytes.size()) + " bytes instead of " + std::to_string(size),
        path.string());
  }
  if (hash128(bytes).hex() != hash) throw CorruptFile("its checksum is wrong", path.string());
  return bytes;
}

void ArtifactStore::verify(const std::string& hash, std::uint64_t size) const {
  if (!is_hash(hash)) throw CorruptFile("is not the name of an artifact", hash);
  const fs::path path = path_of(hash);
  const StoredArtifact found = checksum_of_file(path);
  if (found.size != size) {
    throw CorruptFile(
        "has " + std::to_string(found.size) + " bytes instead of " + std::to_string(size),
        path.string());
  }
  if (found.hash != hash) throw CorruptFile("its checksum is wrong", path.string());
}

void ArtifactStore::set_aside(const std::string& hash) const {
  const fs::path path = path_of(hash);
  if (!size_of_file(path)) return;
  make_folders(folder_ / "damaged");
  publish_by_rename(path, folder_ / "damaged" / unique_temp_name(hash));
}

fs::path ArtifactStore::scratch_path(std::string_view stem) const {
  return scratch_folder() / unique_temp_name(stem);
}

void ArtifactStore::sweep_scratch(std::int64_t age_ms) const {
  const auto limit = fs::file_time_type::clock::now() - std::chrono::milliseconds(age_ms);
  std::error_code ignored;
  for (fs::directory_iterator entry(scratch_folder(), ignored), end; entry != end;
       entry.increment(ignored)) {
    const auto touched = fs::last_write_time(entry->path(), ignored);
    if (!ignored && touched < limit) fs::remove_all(entry->path(), ignored);
    if (ignored) ignored.clear();
  }
}

}  // namespace tetfarm
