#include "base/program_identity.h"

#include <elf.h>
#include <link.h>

#include <algorithm>
#include <cstring>
#include <string_view>

#include "base/file_system.h"
#include "base/hash.h"
#include "base/hex_text.h"

namespace tetfarm {
namespace {

/// Names and contents of notes begin at multiples of this.
constexpr std::size_t note_alignment = 4;

std::size_t aligned(std::size_t size) {
  return (size + note_alignment - 1) / note_alignment * note_alignment;
}

/// The program itself is told of first.
int take_build_id(dl_phdr_info* object, std::size_t /*size*/, void* found) {
  constexpr int end = 1;
  for (std::size_t i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr)& segment = object->dlpi_phdr[i];
    if (segment.p_type != PT_NOTE) continue;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the loader tells addresses as numbers.
    const auto* first = reinterpret_cast<const char*>(object->dlpi_addr + segment.p_vaddr);
    const std::string id = build_id_among({first, segment.p_memsz});
    if (id.empty()) continue;
    *static_cast<std::string*>(found) = id;
    return end;
  }
  return end;
}

}  // namespace

std::string build_id_among(std::span<const char> notes) {
  constexpr std::string_view owner("GNU\0", 4);
  ElfW(Nhdr) header;
  while (notes.size() >= sizeof header) {
    std::memcpy(&header, notes.data(), sizeof header);
    notes = notes.subspan(sizeof header);
    const std::size_t name_size = aligned(header.n_namesz);
    if (name_size > notes.size() || header.n_descsz > notes.size() - name_size) return "";
    const std::string_view name(notes.data(), header.n_namesz);
    const std::span<const char> content = notes.subspan(name_size, header.n_descsz);
    if (header.n_type == NT_GNU_BUILD_ID && name == owner) {
      return hex_of_bytes({content.data(), content.size()});
    }
    notes = notes.subspan(std::min(notes.size(), name_size + aligned(header.n_descsz)));
  }
  return "";
}

std::string program_identity() {
  std::string id;
  ::dl_iterate_phdr(take_build_id, &id);
  return id.empty() ? hash128(read_file("/proc/self/exe")).hex() : id;
}

}  // namespace tetfarm
