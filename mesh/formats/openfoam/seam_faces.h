/// The faces that two parts share, each found from both sides, in the same order on both.
///
/// They are on cuts, or lie between two regions. Whole lists are sorted on disk: memory
/// is that of one part.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "mesh/formats/cell_faces.h"
#include "mesh/formats/external_sort.h"
#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// A face of `part` that `neighbour` has too. Cells and boundary faces are counted as in
/// part_cells.h, cells part after part.
struct SeamFace {
  std::int32_t part = 0;
  std::int32_t neighbour = 0;
  FaceNodes<std::int64_t> sorted_nodes;  ///< numbers in the whole mesh, ascending
  FaceNodes<std::int64_t> nodes;         ///< the lowest first, the normal out of the part
  std::int64_t cell = 0;                 ///< in the whole mesh, of this part
  std::int64_t neighbour_cell = 0;       ///< in the whole mesh
  std::int32_t face = -1;                ///< of this part's boundary faces; -1: on a cut

  bool operator<(const SeamFace& other) const {
    if (part != other.part) return part < other.part;
    if (neighbour != other.neighbour) return neighbour < other.neighbour;
    return sorted_nodes < other.sorted_nodes;
  }
};

class SeamFaces {
 public:
  /// Reads every part once. `folder` is for files that are gone afterwards.
  /// @throws InvalidInput when a face is neither shared nor on the boundary; IoError.
  SeamFaces(const MeshSource& source, const MeshOutline& outline,
            const std::filesystem::path& folder);

  /// Those of part 0, then of part 1, …: by neighbour, then nodes.
  std::vector<SeamFace> next_part();
  /// Boundary faces that two regions share: they count twice.
  std::int64_t between_regions() const { return between_regions_; }
  /// Of each part and patch, the boundary faces that no other region has.
  const std::vector<std::vector<std::int64_t>>& faces_of_patch() const { return faces_of_patch_; }

 private:
  void match(const MeshOutline& outline, const std::filesystem::path& folder,
             const MeshSource& source);

  ExternalSort<SeamFace> seams_;
  std::int32_t next_ = 0;
  std::int64_t between_regions_ = 0;
  std::vector<std::vector<std::int64_t>> faces_of_patch_;
};

}  // namespace tetfarm
