/// A VTKHDF file with room for everything that is large, and where in it that comes.
///
/// The nodes of cells and their marks, and all of points, lie in one piece each, to be written by
/// whoever has them; what little the other arrays of cells say is packed (packed_cells.h). The
/// first come before the points, so their places depend on the numbers of partitions, cells and
/// their nodes alone: they are known before all points are counted.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mesh/assemble/output_file.h"
#include "mesh/assemble/portion.h"
#include "mesh/core/patch_type.h"
#include "mesh/formats/hdf5/hdf5_file.h"
#include "mesh/formats/vtkhdf/packed_cells.h"
#include "mesh/formats/vtkhdf/vtkhdf_counts.h"

namespace tetfarm {

/// Where the arrays of NodeFeet begin.
struct VtkhdfFeetPlaces {
  std::int64_t foot = 0;
  std::int64_t depth = 0;
};

/// Where the arrays begin that lie in one piece, bytes. Numbers of nodes and offsets have 32 bits
/// where every partition's fit, else 64: VTK 9.1 asks both to be alike.
struct VtkhdfPlaces {
  std::int64_t id_size = 4;
  std::int64_t connectivity = 0;
  std::vector<std::pair<CellMark, std::int64_t>> marks;
  std::int64_t points = 0;
  std::int64_t node_numbers = 0;
  std::optional<VtkhdfFeetPlaces> feet;
};

/// A partition's piece of an array, bytes in the file.
struct VtkhdfPlace {
  std::int64_t offset = 0;
  std::int64_t size = 0;
};

/// Its pieces of the arrays of cells.
struct VtkhdfCellPlaces {
  VtkhdfPlace connectivity;
  std::vector<VtkhdfPlace> marks;  ///< in the order of the file's

  /// As they follow one another in the file.
  std::vector<VtkhdfPlace> in_order() const;
};

/// Of a partition that has `counts` and comes behind `before`; its points do not count.
VtkhdfCellPlaces cell_places(const VtkhdfPlaces& places, const VtkhdfBefore& before,
                             const VtkhdfCounts& counts);

/// Whether its numbers of nodes and offsets fit into 32 bits.
bool has_narrow_ids(const VtkhdfCounts& part);

/// What a file has once.
struct VtkhdfNames {
  std::vector<std::string> patches;
  std::vector<std::string> regions = {};  ///< none: one region
  std::vector<CellMark> marks = {};   ///< arrays of these; of a part that does not know them, zeros
  bool has_feet = false;              ///< arrays of NodeFeet; of a part without them, no_foot
  std::vector<PatchType> types = {};  ///< of the patches; nothing of them when all are unspecified
};

/// The file but for the content of the arrays in one piece, in a file of its own. That has room for
/// them as well, which takes no place on the disk.
class VtkhdfFrame {
 public:
  /// Truncates `scratch`. @throws IoError, also later.
  VtkhdfFrame(std::filesystem::path scratch, std::span<const VtkhdfCounts> parts,
              const VtkhdfNames& names);
  ~VtkhdfFrame();
  VtkhdfFrame(const VtkhdfFrame&) = delete;
  VtkhdfFrame& operator=(const VtkhdfFrame&) = delete;

  const VtkhdfPlaces& places() const { return places_; }
  const VtkhdfCounts& counts(std::size_t part) const { return parts_.at(part); }
  const VtkhdfBefore& before(std::size_t part) const { return before_.at(part); }
  /// The rows that a part has of the packed arrays. Its cells need not have come with it.
  /// @pre parts come in the order of their numbers; some may be left out.
  void add(const NumberedPart& part);
  /// Copies everything to its place in `file`, the signature last: without it, it is no HDF5 file.
  /// The scratch file goes. @pre called once, when all parts were added.
  void finish(OutputFile& file);

 private:
  /// Where the arrays in one piece lie.
  std::vector<VtkhdfPlace> rooms() const;

  std::filesystem::path scratch_;
  std::vector<VtkhdfCounts> parts_;
  std::vector<VtkhdfBefore> before_;
  VtkhdfPlaces places_;
  Hdf5Output file_;
  std::unique_ptr<PackedCells> packed_;
};

/// The places that the arrays of cells have in the frame of `partitions` parts which have `all` of
/// the cells together, whose they may be, with narrow ids; those of points are not told. A file
/// `scratch` comes and goes. @throws IoError. Cost: O(names), whatever the number of partitions.
VtkhdfPlaces places_of_cells(const std::filesystem::path& scratch, std::int64_t partitions,
                             const VtkhdfCounts& all, const VtkhdfNames& names);

}  // namespace tetfarm
