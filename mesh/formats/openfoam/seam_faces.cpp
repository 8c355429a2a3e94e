#include "mesh/formats/openfoam/seam_faces.h"

#include <algorithm>

#include "base/error.h"
#include "mesh/assemble/part_cells.h"
#include "mesh/formats/node_records.h"

namespace tetfarm {
namespace {

/// An outer face of a part, found by its nodes.
struct OpenFace {
  FaceNodes<std::int64_t> sorted_nodes;
  FaceNodes<std::int64_t> nodes;
  std::int32_t part = 0;
  std::int32_t face = -1;
  std::int32_t patch = -1;
  std::int64_t cell = 0;

  bool operator<(const OpenFace& other) const {
    return sorted_nodes != other.sorted_nodes ? sorted_nodes < other.sorted_nodes
                                              : part < other.part;
  }
};

OpenFace open_face(const NumberedPart& part, const OuterFace& outer,
                   const std::vector<std::int32_t>& patches, std::int64_t first_cell) {
  OpenFace open;
  open.nodes =
      outer.nodes.renumbered([&](std::int32_t v) { return global_node(part, v); }).smallest_first();
  open.sorted_nodes = open.nodes.sorted();
  open.part = part.number;
  open.face = outer.face;
  if (outer.face >= 0) open.patch = patches[static_cast<std::size_t>(outer.face)];
  open.cell = first_cell + outer.owner;
  return open;
}

SeamFace seam_face(const OpenFace& here, const OpenFace& there) {
  return {here.part, there.part, here.sorted_nodes, here.nodes, here.cell, there.cell, here.face};
}

}  // namespace

SeamFaces::SeamFaces(const MeshSource& source, const MeshOutline& outline,
                     const std::filesystem::path& folder)
    : seams_(folder) {
  match(outline, folder, source);
}

void SeamFaces::match(const MeshOutline& outline, const std::filesystem::path& folder,
                      const MeshSource& source) {
  ExternalSort<OpenFace> open(folder);
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    const std::vector<std::int32_t> patches = patches_of_boundary(part);
    for (const OuterFace& outer : cell_faces(part).outer) {
      open.push(open_face(part, outer, patches, outline.parts[i].first_cell));
    }
  }
  faces_of_patch_.assign(outline.parts.size(),
                         std::vector<std::int64_t>(outline.patch_names.size()));
  OpenFace first;
  bool has_first = open.next(first);
  while (has_first) {
    OpenFace second;
    const bool has_second = open.next(second);
    if (has_second && second.sorted_nodes == first.sorted_nodes) {
      if (second.part == first.part)
        throw InvalidInput("a face occurs twice in one sub-domain", "");
      seams_.push(seam_face(first, second));
      seams_.push(seam_face(second, first));
      between_regions_ += (first.face >= 0 ? 1 : 0) + (second.face >= 0 ? 1 : 0);
      has_first = open.next(first);
      continue;
    }
    if (first.face < 0) {
      throw InvalidInput("a face of sub-domain " + std::to_string(first.part) +
                             " is neither on the boundary nor in another sub-domain",
                         "");
    }
    ++faces_of_patch_[static_cast<std::size_t>(first.part)][static_cast<std::size_t>(first.patch)];
    first = second;
    has_first = has_second;
  }
}

std::vector<SeamFace> SeamFaces::next_part() {
  const std::int32_t part = next_++;
  return seams_.take_while([part](const SeamFace& seam) { return seam.part == part; });
}

}  // namespace tetfarm
