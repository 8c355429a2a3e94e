/// A finished mesh in as many parts of even size as a solver has processes, whatever the
/// sub-domains that it was meshed in.
///
/// Columns of prisms (cell_columns.h) stay whole, if asked for.
///
/// Source: thesis 4.3.2.1 (METIS) and 4.3.4.2.1 (what solvers need), joined; there the sub-domains
/// are the parts. The whole mesh is never in memory: the cells of each sub-domain are joined in
/// pairs to clusters, METIS divides the graph of all clusters, and clusters and cells near the
/// borders between parts move one by one, sub-domain after sub-domain.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "mesh/formats/mesh_source.h"
#include "mesh/partition/part_pieces.h"

namespace tetfarm {

struct PartitionOptions {
  std::int32_t parts = 1;
  /// In memory at once: as many as there are cells, or these. 64 for each part if that is more.
  std::int64_t clusters = std::int64_t{1} << 19;
  bool keeps_columns = true;  ///< prisms that stand on one another are in one part
};

struct PartitionFigures {
  std::vector<std::int64_t> cells;  ///< of each part, of any type
  std::int64_t cut_faces = 0;       ///< between cells of two parts
  double largest_over_mean() const;
};

/// The parts 0, 1, …: each of one piece, joined by faces, in each piece of the mesh that it has a
/// share of; nodes have the numbers and feet, and cells the marks, that they have in `source`.
class PartitionedMesh : public MeshSource {
 public:
  /// Reads each sub-domain twice; `source` need not live longer. `folder` is for files that are
  /// gone afterwards, about 30 bytes a tet, 8 more for each node of another cell, 4 for each mark,
  /// 12 for the foot of a node.
  /// The same mesh gives the same parts.
  /// @throws UsageError when there are fewer cells, or columns, than parts; InvalidInput, IoError.
  /// Cost: some microseconds a cell. Memory: one sub-domain, the clusters and their neighbours (20
  /// bytes each of about 12), 16 bytes for each face between sub-domains. `part` takes that of a
  /// part.
  PartitionedMesh(const MeshSource& source, const PartitionOptions& options,
                  const std::filesystem::path& folder);

  std::size_t size() const override { return pieces_.size(); }
  NumberedPart part(std::size_t i) const override { return pieces_.part(i); }
  bool takes_threads() const override { return true; }
  std::vector<CellMark> cell_marks() const override { return cell_marks_; }
  bool has_feet() const override { return has_feet_; }
  std::vector<std::string> patch_names() const override { return patch_names_; }
  std::vector<PatchType> patch_types() const override { return patch_types_; }
  std::vector<std::string> region_names() const override { return region_names_; }
  const PartitionFigures& figures() const { return figures_; }

 private:
  PartPieces pieces_;
  PartitionFigures figures_;
  std::vector<CellMark> cell_marks_;
  bool has_feet_ = false;
  std::vector<std::string> patch_names_;
  std::vector<PatchType> patch_types_;
  std::vector<std::string> region_names_;
};

}  // namespace tetfarm
