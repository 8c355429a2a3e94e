#include "store/disk_room.h"

#include <sys/statvfs.h>

#include <cerrno>

#include "base/error.h"

namespace tetfarm {

DiskRoom disk_room(const std::filesystem::path& path) {
  struct statvfs about {};
  if (::statvfs(path.c_str(), &about) == 0) {
    return {about.f_bavail * about.f_frsize, about.f_blocks * about.f_frsize};
  }
  if (errno == ENOENT && path.has_parent_path() && path.parent_path() != path) {
    return disk_room(path.parent_path());
  }
  throw IoError("cannot tell how much room the disk has", path.string(), errno);
}

}  // namespace tetfarm
