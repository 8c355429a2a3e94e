/// The file NAME.mapbc beside a UGRID mesh: what its patches are called, and a number that tells
/// the solver what each is.
///
/// Source: FUN3D manual, "Boundary conditions"; AFLR3, "UG_IO mapbc".
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "mesh/core/patch_type.h"
#include "mesh/core/vec3.h"

namespace tetfarm {

/// 4000 wall, 3000 slip, 5000 farfield, 7011 inflow, 7012 outflow; 6661, 6662 or 6663 symmetry in a
/// plane of constant x, y or z. A patch that is symmetry and lies in no such plane has 3000, which
/// is the same to a flow; so has one that is anything else, or not specified.
int mapbc_code(PatchType type, const Box3& box);

/// What a code says; unspecified where this is not known, and for 3000, which every patch has that
/// was not specified.
PatchType type_of_mapbc_code(long code);

/// Whether mapbc_text looks at the boxes of patches of these types.
bool wants_boxes(std::span<const PatchType> types);

/// The text of the file: the number of patches, then "NUMBER CODE NAME" for each.
/// @param types,boxes one for each patch, or none: all are unspecified then, or boxes not wanted.
std::string mapbc_text(std::span<const std::string> patch_names, std::span<const PatchType> types,
                       std::span<const Box3> boxes);

/// What is read of such a file.
struct Mapbc {
  std::vector<std::string> names;
  std::vector<PatchType> types;  ///< of each
};

/// Empty where there is none. Lines that are not of this kind are left out.
Mapbc read_mapbc(const std::filesystem::path& path);

}  // namespace tetfarm
