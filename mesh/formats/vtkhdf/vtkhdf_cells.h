/// Reads the cells of one partition of a VTKHDF file, block after block: the arrays of a block fit
/// into the processor's caches, and the partition's numbers of 64 bits are never all in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/elements.h"
#include "mesh/core/tet_mesh.h"
#include "mesh/formats/hdf5/hdf5_file.h"

namespace tetfarm {

inline constexpr std::uint8_t vtkhdf_triangle_type =
    code_of(ElementCodes::vtk, ElementType::triangle);
inline constexpr std::uint8_t vtkhdf_tet_type = code_of(ElementCodes::vtk, ElementType::tet);
inline constexpr std::int64_t vtkhdf_cells_of_block = 16384;

/// Where a partition begins in the arrays, and how much it has.
struct VtkhdfPartition {
  std::int64_t first_point = 0;
  std::int64_t points = 0;
  std::int64_t first_cell = 0;
  std::int64_t cells = 0;
  std::int64_t first_id = 0;
  std::int64_t ids = 0;
  std::int64_t number = 0;
};

/// All that follows throws InvalidInput.
class VtkhdfCells {
 public:
  /// `file` and `here` must live longer.
  VtkhdfCells(const Hdf5Input& file, const VtkhdfPartition& here);

  std::int64_t count_tets();
  /// Of each of the `faces` triangles; 0 without that array.
  std::vector<std::int32_t> patches(bool has_patches, std::int64_t faces);
  /// Puts the elements behind those that are there, with the nodes of the partition.
  void read_nodes(std::vector<Tet>& tets, std::vector<Triangle>& faces);

 private:
  template <class Visit>
  void for_each_block(const Visit& visit);
  std::int64_t tets_of_block(std::int64_t cells) const;
  void check_offsets(const std::vector<std::int64_t>& offsets) const;
  void check_nodes(const std::vector<std::int64_t>& ids) const;

  const Hdf5Input& file_;
  const VtkhdfPartition& here_;
  Hdf5Rows type_rows_;
  std::vector<std::uint8_t> types_;  ///< of the block
};

}  // namespace tetfarm
