/// The files of parallel cosmetics: the mesh of a leaf in sections that can be read one by one, and
/// the nodes that leaves share. The grammar is in store/formats.md.
///
/// Each section has its own checksum, so that a task which needs the elements near one cut reads
/// the head of the file and those sections, never the core of a neighbour.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/hash.h"
#include "mesh/core/element_section.h"

namespace tetfarm {

/// What is known of a file of elements without reading its sections.
struct ElementFileHead {
  struct Section {
    Sharers sharers;
    std::vector<std::uint64_t> tets;       ///< of each sharer
    std::vector<std::uint64_t> triangles;  ///< of the input surface, of each sharer
    std::uint64_t offset = 0;              ///< in the file
    std::uint64_t size = 0;
    Hash128 checksum;
  };
  TreePath path;                ///< the leaf whose mesh, or whose turn in cosmetics, it is
  std::uint32_t next_node = 0;  ///< the number of the next new node of that leaf
  std::vector<Origin> gone;     ///< nodes that its turn removed, ascending
  std::vector<Section> sections;

  /// The place of the section with those sharers; nothing when there is none.
  std::optional<std::size_t> find(const Sharers& sharers) const;
};

/// Of the head only path, next_node and gone count: the rest follows from the sections and, in what
/// is extracted, from the core.
std::string elements_to_bytes(const ElementFileHead& head,
                              const std::vector<ElementSection>& sections,
                              const std::optional<CoreElements>& core = std::nullopt);

/// A file of elements, open to read. Errors: CorruptFile naming `name`, IoError.
class ElementFile {
 public:
  /// Reads and checks the head.
  ElementFile(const std::filesystem::path& path, std::string name);

  const ElementFileHead& head() const { return head_; }
  /// Reads and checks one section. @pre it is not the core.
  ElementSection read(std::size_t section);
  /// @pre the file is of what was extracted: its first entry is the core.
  CoreElements read_core();
  /// Bytes read so far.
  std::uint64_t bytes_read() const { return bytes_read_; }

 private:
  std::string read_bytes(std::uint64_t offset, std::uint64_t size);
  std::string read_body(std::size_t section);

  std::filesystem::path path_;
  std::string name_;
  ElementFileHead head_;
  std::uint64_t bytes_read_ = 0;
};

std::string shared_nodes_to_bytes(const SharedNodes& shared);
/// @throws CorruptFile naming `name`.
SharedNodes shared_nodes_from_bytes(std::string_view bytes, const std::string& name);

}  // namespace tetfarm
