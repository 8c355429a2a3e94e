/// Walks over an SU2 mesh, a text of keywords and lists, and hands on what is in it, in the order
/// of the file: what the readers of surfaces and of meshes have in common.
///
/// Source: SU2 documentation, "Mesh file". Elements have the type numbers of VTK, and nodes count
/// from 0. What follows the nodes in a line is passed over, and so are keywords that say nothing
/// of the mesh itself.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "mesh/core/elements.h"
#include "mesh/core/vec3.h"
#include "mesh/formats/input_scanner.h"

namespace tetfarm {

inline constexpr std::int64_t su2_line = 3;
inline constexpr std::int64_t su2_triangle = code_of(ElementCodes::vtk, ElementType::triangle);
inline constexpr std::int64_t su2_quad = code_of(ElementCodes::vtk, ElementType::quad);

/// Where an element stands: in the list of all (NELEM) or in that of a marker.
enum class Su2List { elements, marker };

/// Receives the content. Nodes may come after the elements that have them.
class Su2Content {
 public:
  virtual ~Su2Content() = default;
  virtual void add_node(const Vec3& p) = 0;
  /// The elements of this marker come next.
  virtual void begin_marker(std::string_view name) = 0;
  /// Whether an element of that type is to be handed on. One that cannot be taken fails in the
  /// scanner, which is behind the type.
  virtual bool wants(Su2List list, std::int64_t type, const InputScanner& in) = 0;
  virtual void add_element(Su2List list, std::int64_t type,
                           std::span<const std::int64_t> nodes) = 0;
};

/// Walks to the end of a file whose mesh has the dimension, 2 or 3; in the plane nodes have z = 0.
/// @throws InvalidInput with the line; what the content throws. Cost: O(bytes).
void walk_su2(InputScanner& in, Su2Content& content, int dimension = 3);

}  // namespace tetfarm
