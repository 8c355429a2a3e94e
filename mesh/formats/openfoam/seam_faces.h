/// The faces that two parts share, each found from both sides, in the same order on both.
///
/// They are on cuts, or are triangles between two regions. Whole lists are sorted on disk: memory
/// is that of one part.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "mesh/formats/cell_faces.h"
#include "mesh/formats/external_sort.h"
#include "mesh/formats/mesh_source.h"

namespace tetfarm {

/// A face of `part` that `neighbour` has too.
struct SeamFace {
  std::int32_t part = 0;
  std::int32_t neighbour = 0;
  std::array<std::int64_t, 3> sorted_nodes{};  ///< numbers in the whole mesh, ascending
  std::array<std::int64_t, 3> nodes{};         ///< the lowest first, the normal out of the part
  std::int64_t tet = 0;                        ///< in the whole mesh, of this part
  std::int64_t neighbour_tet = 0;              ///< in the whole mesh
  std::int32_t face = -1;                      ///< of this part's faces; -1: on a cut

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
  /// Boundary triangles that two regions share: they count twice.
  std::int64_t between_regions() const { return between_regions_; }
  /// Of each part and patch, the triangles that no other region has.
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
