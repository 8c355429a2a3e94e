/// A VTKHDF file that several tasks write at once, each to the places of its sub-domain.
///
/// Whoever writes, writes the final bytes to their final places: a task that runs twice, or goes on
/// after it was given up, does no harm, be the file finished by then. And nobody is believed: who
/// finishes the file looks whether all that was written is there, and writes what is not.
#pragma once

#include <functional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "mesh/assemble/file_range.h"
#include "mesh/assemble/global_mesh.h"
#include "mesh/assemble/leaf_numbering.h"
#include "mesh/formats/vtkhdf/vtkhdf_frame.h"
#include "mesh/formats/vtkhdf/vtkhdf_rows.h"

namespace tetfarm {

/// The file, and where another may be made to find out how it is laid out.
struct SharedFile {
  std::filesystem::path path;
  std::filesystem::path scratch;
};

/// Writes the nodes and marks of the cells of a leaf, and returns where they are: nowhere of a leaf
/// whose offsets need more than 32 bits. The file is made when it is missing, and is not made
/// durable; without a path, it is only told where they would be. @pre `part` is whole and of
/// `numbering`, which knows its first face. @throws IoError. Cost: O(cells of the part).
std::vector<FileRange> place_cells(const SharedFile& file, const NumberedPart& part,
                                   const LeafNumbering& numbering, const VtkhdfNames& names);

/// Finishes the file. `add` takes a part with its cells, or without them when they are placed:
/// those are not written again.
class SharedVtkhdf : public GlobalMeshWriter {
 public:
  /// A part with its cells.
  using ReadWhole = std::function<NumberedPart(std::size_t part)>;

  /// @throws IoError
  SharedVtkhdf(SharedFile file, std::span<const VtkhdfCounts> parts, const VtkhdfNames& names,
               ReadWhole read_whole);

  /// Whether these are the places where the cells of that part belong: then they need not come, but
  /// are looked at in `finish`.
  bool takes(std::size_t part, std::span<const FileRange> cells);
  void add(const NumberedPart& part) override;
  /// Reads the file once; what is not as it was said to be is written again.
  void finish() override;
  /// Hash and size of the finished file. @pre finish was called.
  const ReadThrough& finished() const { return finished_; }

 private:
  void look_at_placed();

  std::filesystem::path path_;
  ReadWhole read_whole_;
  VtkhdfFrame frame_;
  OutputFile file_;
  std::vector<std::pair<FileRange, std::size_t>> placed_;  ///< with the part that they are of
  std::set<std::size_t> taken_;
  ReadThrough finished_;
};

}  // namespace tetfarm
