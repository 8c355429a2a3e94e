#include "mesh/formats/mesh_text.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "base/error.h"

namespace tetfarm {

MeshText::MeshText(const std::filesystem::path& path, char comment)
    : name_(path.string()), bytes_(mapped(name_)), scanner_(bytes_, name_, comment) {}

MeshText::~MeshText() {
  if (!bytes_.empty()) ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

std::string_view MeshText::mapped(const std::string& name) {
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
  return bytes == nullptr ? std::string_view()
                          : std::string_view(static_cast<const char*>(bytes), size);
}

void MeshText::let_go() {
  constexpr std::size_t page = 4096;
  const std::size_t read = (bytes_.size() - scanner_.bytes_left()) / page * page;
  if (read > 0) ::madvise(const_cast<char*>(bytes_.data()), read, MADV_DONTNEED);
}

}  // namespace tetfarm
