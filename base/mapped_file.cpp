#include "base/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <utility>

#include "base/error.h"

namespace tetfarm {

MappedFile::MappedFile(const std::filesystem::path& path) {
  const std::string name = path.string();
  const int descriptor = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw IoError("cannot read", name, errno);
  struct stat status {};
  const int error = ::fstat(descriptor, &status) == 0 ? 0 : errno;
  const auto size = static_cast<std::size_t>(status.st_size);
  void* bytes = nullptr;
  if (error == 0 && size > 0) bytes = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
  const int map_error = error != 0 ? error : errno;
  ::close(descriptor);
  if (error != 0 || bytes == MAP_FAILED) throw IoError("cannot read", name, map_error);
  if (bytes != nullptr) bytes_ = {static_cast<const char*>(bytes), size};
}

MappedFile::MappedFile(MappedFile&& other) noexcept
    : bytes_(std::exchange(other.bytes_, std::string_view())) {}

MappedFile& MappedFile::operator=(MappedFile&& other) noexcept {
  std::swap(bytes_, other.bytes_);
  return *this;
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

void MappedFile::let_go(std::size_t count) const {
  constexpr std::size_t page = 4096;
  const std::size_t whole_pages = std::min(count, bytes_.size()) / page * page;
  if (whole_pages == 0) return;
  ::madvise(const_cast<char*>(bytes_.data()), whole_pages, MADV_DONTNEED);
}

}  // namespace tetfarm
