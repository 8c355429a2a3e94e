#include "mesh/formats/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "base/error.h"

namespace tetfarm {

InputFile::InputFile(const std::filesystem::path& path) : name_(path.string()) {
  descriptor_ = ::open(name_.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) throw IoError("cannot read", name_, errno);
  struct stat status {};
  if (::fstat(descriptor_, &status) == 0) size_ = status.st_size;
}

InputFile::InputFile(std::string_view bytes, std::string name)
    : name_(std::move(name)), bytes_(bytes), size_(std::ssize(bytes)) {}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void InputFile::read(std::int64_t place, void* data, std::size_t bytes) const {
  if (place < 0 || place > size_ || bytes > static_cast<std::size_t>(size_ - place)) {
    fail("the file ends too early", size_);
  }
  if (descriptor_ < 0) {
    if (bytes > 0) std::memcpy(data, bytes_.data() + place, bytes);
    return;
  }
  char* next = static_cast<char*>(data);
  while (bytes > 0) {
    const ssize_t done = ::pread(descriptor_, next, bytes, place);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) throw IoError("cannot read", name_, done < 0 ? errno : EIO);
    next += done;
    place += done;
    bytes -= static_cast<std::size_t>(done);
  }
}

void InputFile::fail(const std::string& what, std::int64_t place) const {
  throw InvalidInput(what, name_ + ": byte " + std::to_string(place));
}

}  // namespace tetfarm
