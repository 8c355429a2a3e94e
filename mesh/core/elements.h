/// The one table of element types: nodes, faces, edges, which way round is positive, and the code
/// and the order of nodes in the formats that number them.
///
/// Our own order is that of Gmsh and CGNS. A tet has its fourth node on the side of the first three
/// from which they turn anticlockwise; so has a pyramid its apex above its base 0, 1, 2, 3; a prism
/// has the triangle 3, 4, 5 above 0, 1, 2, a hex the quad 4, 5, 6, 7 above 0, 1, 2, 3. Faces are
/// listed with their normals outwards.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "mesh/core/vec3.h"

namespace tetfarm {

/// First those of two dimensions, which are the faces of the others. Wherever types are listed one
/// after the other, they are in this order.
enum class ElementType : std::uint8_t { triangle, quad, tet, pyramid, prism, hex };

inline constexpr std::array all_element_types = {ElementType::triangle, ElementType::quad,
                                                 ElementType::tet,      ElementType::pyramid,
                                                 ElementType::prism,    ElementType::hex};
inline constexpr std::size_t most_element_nodes = 8;
inline constexpr std::size_t most_face_nodes = 4;

/// Something for each type.
template <class Value>
class ByType {
 public:
  constexpr Value& operator[](ElementType type) { return values_[static_cast<std::size_t>(type)]; }
  constexpr const Value& operator[](ElementType type) const {
    return values_[static_cast<std::size_t>(type)];
  }
  friend bool operator==(const ByType&, const ByType&) = default;

 private:
  std::array<Value, all_element_types.size()> values_{};
};

/// A face of an element, by the element's nodes.
struct ElementFace {
  ElementType type = ElementType::triangle;
  std::array<std::uint8_t, most_face_nodes> nodes{};  ///< as many as its type has
};

struct Element {
  std::string_view name;
  std::string_view plural;
  int dimension = 3;
  std::span<const ElementFace> faces;  ///< none in two dimensions
  std::span<const std::array<std::uint8_t, 2>> edges;
};

const Element& element(ElementType type);
/// The number of its nodes, known to the compiler.
constexpr std::size_t nodes_of(ElementType type) {
  constexpr std::array<std::size_t, all_element_types.size()> nodes = {3, 4, 4, 5, 6, 8};
  return nodes[static_cast<std::size_t>(type)];
}
/// A cell fills space; others are faces.
constexpr bool is_cell(ElementType type) { return type > ElementType::quad; }
/// "3 prisms", "1 tet".
std::string text_of_count(std::int64_t count, ElementType type);

/// The numberings of element types that formats share.
enum class ElementCodes : std::uint8_t {
  vtk,    ///< VTK's cell types: VTKHDF, VTK XML, SU2
  cgns,   ///< ElementType_t
  msh,    ///< Gmsh's element types
  medit,  ///< the keywords of GMF's lists
  ugrid,  ///< which of the seven counts of UGRID it is, from 0: that of the nodes
};

/// Of each numbering the codes of triangle, quad, tet, pyramid, prism, hex; 0: it has none.
/// Sources: vtkCellType.h, and SU2's documentation, "Mesh file"; CGNS SIDS, "Element numbering
/// conventions", with the values of cgnslib.h; Gmsh reference manual, "MSH file format";
/// libMeshb's documentation, "GMF file format"; UG_IO documentation, "UGRID file type".
inline constexpr std::array<std::array<std::int32_t, all_element_types.size()>, 5> element_codes = {
    {{5, 9, 10, 14, 13, 12},
     {5, 7, 10, 12, 14, 17},
     {2, 3, 4, 7, 6, 5},
     {6, 7, 8, 49, 9, 10},
     {1, 2, 3, 4, 5, 6}}};

constexpr std::int32_t code_of(ElementCodes codes, ElementType type) {
  return element_codes[static_cast<std::size_t>(codes)][static_cast<std::size_t>(type)];
}
/// @return nothing when no type here has that code.
constexpr std::optional<ElementType> type_of(ElementCodes codes, std::int64_t code) {
  for (const ElementType type : all_element_types) {
    if (code != 0 && code_of(codes, type) == code) return type;
  }
  return std::nullopt;
}

/// Which of our nodes stands k-th in that format; as many entries count as the type has nodes.
/// @throws Error when the numbering has none for the type: the format cannot hold it.
/// Two are not everybody's. Of VTK_WEDGE the class says that the normal of its points 0, 1, 2
/// points out of it. In UGRID the base of a pyramid is its nodes 1, 4, 5, 2, seen from its apex,
/// which is 3.
const std::array<std::uint8_t, most_element_nodes>& node_order(ElementCodes codes,
                                                               ElementType type);

/// The nodes of an element, given in our order, in that of a format, and the other way round.
/// @pre `to` is as long as `from`, which has the nodes of the type.
template <class From, class To>
void put_in_order_of(ElementCodes codes, ElementType type, std::span<const From> from,
                     std::span<To> to) {
  const auto& order = node_order(codes, type);
  for (std::size_t k = 0; k < to.size(); ++k) to[k] = static_cast<To>(from[order[k]]);
}
template <class From, class To>
void take_from_order_of(ElementCodes codes, ElementType type, std::span<const From> from,
                        std::span<To> to) {
  const auto& order = node_order(codes, type);
  for (std::size_t k = 0; k < from.size(); ++k) to[order[k]] = static_cast<To>(from[k]);
}

/// The volume of a cone from `origin` over a face; positive when its normal points away from there.
/// A quad is taken as the mean of its two pairs of triangles: exact where it is flat, and the same,
/// with the other sign, from its other side. @pre three or four corners.
long double cone_volume(const Vec3& origin, std::span<const Vec3> face);

/// The sum of the cones over its faces, whose sign tells a turned element. Of a tet exactly what
/// signed_volume gives. @pre the type is a cell, and `nodes` has as many as it has.
long double element_volume(ElementType type, std::span<const Vec3> nodes);

/// The smallest determinant of the three edges at a corner over the product of their lengths, over
/// that of the regular element: 1 at best, 0 or less where it is flat or turned at a corner. A
/// corner with more than three edges, the apex of a pyramid, is not looked at.
/// Source: P. M. Knupp, "Algebraic mesh quality metrics" (2001), the scaled Jacobian.
/// @pre as element_volume.
double scaled_jacobian(ElementType type, std::span<const Vec3> nodes);

}  // namespace tetfarm
