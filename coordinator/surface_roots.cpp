#include "coordinator/surface_roots.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/file_system.h"
#include "base/undo_unless_done.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t copied_at_once = std::size_t{4} << 20U;
/// How files begin that are keys or databases of a farm, this one or another.
constexpr std::array<std::string_view, 2> secret_beginnings = {"tetfarm secret key ",
                                                               "SQLite format 3"};

class OpenFile {
 public:
  /// `name` is what the path is called in a message.
  OpenFile(const fs::path& path, int flags, const fs::path& name)
      : number_(::open(path.c_str(), flags | O_CLOEXEC)) {
    if (number_ < 0) throw IoError("cannot open", name.string(), errno);
  }
  ~OpenFile() { ::close(number_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  /// The kernel's own link to the open file; it names this file even when the path does not.
  fs::path link() const { return "/proc/self/fd/" + std::to_string(number_); }
  struct stat about(const fs::path& path) const {
    struct stat result {};
    if (::fstat(number_, &result) != 0) throw IoError("cannot stat", path.string(), errno);
    return result;
  }

 private:
  int number_;
};

bool lies_in(const fs::path& folder, const fs::path& real) {
  return std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first ==
         folder.end();
}

/// For a message: a NUL would end it.
std::string printable(const fs::path& path) {
  std::string text = path.string();
  for (std::size_t at = 0; (at = text.find('\0', at)) != std::string::npos;) {
    text.replace(at, 1, "\\0");
  }
  return text;
}

UsageError too_large(const fs::path& path) {
  return UsageError("is larger than the " + std::to_string(max_taken_bytes) +
                        " bytes that the coordinator copies; submit it with --store",
                    path.string());
}

/// What is open in a process, the coordinator's own first of all.
bool names_a_descriptor(const fs::path& path) {
  return lies_in("/proc", path) || lies_in("/dev/fd", path);
}

bool begins_like_a_secret(std::string_view bytes) {
  return std::any_of(secret_beginnings.begin(), secret_beginnings.end(),
                     [&](std::string_view beginning) { return bytes.starts_with(beginning); });
}

/// False when it is a key or a database by its content. @throws UsageError, IoError.
bool copy_out_of(const OpenFile& found, const fs::path& path, const fs::path& copy) {
  const OpenFile file(found.link(), O_RDONLY | O_NONBLOCK, path);
  std::uint64_t copied = 0;
  while (true) {
    const std::string bytes = read_part_of_file(file.link(), copied, copied_at_once);
    if (copied == 0 && begins_like_a_secret(bytes)) return false;
    if (copied + bytes.size() > max_taken_bytes) throw too_large(path);
    append_to_file(copy, copied, bytes);
    copied += bytes.size();
    if (bytes.size() < copied_at_once) return true;
  }
}

}  // namespace

SurfaceRoots::SurfaceRoots(const std::vector<fs::path>& folders, ClosedPlaces closed)
    : closed_(std::move(closed)) {
  std::error_code error;
  if (!closed_.store.empty()) store_ = fs::weakly_canonical(closed_.store, error);
  for (const fs::path& folder : folders) {
    const fs::path real = fs::canonical(folder, error);
    if (error || !fs::is_directory(real)) {
      throw UsageError("is not a folder", "--allow-root " + folder.string());
    }
    if (is_closed_folder(closed_, real)) {
      throw UsageError(
          "jobs must not name files in the store or among the keys; give surfaces a folder of "
          "their own",
          "--allow-root " + folder.string());
    }
    roots_.push_back(real);
  }
}

/// What lies in the store is open only where a folder in it is a root itself.
bool SurfaceRoots::contain(const fs::path& real) const {
  const bool is_in_store = !store_.empty() && lies_in(store_, real);
  return std::any_of(roots_.begin(), roots_.end(), [&](const fs::path& root) {
    return lies_in(root, real) && (!is_in_store || lies_in(store_, root));
  });
}

std::string SurfaceRoots::list() const {
  std::string text;
  for (const fs::path& root : roots_) text += (text.empty() ? "" : ", ") + root.string();
  return text.empty() ? "none (see --allow-root of the coordinator)" : text;
}

StoredArtifact SurfaceRoots::take(const fs::path& path, const ArtifactStore& store) const {
  if (path.string().find('\0') != std::string::npos) {
    throw UsageError("contains a NUL, which no path can", printable(path));
  }
  if (!path.is_absolute()) throw UsageError("is not an absolute path", path.string());
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path, error);
  const OutsideRoots refusal(path.string() +
                             (real == path || error ? "" : " (" + real.string() + ")") +
                             ": is not in a folder where jobs may name surfaces; submit it without "
                             "--coordinator-reads, or put it in one of these folders: " +
                             list());
  // Before it is opened: whoever may name any path must not learn what lies outside.
  if (error || names_a_descriptor(path.lexically_normal()) || !contain(real)) throw refusal;
  // Looked at before it is read: opening a device may do something.
  const OpenFile found(real, O_PATH, path);
  // Between the look and the opening a link may have taken its place: what counts is what is open.
  const fs::path opened = fs::read_symlink(found.link(), error);
  const struct stat about = found.about(path);
  if (error || !contain(opened)) throw refusal;
  const OutsideRoots secret(
      path.string() +
      ": is a key, a database or another of the farm's own files, which no job may name");
  if (is_closed(closed_, about, opened)) throw secret;
  if (!S_ISREG(about.st_mode)) throw UsageError("is not a file", path.string());
  if (static_cast<std::uint64_t>(about.st_size) > max_taken_bytes) throw too_large(path);
  const fs::path copy = store.scratch_path("surface");
  UndoUnlessDone copying([&copy] {
    std::error_code ignored;
    fs::remove(copy, ignored);
  });
  if (!copy_out_of(found, path, copy)) throw secret;
  StoredArtifact taken = store.publish_file(copy);
  copying.done();
  return taken;
}

}  // namespace tetfarm
