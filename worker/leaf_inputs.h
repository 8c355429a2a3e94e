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
  /// @throws DamagedInput.
  SurfaceInput(const TaskIo& io, TaskFile surface);

  /// As pieces_of. @throws DamagedInput; Error when there is no such piece.
  SurfacePieces pieces(const WantedPieces& wanted);
  const std::vector<std::string>& patch_names() const;
  const std::vector<std::string>& region_names() const;
  /// Adds the figures of the surface. @throws DamagedInput. Cost: O(n log n) for the whole surface.
  void add_figures(Numbering& numbering) const;

 private:
  const TaskIo& io_;
  TaskFile input_;
  std::optional<SurfaceFile> file_;
  std::optional<SurfaceMesh> whole_;  ///< where there are no blocks
};

/// The numbering of the job, as far as one leaf goes. Damage is that of the task's input.
class NumberingInput {
 public:
  /// `surface` is that of the same job. @throws DamagedInput.
  NumberingInput(const TaskIo& io, TaskFile numbering, const SurfaceInput& surface);

  /// Of the whole surface.
  std::int32_t regions() const;
  /// As leaf_numbering. @throws DamagedInput; Error when there is no such leaf or node.
  LeafNumbering leaf(const LeafQuestion& question);

 private:
  const TaskIo& io_;
  TaskFile input_;
  std::optional<NumberingFile> file_;
  std::optional<Numbering> whole_;  ///< where there is a text alone
};

}  // namespace tetfarm
