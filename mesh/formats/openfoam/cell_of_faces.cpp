#include "mesh/formats/openfoam/cell_of_faces.h"

#include <algorithm>
#include <vector>

namespace tetfarm {
namespace {

using Face = FaceNodes<std::int32_t>;

/// How many of the faces have so many corners.
using CornerCounts = std::array<int, most_face_nodes + 1>;

CornerCounts corner_counts(std::span<const Face> faces) {
  CornerCounts counts{};
  for (const Face& face : faces) ++counts[face.size()];
  return counts;
}

CornerCounts corner_counts(const Element& shape) {
  CornerCounts counts{};
  for (const ElementFace& face : shape.faces) ++counts[nodes_of(face.type)];
  return counts;
}

/// The faces of a type being laid upon those of a polyhedron.
class Laying {
 public:
  Laying(ElementType type, std::span<const Face> faces)
      : shape_(element(type)), faces_(faces), is_taken_(faces.size(), false) {
    cell_.type = type;
    cell_.nodes.fill(-1);
  }

  /// Lays the first face of the type upon `face`, its first node upon the `corner`-th there, and
  /// then all others.
  std::optional<CellOfFaces> begin_with(std::size_t face, std::size_t corner) {
    if (!lay(shape_.faces[0], face, corner)) return std::nullopt;
    std::vector<bool> is_laid(shape_.faces.size(), false);
    is_laid[0] = true;
    for (std::size_t laid = 1; laid < is_laid.size(); ++laid) {
      std::size_t next = 0;
      while (next < is_laid.size() && (is_laid[next] || !known_edge(shape_.faces[next]))) ++next;
      if (next == is_laid.size() || !lay_by_edge(shape_.faces[next])) return std::nullopt;
      is_laid[next] = true;
    }
    return has_distinct_nodes() ? std::optional(cell_) : std::nullopt;
  }

 private:
  /// The first edge of the face both of whose ends are known.
  std::optional<std::size_t> known_edge(const ElementFace& face) const {
    const std::size_t corners = nodes_of(face.type);
    for (std::size_t k = 0; k < corners; ++k) {
      if (cell_.nodes[face.nodes[k]] >= 0 && cell_.nodes[face.nodes[(k + 1) % corners]] >= 0) {
        return k;
      }
    }
    return std::nullopt;
  }

  /// Upon the face of the polyhedron that has the same edge, turning the same way.
  bool lay_by_edge(const ElementFace& face) {
    const std::size_t corners = nodes_of(face.type);
    const std::size_t k = *known_edge(face);
    const std::int32_t from = cell_.nodes[face.nodes[k]];
    const std::int32_t to = cell_.nodes[face.nodes[(k + 1) % corners]];
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (is_taken_[f] || faces_[f].size() != corners) continue;
      for (std::size_t c = 0; c < corners; ++c) {
        if (faces_[f][c] == from && faces_[f][(c + 1) % corners] == to) {
          return lay(face, f, (c + corners - k) % corners);
        }
      }
    }
    return false;
  }

  /// False when a node is another one already.
  bool lay(const ElementFace& face, std::size_t upon, std::size_t corner) {
    const std::size_t corners = nodes_of(face.type);
    if (faces_[upon].size() != corners) return false;
    is_taken_[upon] = true;
    for (std::size_t k = 0; k < corners; ++k) {
      std::int32_t& node = cell_.nodes[face.nodes[k]];
      const std::int32_t there = faces_[upon][(corner + k) % corners];
      if (node >= 0 && node != there) return false;
      node = there;
    }
    return true;
  }

  bool has_distinct_nodes() const {
    std::vector<std::int32_t> nodes(cell_.all_nodes().begin(), cell_.all_nodes().end());
    std::sort(nodes.begin(), nodes.end());
    return std::adjacent_find(nodes.begin(), nodes.end()) == nodes.end();
  }

  const Element& shape_;
  std::span<const Face> faces_;
  std::vector<bool> is_taken_;
  CellOfFaces cell_;
};

}  // namespace

std::optional<CellOfFaces> cell_of_faces(std::span<const Face> faces) {
  const CornerCounts counts = corner_counts(faces);
  for (const ElementType type : all_element_types) {
    if (!is_cell(type) || corner_counts(element(type)) != counts) continue;
    for (std::size_t face = 0; face < faces.size(); ++face) {
      for (std::size_t corner = 0; corner < faces[face].size(); ++corner) {
        if (const auto cell = Laying(type, faces).begin_with(face, corner)) return cell;
      }
    }
  }
  return std::nullopt;
}

bool has_faces_of_a_cell(std::span<const Face> faces) {
  const CornerCounts counts = corner_counts(faces);
  return std::any_of(all_element_types.begin(), all_element_types.end(), [&](ElementType type) {
    return is_cell(type) && corner_counts(element(type)) == counts;
  });
}

std::string names_of_cells() {
  std::string names;
  std::string last;
  for (const ElementType type : all_element_types) {
    if (!is_cell(type)) continue;
    if (!last.empty()) names += (names.empty() ? "" : ", ") + last;
    last = element(type).name;
  }
  return names + " or " + last;
}

}  // namespace tetfarm
