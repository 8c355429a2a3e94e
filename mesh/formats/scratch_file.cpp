#include "mesh/formats/scratch_file.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "base/error.h"

namespace tetfarm {

ScratchFile::ScratchFile(const std::filesystem::path& folder) : folder_(folder) {
  std::string name = (folder / "tetfarm.XXXXXX").string();
  descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) throw IoError("cannot create a file in", folder.string(), errno);
  ::unlink(name.c_str());
}

ScratchFile::ScratchFile(ScratchFile&& other) noexcept
    : folder_(std::move(other.folder_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      size_(other.size_) {}

ScratchFile& ScratchFile::operator=(ScratchFile&& other) noexcept {
  std::swap(folder_, other.folder_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(size_, other.size_);
  return *this;
}

ScratchFile::~ScratchFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void ScratchFile::append(const void* data, std::size_t bytes) { write(size_, data, bytes); }

void ScratchFile::write(std::int64_t place, const void* data, std::size_t bytes) {
  const char* next = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t done = ::pwrite(descriptor_, next, bytes, place);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) throw IoError("cannot write in", folder_.string(), done < 0 ? errno : ENOSPC);
    next += done;
    place += done;
    bytes -= static_cast<std::size_t>(done);
  }
  size_ = std::max(size_, place);
}

void ScratchFile::read(std::int64_t place, void* data, std::size_t bytes) const {
  char* next = static_cast<char*>(data);
  while (bytes > 0) {
    const ssize_t done = ::pread(descriptor_, next, bytes, place);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) throw IoError("cannot read in", folder_.string(), done < 0 ? errno : EIO);
    next += done;
    place += done;
    bytes -= static_cast<std::size_t>(done);
  }
}

}  // namespace tetfarm
