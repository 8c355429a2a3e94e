/// A VTKHDF file with room for everything that is large, and where in it that comes.
///
/// Arrays of cells come before arrays of points, so the places of the first depend on the numbers
/// of partitions, cells and their nodes alone: they are known before all points are counted.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mesh/assemble/portion.h"

namespace tetfarm {

/// What a partition has. Its cells lie in the arrays as tets, pyramids, prisms, hexes, then
/// triangles and quads of the boundary.
struct VtkhdfCounts {
  std::int64_t points = 0;
  std::int64_t tets = 0;
  std::int64_t faces = 0;
  ElementCounts others{};  ///< of the types in blocks

  friend bool operator==(const VtkhdfCounts&, const VtkhdfCounts&) = default;
};
VtkhdfCounts vtkhdf_counts(const NumberedPart& part);

/// Where the arrays of NodeFeet begin.
struct VtkhdfFeetPlaces {
  std::int64_t foot = 0;
  std::int64_t depth = 0;
};

/// Where the arrays begin in the file, bytes.
struct VtkhdfPlaces {
  std::int64_t connectivity = 0;
  std::int64_t offsets = 0;
  std::int64_t types = 0;
  std::int64_t subdomains = 0;
  std::int64_t regions = 0;
  std::int64_t patches = 0;
  std::vector<std::pair<CellMark, std::int64_t>> marks;
  std::int64_t points = 0;
  std::int64_t node_numbers = 0;
  std::optional<VtkhdfFeetPlaces> feet;
};

/// How much of the arrays comes before a partition.
struct VtkhdfBefore {
  std::int64_t points = 0;
  std::int64_t cells = 0;
  std::int64_t ids = 0;
};

/// For each partition, and behind the last.
std::vector<VtkhdfBefore> before_each(std::span<const VtkhdfCounts> parts);

/// A partition's piece of an array, bytes in the file.
struct VtkhdfPlace {
  std::int64_t offset = 0;
  std::int64_t size = 0;
};

/// Its pieces of the arrays of cells.
struct VtkhdfCellPlaces {
  VtkhdfPlace connectivity;
  VtkhdfPlace offsets;
  VtkhdfPlace types;
  VtkhdfPlace subdomains;
  VtkhdfPlace regions;
  VtkhdfPlace patches;
  std::vector<VtkhdfPlace> marks;  ///< in the order of the file's

  /// As they follow one another in the file.
  std::vector<VtkhdfPlace> in_order() const;
};

/// Of partition `number`, which has `counts` and comes behind `before`; its points do not count.
VtkhdfCellPlaces cell_places(const VtkhdfPlaces& places, std::int64_t number,
                             const VtkhdfBefore& before, const VtkhdfCounts& counts);

/// What a file has once.
struct VtkhdfNames {
  std::vector<std::string> patches;
  std::vector<std::string> regions = {};  ///< none: one region
  std::vector<CellMark> marks = {};  ///< arrays of these; of a part that does not know them, zeros
  bool has_feet = false;             ///< arrays of NodeFeet; of a part without them, no_foot
};

/// Truncates `path`. The file is complete but for the content of the large arrays, which is zero.
/// @throws IoError
VtkhdfPlaces write_vtkhdf_frame(const std::filesystem::path& path,
                                std::span<const VtkhdfCounts> parts, const VtkhdfNames& names);

/// The places that the arrays of cells have in the frame of `partitions` parts which have `all` of
/// the cells together, whose they may be; those of points are not told. A file `scratch` comes and
/// goes. @throws IoError. Cost: O(names), whatever the number of partitions.
VtkhdfPlaces places_of_cells(const std::filesystem::path& scratch, std::int64_t partitions,
                             const VtkhdfCounts& all, const VtkhdfNames& names);

}  // namespace tetfarm
