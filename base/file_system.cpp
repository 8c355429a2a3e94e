#include "base/file_system.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <system_error>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/error.h"
#include "base/ids.h"
#include "base/undo_unless_done.h"
#include "base/utf8.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

/// An open file descriptor; closing it where the result matters is done by close_checked.
class OpenFile {
 public:
  OpenFile(const fs::path& path, int flags, mode_t mode = 0) : OpenFile(path, flags, mode, path) {}
  /// Messages speak of `told`, which the file is to become.
  OpenFile(const fs::path& path, int flags, mode_t mode, const fs::path& told)
      : path_(told), descriptor_(::open(path.c_str(), flags | O_CLOEXEC, mode)) {
    if (descriptor_ < 0) throw IoError("cannot open", path_.string(), errno);
  }
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int descriptor() const { return descriptor_; }

  void write(std::string_view bytes) {
    TF_CHECK(descriptor_ >= 0);
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) throw IoError("cannot write", path_.string(), errno);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  std::size_t read(char* buffer, std::size_t size) {
    for (;;) {
      const ssize_t got = ::read(descriptor_, buffer, size);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) throw IoError("cannot read", path_.string(), errno);
      return static_cast<std::size_t>(got);
    }
  }

  void sync() {
    if (::fsync(descriptor_) != 0) throw IoError("cannot fsync", path_.string(), errno);
  }

  /// NFS reports a full disk or quota only here.
  void close_checked() {
    TF_CHECK(descriptor_ >= 0);
    if (::close(std::exchange(descriptor_, -1)) != 0) {
      throw IoError("cannot close", path_.string(), errno);
    }
  }

 private:
  fs::path path_;
  int descriptor_;
};

constexpr mode_t file_mode = 0644;

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

void sync_folder(const fs::path& folder) {
  OpenFile file(folder, O_RDONLY | O_DIRECTORY);
  file.sync();
}

void rename_checked(const fs::path& from, const fs::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) {
    throw IoError("cannot rename " + from.string() + " to it", to.string(), errno);
  }
}

/// Runs `make` on a temporary name beside `path`, then gives the result its name; leaves nothing
/// behind when anything fails.
template <class Make>
void replace_file(const fs::path& path, const Make& make) {
  const fs::path temp = folder_of(path) / unique_temp_name(path.filename().string());
  UndoUnlessDone growing([&temp] { ::unlink(temp.c_str()); });
  make(temp);
  rename_checked(temp, path);
  growing.done();
  sync_folder(folder_of(path));
}

void copy_durably(const fs::path& from, const fs::path& to) {
  TF_CHECK(from != to);
  OpenFile source(from, O_RDONLY);
  OpenFile target(to, O_WRONLY | O_CREAT | O_EXCL, file_mode);
  std::array<char, 1U << 16U> buffer;
  while (const std::size_t got = source.read(buffer.data(), buffer.size())) {
    target.write({buffer.data(), got});
  }
  target.sync();
  target.close_checked();
}

}  // namespace

std::string read_file(const fs::path& path) {
  OpenFile file(path, O_RDONLY);
  struct stat status {};
  if (::fstat(file.descriptor(), &status) != 0) throw IoError("cannot stat", path.string(), errno);
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(status.st_size));
  std::array<char, 1U << 16U> buffer;
  while (const std::size_t got = file.read(buffer.data(), buffer.size())) {
    bytes.append(buffer.data(), got);
  }
  return bytes;
}

std::string read_part_of_file(const fs::path& path, std::uint64_t offset, std::size_t size) {
  OpenFile file(path, O_RDONLY);
  if (::lseek(file.descriptor(), static_cast<off_t>(offset), SEEK_SET) < 0) {
    throw IoError("cannot seek", path.string(), errno);
  }
  std::string bytes(size, '\0');
  std::size_t filled = 0;
  while (filled < size) {
    const std::size_t got = file.read(bytes.data() + filled, size - filled);
    if (got == 0) break;
    filled += got;
  }
  bytes.resize(filled);
  return bytes;
}

void append_to_file(const fs::path& path, std::uint64_t offset, std::string_view bytes) {
  OpenFile file(path, O_WRONLY | O_CREAT | O_APPEND, file_mode);
  UndoUnlessDone appended([&] { return ::truncate(path.c_str(), static_cast<off_t>(offset)); });
  file.write(bytes);
  file.close_checked();
  appended.done();
}

std::optional<std::uint64_t> size_of_file(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) return static_cast<std::uint64_t>(status.st_size);
  if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
  throw IoError("cannot stat", path.string(), errno);
}

void write_file_atomically(const fs::path& path, std::string_view bytes) {
  replace_file(path, [&](const fs::path& temp) {
    OpenFile file(temp, O_WRONLY | O_CREAT | O_EXCL, file_mode, path);
    file.write(bytes);
    file.sync();
    file.close_checked();
  });
}

void publish_by_rename(const fs::path& from, const fs::path& to) {
  {
    OpenFile file(from, O_RDONLY);
    file.sync();
    file.close_checked();
  }
  rename_checked(from, to);
  sync_folder(folder_of(to));
}

void link_or_copy_file(const fs::path& from, const fs::path& to) {
  std::error_code same_error;
  if (fs::equivalent(from, to, same_error)) return;  // rename of two links to one file does nothing
  replace_file(to, [&from](const fs::path& temp) {
    if (::link(from.c_str(), temp.c_str()) != 0) copy_durably(from, temp);
  });
}

void make_folders(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> parents;  // of those that are not there yet
  for (fs::path level = folder; !fs::is_directory(level, error); level = parents.back()) {
    parents.push_back(folder_of(level));
    if (parents.back() == level) break;
  }
  if (parents.empty()) return;
  fs::create_directories(folder, error);
  if (error) throw IoError("cannot create the folder", folder.string(), error.value());
  for (const fs::path& parent : parents) sync_folder(parent);
}

void remove_file(const fs::path& path) {
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) {
    throw IoError("cannot remove", path.string(), errno);
  }
}

fs::path temporary_folder() {
  std::error_code error;
  fs::path folder = fs::temp_directory_path(error);
  if (!error) return folder;
  const char* named = std::getenv("TMPDIR");
  throw IoError("cannot put temporary files there, where $TMPDIR wants them",
                named != nullptr ? named : "/tmp", error.value());
}

std::string unique_temp_name(std::string_view stem) {
  TF_CHECK(stem.find('/') == std::string_view::npos);
  constexpr std::size_t longest_stem = 200;  // what file systems take is 255 bytes in all
  return std::string(cut_utf8(stem, longest_stem)) + "." + std::to_string(::getpid()) + "." +
         random_hex(8) + ".tmp";
}

}  // namespace tetfarm
