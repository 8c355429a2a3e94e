/// What a write task needs of the surface and the numbering of the whole job: read in part, at the
/// cost of its leaf, or whole where an earlier version wrote the files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/artifacts/surface_file.h"
#include "mesh/assemble/numbering_file.h"
#include "worker/task_io.h"

namespace tetfarm {

/// The surface of the job, in pieces. Damage is that of the task's input.
class SurfaceInput {
 public:
  /// Of the input "surface". @throws DamagedInput.
  explicit SurfaceInput(const TaskIo& io);

  /// As pieces_of. @throws DamagedInput; Error when there is no such piece.
  SurfacePieces pieces(const WantedPieces& wanted);
  const std::vector<std::string>& patch_names() const;
  const std::vector<std::string>& region_names() const;
  /// Adds the figures of the surface. @throws DamagedInput. Cost: O(n log n) for the whole surface.
  void add_figures(Numbering& numbering) const;

 private:
  const TaskIo& io_;
  std::optional<SurfaceFile> file_;
  std::optional<SurfaceMesh> whole_;  ///< where there are no blocks
};

/// The numbering of the job, as far as one leaf goes. Damage is that of the task's input.
class NumberingInput {
 public:
  /// Of the input "numbering". @throws DamagedInput.
  NumberingInput(const TaskIo& io, const SurfaceInput& surface);

  /// Of the whole surface.
  std::int32_t regions() const;
  /// As leaf_numbering. @throws DamagedInput; Error when there is no such leaf or node.
  LeafNumbering leaf(const LeafQuestion& question);

 private:
  const TaskIo& io_;
  std::optional<NumberingFile> file_;
  std::optional<Numbering> whole_;  ///< where there is a text alone
};

}  // namespace tetfarm
