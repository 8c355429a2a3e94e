#include "mesh/assemble/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "base/check.h"
#include "base/error.h"

namespace tetfarm {

OutputFile::OutputFile(std::filesystem::path path, Start start) : path_(std::move(path)) {
  const int emptying = start == Start::empty ? O_TRUNC : 0;
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | emptying, 0666);
  if (descriptor_ < 0) throw IoError("cannot create the file", path_.string(), errno);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::write(std::int64_t offset, std::string_view bytes) {
  TF_CHECK(descriptor_ >= 0 && offset >= 0);
  while (!bytes.empty()) {
    const ssize_t done = ::pwrite(descriptor_, bytes.data(), bytes.size(), offset);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) throw IoError("cannot write", path_.string(), done < 0 ? errno : ENOSPC);
    offset += done;
    bytes.remove_prefix(static_cast<std::size_t>(done));
    begin_to_store(done);
  }
}

/// A hint; what fails to be stored is found by `finish`.
void OutputFile::begin_to_store(std::int64_t written) {
  constexpr std::int64_t enough = 32 << 20;
  since_stored_ += written;
  if (since_stored_ < enough) return;
  since_stored_ = 0;
  ::sync_file_range(descriptor_, 0, 0, SYNC_FILE_RANGE_WRITE);
}

void OutputFile::finish() {
  TF_CHECK(descriptor_ >= 0);
  if (::fsync(descriptor_) != 0) throw IoError("cannot write", path_.string(), errno);
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    throw IoError("cannot write", path_.string(), errno);
  }
}

}  // namespace tetfarm
