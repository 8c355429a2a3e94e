/// Which element a polyhedron is, told from its faces alone, and which of its nodes is which.
///
/// One face of the type is laid upon a face of the polyhedron; the edges that the two have then
/// tell where the next faces lie, and so on round the element. What does not fit anywhere is no
/// such element.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "mesh/core/face_nodes.h"

namespace tetfarm {

struct CellOfFaces {
  ElementType type = ElementType::tet;
  std::array<std::int32_t, most_element_nodes> nodes{};  ///< in our order, as many as it has

  std::span<const std::int32_t> all_nodes() const { return {nodes.data(), nodes_of(type)}; }
};

/// The normals of the faces point outwards. The element begins, of those ways that it can be seen
/// in, with the one that lays the first face of its type upon the first of `faces` that fits.
/// @return nothing when no type has such faces. Cost: O(faces squared), and the types that have as
/// many faces.
std::optional<CellOfFaces> cell_of_faces(std::span<const FaceNodes<std::int32_t>> faces);

/// Whether a type has as many triangles and quads: if so, and it is no such cell, they do not
/// close.
bool has_faces_of_a_cell(std::span<const FaceNodes<std::int32_t>> faces);

/// "tet, pyramid, prism or hex": what it may be.
std::string names_of_cells();

}  // namespace tetfarm
