/// The elements of a mesh put together anew: laid down piece by piece on disk, each piece what one
/// sub-domain has of one part, and taken part by part.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "mesh/assemble/portion.h"
#include "mesh/formats/scratch_file.h"

namespace tetfarm {

class PartPieces {
 public:
  PartPieces(std::int32_t parts, const std::filesystem::path& folder)
      : file_(folder), pieces_(static_cast<std::size_t>(parts)) {}

  /// Cells are counted as in part_cells.h. A boundary face goes with the cell that it is a face of,
  /// and so do the marks of a cell, and the feet of its nodes.
  /// @throws IoError, InvalidInput.
  void add(const NumberedPart& subdomain, const std::vector<std::int32_t>& part_of_cell);

  std::size_t size() const { return pieces_.size(); }
  /// Nodes ascend by their numbers in the whole mesh; cells of a type are in the order of the
  /// sub-domains, by regions first. Marks that some of them have not are 0 there, and feet no_foot.
  /// @throws IoError.
  /// Cost: O(n log n).
  NumberedPart part(std::size_t i) const;

 private:
  using CountsOfMarks = std::array<std::size_t, all_cell_marks.size()>;
  struct Piece {
    std::int64_t place = 0;
    std::size_t nodes = 0;
    std::size_t tets = 0;
    std::size_t faces = 0;
    ByType<std::size_t> others;  ///< in blocks
    CountsOfMarks marks{};       ///< of each: of all cells, or of none
    std::size_t feet = 0;        ///< of all nodes, or of none
  };
  void lay_down(const NumberedPart& piece, std::size_t part);
  NumberedPart read(const Piece& piece) const;
  std::vector<std::int64_t> numbers_of(std::size_t i) const;

  ScratchFile file_;
  std::vector<std::vector<Piece>> pieces_;
};

}  // namespace tetfarm
