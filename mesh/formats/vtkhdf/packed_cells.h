/// The arrays of cells of a VTKHDF file that say nearly the same of each cell of a partition: where
/// its nodes begin, its type, sub-domain, region and patch.
///
/// They take 17 bytes a cell as they are, and about 0.1 packed (mesh/formats/hdf5/packed_rows.h).
#pragma once

#include <cstdint>
#include <variant>

#include "mesh/formats/hdf5/packed_rows.h"
#include "mesh/formats/vtkhdf/vtkhdf_counts.h"

namespace tetfarm {

class PackedCells {
 public:
  /// Makes the arrays for `all` that `partitions` have, with offsets of `id_size` bytes.
  /// @throws IoError, also later. `file` must live longer.
  PackedCells(Hdf5Output& file, std::int64_t partitions, const VtkhdfBefore& all,
              std::int64_t id_size);

  /// The rows of a part, which has `counts` and comes behind `before`. Its cells need not have come
  /// with it: then all are of its region. @pre the part's number is above the last one's.
  void add(const NumberedPart& part, const VtkhdfCounts& counts, const VtkhdfBefore& before);
  void finish();

 private:
  using Offsets = std::variant<PackedRows<std::int32_t>, PackedRows<std::int64_t>>;
  static Offsets offsets_in(Hdf5Output& file, std::int64_t rows, std::int64_t id_size);

  void add_regions(const NumberedPart& part, const VtkhdfCounts& counts);
  void add_patches(const NumberedPart& part, const VtkhdfCounts& counts);

  Offsets offsets_;
  PackedRows<std::uint8_t> types_;
  PackedRows<std::int32_t> subdomains_;
  PackedRows<std::int32_t> regions_;
  PackedRows<std::int32_t> patches_;
};

}  // namespace tetfarm
