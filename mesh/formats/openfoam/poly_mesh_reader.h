/// Reads the polyMesh of an OpenFOAM case from the beginning to the end: nodes, triangles of its
/// patches, then tets, each put together from its four faces.
///
/// Source: OpenFOAM user guide, "Mesh files". A face turns out of its owner, so that two faces of a
/// cell tell its four nodes and which way they turn; which of the four came first is not known.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/formats/external_sort.h"
#include "mesh/formats/openfoam/foam_files.h"
#include "mesh/formats/openfoam/foam_text.h"

namespace tetfarm {

struct PolyMeshTriangle {
  std::size_t patch = 0;
  std::array<std::int32_t, 3> nodes{};  ///< the normal points out of the cell
};

struct PolyMeshTet {
  std::array<std::int32_t, 4> nodes{};
  std::int32_t region = 1;  ///< its cell zone, from 1
};

/// In memory: 2^20 sides of cells, the runs of cells of one zone; on disk for the time 64 bytes a
/// tet. Cost: O(n log n).
class PolyMeshReader {
 public:
  /// Reads what is small: patches and zones. @throws IoError; InvalidInput with file and line, or
  /// the number of a cell that is no tet; as all that follows.
  PolyMeshReader(const std::filesystem::path& folder, const std::filesystem::path& scratch_folder);

  const std::vector<FoamPatch>& patches() const { return patches_; }
  /// Of zones 1, 2, …; empty when there are none.
  const std::vector<std::string>& region_names() const { return region_names_; }
  std::int64_t nodes() const { return nodes_; }

  /// First all nodes, then all triangles, then all tets; nothing after the last.
  std::optional<Vec3> next_node();
  std::optional<PolyMeshTriangle> next_triangle();
  std::optional<PolyMeshTet> next_tet();

 private:
  using Face = std::array<std::int32_t, 3>;

  /// A face of a cell, turned out of it.
  struct Side {
    std::int32_t cell = 0;
    Face nodes{};
    bool operator<(const Side& other) const { return cell < other.cell; }
  };

  void check_patches();
  void read_zones(const std::filesystem::path& file);
  Face read_face();
  void read_inner_faces();
  std::int32_t region_of(std::int32_t cell);
  [[noreturn]] void refuse(std::int32_t cell, const std::string& what) const;
  std::array<std::int32_t, 4> tet_of(std::int32_t cell, const std::vector<Side>& sides) const;

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
  std::int64_t next_face_ = 0;
  std::size_t next_patch_ = 0;
  std::int32_t owner_of_face_ = 0;
  std::int32_t next_cell_ = 0;
  ExternalSort<Side> sides_;
};

/// The file `boundary`. @throws IoError, InvalidInput.
std::vector<FoamPatch> read_foam_boundary(const std::filesystem::path& file);

}  // namespace tetfarm
