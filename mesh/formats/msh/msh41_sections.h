/// The sections of a Gmsh MSH 4.1 file that say what its entities are; shared by its writers.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mesh/core/elements.h"
#include "mesh/formats/mesh_source.h"
#include "mesh/formats/node_records.h"
#include "mesh/formats/number_text.h"

namespace tetfarm {

inline constexpr std::int32_t msh_triangle_type = code_of(ElementCodes::msh, ElementType::triangle);
inline constexpr std::int32_t msh_tet_type = code_of(ElementCodes::msh, ElementType::tet);

/// `style` with room for every number of the mesh: text or raw.
NumberText msh_style(const MeshOutline& outline, bool is_text);

/// $MeshFormat and $PhysicalNames.
std::string msh_head(const MeshOutline& outline, const NumberText& style);

/// $Entities of the whole mesh: a surface for each patch, `volumes` with their regions (from 1) and
/// boxes.
struct MshVolume {
  std::int32_t region = 1;
  Box3 box;
};
std::string msh_entities(const MeshOutline& outline, const std::vector<MshVolume>& volumes,
                         const NumberText& style);

/// Around all parts.
Box3 box_of(const MeshOutline& outline);

/// One entity of a list: tag, what is between, box, its one physical group, nothing that bounds it.
void put_msh_box(NumberText& numbers, const Box3& box);

/// The head of a list of nodes or elements of one entity.
struct MshBlockHead {
  std::int32_t dimension = 0;
  std::int32_t entity = 0;
  std::int32_t type_or_parametric = 0;
  std::int64_t count = 0;
};
void put_msh_block(NumberText& numbers, const MshBlockHead& head);

/// The counts of $Nodes and $Elements: `first` and `last` are the numbers of items.
void put_msh_counts(NumberText& numbers, std::int64_t blocks, std::int64_t items,
                    std::int64_t first, std::int64_t last);

template <class Element>
void put_msh_element(NumberText& numbers, std::int64_t number, const Element& element,
                     const NumberedPart& part) {
  numbers.integer(number);
  for (const std::int32_t v : element) numbers.integer(global_node(part, v) + 1);
  numbers.end_record();
}

/// The i-th element of a block.
inline void put_msh_element(NumberText& numbers, std::int64_t number, ElementType type,
                            const NumberedPart& part, std::size_t i) {
  numbers.integer(number);
  for_each_global_node(ElementCodes::msh, type, part, i,
                       [&](std::int64_t node) { numbers.integer(node + 1); });
  numbers.end_record();
}

/// Gmsh's number of a type.
inline std::int32_t msh_code(ElementType type) { return code_of(ElementCodes::msh, type); }

/// The numbers of the first tet, and of the first element of each type in blocks. Elements are
/// numbered as triangles patch after patch, other faces, tets, other cells.
struct MshNumbers {
  std::int64_t tet = 1;
  ByType<std::int64_t> block;
};
MshNumbers first_msh_numbers(const MeshOutline& outline);

/// Of each patch the number of its first triangle, and behind the last patch the next number:
/// triangles are numbered patch after patch.
std::vector<std::int64_t> first_msh_triangles(const MeshOutline& outline);

/// A file that grows at its end, with gaps to be filled later.
class GrowingEnd {
 public:
  explicit GrowingEnd(OutputFile& file) : file_(file) {}
  void write(const std::string& bytes) {
    file_.write(place_, bytes);
    place_ += std::ssize(bytes);
  }
  std::int64_t leave(std::int64_t bytes) { return std::exchange(place_, place_ + bytes); }

 private:
  OutputFile& file_;
  std::int64_t place_ = 0;
};

/// Ends a section: in a binary one a line must end first.
std::string msh_section_end(const std::string& name, const NumberText& style);

}  // namespace tetfarm
