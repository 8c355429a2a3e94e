/// Reads the cells of one partition of a VTKHDF file, block after block: the arrays of a block fit
/// into the processor's caches, and the partition's numbers are never in memory twice.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/assemble/portion.h"
#include "mesh/core/element_block.h"
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

  /// Of each type how many there are.
  ElementCounts count();
  /// Of the boundary faces, of the counts that count() gave; 0 without that array.
  void read_patches(bool has_patches, const ElementCounts& counts, NumberedPart& part);
  /// Puts the nodes of the elements behind those that are there, with the nodes of the partition.
  void read_nodes(NumberedPart& part);

 private:
  template <class Visit>
  void for_each_block(const Visit& visit);
  std::int64_t tets_of_block(std::int64_t cells) const;
  bool has_blocks(std::int64_t cells) const;
  template <class Id>
  void read_nodes_as(const Hdf5Rows& id_rows, NumberedPart& part);
  template <class Id>
  void read_mixed_nodes(const Id* next, std::int64_t cells, NumberedPart& part) const;
  ElementType type_of_cell(std::uint8_t code) const;
  void check_offsets(const std::vector<std::int64_t>& offsets) const;
  template <class Id>
  void check_nodes(const std::vector<Id>& ids) const;

  const Hdf5Input& file_;
  const VtkhdfPartition& here_;
  Hdf5Rows type_rows_;
  std::vector<std::uint8_t> types_;  ///< of the block
};

}  // namespace tetfarm
