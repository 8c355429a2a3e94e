/// Reads the polyMesh of an OpenFOAM case from the beginning to the end: nodes, faces of its
/// patches, then cells, each put together from its faces.
///
/// Source: OpenFOAM user guide, "Mesh files". A face turns out of its owner, so that the faces of a
/// cell tell its nodes and which way they turn; which of the nodes came first is not known.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/formats/external_sort.h"
#include "mesh/formats/openfoam/cell_of_faces.h"
#include "mesh/formats/openfoam/foam_files.h"
#include "mesh/formats/openfoam/foam_text.h"

namespace tetfarm {

struct PolyMeshFace {
  std::size_t patch = 0;
  FaceNodes<std::int32_t> nodes;  ///< the normal points out of the cell
};

struct PolyMeshCell {
  CellOfFaces cell;
  std::int32_t region = 1;  ///< its cell zone, from 1
};

/// In memory: 2^20 sides of cells, the runs of cells of one zone; on disk for the time 20 bytes for
/// each face of each cell. Cost: O(n log n).
class PolyMeshReader {
 public:
  /// Reads what is small: patches and zones. @throws IoError; InvalidInput with file and line, or
  /// the number of a cell that is no element of ours; as all that follows.
  PolyMeshReader(const std::filesystem::path& folder, const std::filesystem::path& scratch_folder);

  const std::vector<FoamPatch>& patches() const { return patches_; }
  /// Of zones 1, 2, …; empty when there are none.
  const std::vector<std::string>& region_names() const { return region_names_; }
  std::int64_t nodes() const { return nodes_; }

  /// First all nodes, then all faces of patches, then all cells; nothing after the last.
  std::optional<Vec3> next_node();
  std::optional<PolyMeshFace> next_face();
  std::optional<PolyMeshCell> next_cell();

 private:
  using Face = FaceNodes<std::int32_t>;

  /// A face of a cell, turned out of it.
  struct Side {
    std::int32_t cell = 0;
    Face nodes;
    bool operator<(const Side& other) const { return cell < other.cell; }
  };

  void check_patches();
  void read_zones(const std::filesystem::path& file);
  Face read_face();
  void read_inner_faces();
  std::int32_t region_of(std::int32_t cell);
  [[noreturn]] void refuse(std::int32_t cell, const std::string& what) const;
  CellOfFaces cell_of(std::int32_t cell, const std::vector<Side>& sides) const;

  std::string name_;
  std::vector<FoamPatch> patches_;
  std::vector<std::string> region_names_;
  std::vector<FoamZoneRun> zones_;
  std::size_t next_zone_ = 0;
  FoamText points_;
  FoamText faces_;
  FoamText owner_;
  FoamText neighbour_;
  std::int64_t nodes_ = 0;
  std::int64_t all_faces_ = 0;
  std::int64_t inner_faces_ = 0;
  std::int64_t next_node_ = 0;
  std::int64_t faces_read_ = 0;
  std::size_t next_patch_ = 0;
  std::int32_t owner_of_face_ = 0;
  std::int32_t cells_read_ = 0;
  ExternalSort<Side> sides_;
};

/// The file `boundary`. @throws IoError, InvalidInput.
std::vector<FoamPatch> read_foam_boundary(const std::filesystem::path& file);

}  // namespace tetfarm
