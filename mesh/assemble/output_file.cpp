#include "mesh/assemble/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "base/error.h"

namespace tetfarm {

OutputFile::OutputFile(std::filesystem::path path, Start start) : path_(std::move(path)) {
  const int emptying = start == Start::empty ? O_TRUNC : 0;
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | emptying, 0666);
  if (descriptor_ < 0) throw IoError("cannot make the file", path_.string(), errno);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::write(std::int64_t offset, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::pwrite(descriptor_, bytes.data(), bytes.size(), offset);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) throw IoError("cannot write", path_.string(), done < 0 ? errno : ENOSPC);
    offset += done;
    bytes.remove_prefix(static_cast<std::size_t>(done));
  }
}

void OutputFile::finish() {
  if (::fsync(descriptor_) != 0) throw IoError("cannot write", path_.string(), errno);
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    throw IoError("cannot write", path_.string(), errno);
  }
}

}  // namespace tetfarm
