#include "coordinator/surface_roots.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "base/file_system.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

class OpenFile {
 public:
  explicit OpenFile(const fs::path& path)
      // Opening a pipe must not wait for a writer, nor a terminal become ours.
      : number_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {
    if (number_ < 0) throw IoError("cannot open", path.string(), errno);
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

}  // namespace

SurfaceRoots::SurfaceRoots(const std::vector<fs::path>& folders) {
  for (const fs::path& folder : folders) {
    std::error_code error;
    const fs::path real = fs::canonical(folder, error);
    if (error || !fs::is_directory(real)) {
      throw UsageError("is no folder", "--allow-root " + folder.string());
    }
    roots_.push_back(real);
  }
}

bool SurfaceRoots::contain(const fs::path& real) const {
  return std::any_of(roots_.begin(), roots_.end(), [&](const fs::path& root) {
    return std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end();
  });
}

std::string SurfaceRoots::list() const {
  std::string text;
  for (const fs::path& root : roots_) text += (text.empty() ? "" : ", ") + root.string();
  return text.empty() ? "none (see --allow-root of the coordinator)" : text;
}

StoredArtifact SurfaceRoots::take(const fs::path& path, const ArtifactStore& store) const {
  if (!path.is_absolute()) throw UsageError("is not an absolute path", path.string());
  const std::string roots = "; folders that jobs may name: " + list();
  // Before it is opened: whoever may name any path must not learn what lies outside.
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path, error);
  if (error || !contain(real)) {
    throw OutsideRoots(path.string() + (real == path || error ? "" : " (" + real.string() + ")") +
                       ": not a place that jobs may name" + roots);
  }
  const OpenFile file(real);
  // Between the look and the opening a link may have taken its place: what counts is what is open.
  if (!contain(fs::read_symlink(file.link(), error)) || error) {
    throw OutsideRoots(path.string() + ": not a place that jobs may name" + roots);
  }
  const struct stat about = file.about(path);
  if (!S_ISREG(about.st_mode)) throw UsageError("is no file", path.string());
  if (static_cast<std::uint64_t>(about.st_size) > max_taken_bytes) {
    throw UsageError("is larger than the " + std::to_string(max_taken_bytes) +
                         " bytes that the coordinator copies; submit it with --store",
                     path.string());
  }
  const fs::path copy = store.scratch_path("surface");
  fs::copy_file(file.link(), copy, error);
  if (error) {
    remove_file(copy);
    throw IoError("cannot copy it", path.string(), error.value());
  }
  // Workers of other users shall be able to read it.
  fs::permissions(copy, fs::perms::owner_write | fs::perms::owner_read | fs::perms::group_read |
                            fs::perms::others_read);
  return store.publish_file(copy);
}

}  // namespace tetfarm
