#include "store/file_in_place.h"

#include <sys/stat.h>

#include <cerrno>
#include <utility>

#include "base/error.h"

namespace tetfarm {

FileInPlace::FileInPlace(std::filesystem::path path) : path_(std::move(path)) {
  struct stat about {};
  if (::stat(path_.c_str(), &about) != 0) throw IoError("cannot stat", path_.string(), errno);
  device_ = about.st_dev;
  inode_ = about.st_ino;
}

FileInPlace::State FileInPlace::look() const {
  struct stat about {};
  if (::stat(path_.c_str(), &about) == 0) {
    return about.st_dev == device_ && about.st_ino == inode_ ? State::there : State::replaced;
  }
  if (errno == ENOENT || errno == ENOTDIR) return State::removed;
  throw IoError("cannot stat", path_.string(), errno);
}

}  // namespace tetfarm
