#include "mesh/formats/cell_faces.h"

#include <algorithm>

#include "base/check.h"
#include "base/error.h"
#include "mesh/assemble/part_cells.h"

namespace tetfarm {
namespace {

using Face = FaceNodes<std::int32_t>;

/// A face of a cell, found by its nodes in ascending order.
struct FaceOfCell {
  Face sorted;
  std::int32_t cell = 0;
  Face nodes;
};

/// All faces of all cells, by their nodes.
std::vector<FaceOfCell> faces_by_nodes(const NumberedPart& part) {
  std::vector<FaceOfCell> faces;
  faces.reserve(part.tets.size() * 4);
  for_each_face_of_cells(part, [&](std::int32_t cell, const Face& face) {
    faces.push_back({face.sorted(), cell, face});
  });
  std::sort(faces.begin(), faces.end(), [](const FaceOfCell& a, const FaceOfCell& b) {
    return a.sorted != b.sorted ? a.sorted < b.sorted : a.cell < b.cell;
  });
  return faces;
}

/// The boundary faces of a part, found by their nodes.
class BoundaryFaces {
 public:
  explicit BoundaryFaces(const NumberedPart& part) {
    for_each_boundary_face(part, [&](std::int32_t number, const Face& face, std::int32_t) {
      faces_.emplace_back(face.sorted(), number);
    });
    std::sort(faces_.begin(), faces_.end());
  }
  std::size_t size() const { return faces_.size(); }
  std::size_t count(const Face& sorted) const {
    const auto first =
        std::lower_bound(faces_.begin(), faces_.end(), std::pair(sorted, std::int32_t{0}));
    return static_cast<std::size_t>(
        std::find_if(first, faces_.end(), [&](const auto& face) { return face.first != sorted; }) -
        first);
  }
  /// -1 when there is none.
  std::int32_t find(const Face& sorted) const {
    const auto found =
        std::lower_bound(faces_.begin(), faces_.end(), std::pair(sorted, std::int32_t{0}));
    return found != faces_.end() && found->first == sorted ? found->second : -1;
  }

 private:
  std::vector<std::pair<Face, std::int32_t>> faces_;
};

}  // namespace

CellFaces cell_faces(const NumberedPart& part) {
  const std::string where = "sub-domain " + std::to_string(part.number);
  const std::vector<FaceOfCell> faces = faces_by_nodes(part);
  const BoundaryFaces boundary(part);
  CellFaces result;
  std::size_t on_boundary = 0;
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t end = i + 1;
    while (end < faces.size() && faces[end].sorted == faces[i].sorted) ++end;
    if (end - i > 2) throw InvalidInput("a face has more than two cells", where);
    if (end - i == 2) {
      result.inner.push_back({faces[i].cell, faces[i + 1].cell, faces[i].nodes});
      // A face between two regions; a single one is no boundary.
      if (boundary.count(faces[i].sorted) == 2) on_boundary += 2;
    } else {
      const std::int32_t face = boundary.find(faces[i].sorted);
      on_boundary += face >= 0 ? 1 : 0;
      result.outer.push_back({faces[i].cell, face, faces[i].nodes});
    }
    i = end;
  }
  TF_CHECK(2 * result.inner.size() + result.outer.size() == faces.size());
  if (on_boundary != boundary.size()) {
    throw InvalidInput("a boundary face is not an outer face of a cell", where);
  }
  std::sort(result.inner.begin(), result.inner.end(), [](const InnerFace& a, const InnerFace& b) {
    return std::pair(a.owner, a.neighbour) < std::pair(b.owner, b.neighbour);
  });
  std::stable_sort(result.outer.begin(), result.outer.end(),
                   [](const OuterFace& a, const OuterFace& b) { return a.owner < b.owner; });
  return result;
}

}  // namespace tetfarm
