/// The sections of a Gmsh MSH 4.1 file that say what its entities are; shared by its writers.
#pragma once

#include <string>

#include "mesh/formats/mesh_source.h"
#include "mesh/formats/number_text.h"

namespace tetfarm {

inline constexpr std::int32_t msh_triangle_type = 2;
inline constexpr std::int32_t msh_tet_type = 4;

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

/// Ends a section: in a binary one a line must end first.
std::string msh_section_end(const std::string& name, const NumberText& style);

}  // namespace tetfarm
