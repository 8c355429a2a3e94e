#include "mesh/formats/cell_faces.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"
#include "mesh/core/sorted_face.h"

namespace tetfarm {
namespace {

/// A face of a tet, found by its nodes in ascending order.
struct TetFace {
  Triangle sorted;
  std::int32_t tet = 0;
  Triangle nodes;
};

/// All faces of all tets, by their nodes.
std::vector<TetFace> faces_by_nodes(const NumberedPart& part) {
  std::vector<TetFace> faces;
  faces.reserve(part.tets.size() * 4);
  for (std::size_t t = 0; t < part.tets.size(); ++t) {
    for (const auto& corners : tet_face_nodes) {
      TetFace face;
      for (std::size_t k = 0; k < 3; ++k) {
        face.nodes[k] = part.tets[t][static_cast<std::size_t>(corners[k])];
      }
      face.sorted = sorted_face(face.nodes);
      face.tet = static_cast<std::int32_t>(t);
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end(), [](const TetFace& a, const TetFace& b) {
    return a.sorted != b.sorted ? a.sorted < b.sorted : a.tet < b.tet;
  });
  return faces;
}

/// The boundary triangles of a part, found by their nodes.
class BoundaryFaces {
 public:
  explicit BoundaryFaces(const NumberedPart& part) {
    for (std::size_t i = 0; i < part.faces.size(); ++i) {
      faces_.emplace_back(sorted_face(part.faces[i]), static_cast<std::int32_t>(i));
    }
    std::sort(faces_.begin(), faces_.end());
  }
  std::size_t size() const { return faces_.size(); }
  std::size_t count(const Triangle& sorted) const {
    const auto first =
        std::lower_bound(faces_.begin(), faces_.end(), std::pair(sorted, std::int32_t{0}));
    return static_cast<std::size_t>(
        std::find_if(first, faces_.end(), [&](const auto& face) { return face.first != sorted; }) -
        first);
  }
  /// -1 when there is none.
  std::int32_t find(const Triangle& sorted) const {
    const auto found =
        std::lower_bound(faces_.begin(), faces_.end(), std::pair(sorted, std::int32_t{0}));
    return found != faces_.end() && found->first == sorted ? found->second : -1;
  }

 private:
  std::vector<std::pair<Triangle, std::int32_t>> faces_;
};

}  // namespace

CellFaces cell_faces(const NumberedPart& part) {
  const std::string where = "sub-domain " + std::to_string(part.number);
  const std::vector<TetFace> faces = faces_by_nodes(part);
  const BoundaryFaces boundary(part);
  CellFaces result;
  std::size_t on_boundary = 0;
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t end = i + 1;
    while (end < faces.size() && faces[end].sorted == faces[i].sorted) ++end;
    if (end - i > 2) throw InvalidInput("a face has more than two tets", where);
    if (end - i == 2) {
      result.inner.push_back({faces[i].tet, faces[i + 1].tet, faces[i].nodes});
      // A triangle between two regions; a single one is no boundary.
      if (boundary.count(faces[i].sorted) == 2) on_boundary += 2;
    } else {
      const std::int32_t face = boundary.find(faces[i].sorted);
      on_boundary += face >= 0 ? 1 : 0;
      result.outer.push_back({faces[i].tet, face, faces[i].nodes});
    }
    i = end;
  }
  TF_CHECK(2 * result.inner.size() + result.outer.size() == 4 * part.tets.size());
  if (on_boundary != boundary.size()) {
    throw InvalidInput("a boundary triangle is not an outer face of a tet", where);
  }
  std::sort(result.inner.begin(), result.inner.end(), [](const InnerFace& a, const InnerFace& b) {
    return std::pair(a.owner, a.neighbour) < std::pair(b.owner, b.neighbour);
  });
  std::stable_sort(result.outer.begin(), result.outer.end(),
                   [](const OuterFace& a, const OuterFace& b) { return a.owner < b.owner; });
  return result;
}

}  // namespace tetfarm
