/// Reads a VTKHDF file that write_vtkhdf wrote, or another one of tets and triangles.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mesh/assemble/global_mesh.h"
#include "mesh/assemble/mesh_in_memory.h"
#include "mesh/core/patch_type.h"

namespace tetfarm {

/// Any partition at any time: memory of one. Without GlobalNodeId, numbers are those of the
/// partition; without the cell array `region` all is region 1; without `patch` all boundary
/// triangles are of patch 0.
class VtkhdfParts {
 public:
  /// @throws IoError, InvalidInput.
  explicit VtkhdfParts(const std::filesystem::path& path);
  ~VtkhdfParts();

  std::size_t size() const;
  /// @throws InvalidInput.
  NumberedPart part(std::size_t i) const;
  /// The same without the nodes of elements, which are most of it.
  CountedPart count(std::size_t i) const;
  /// Without them only a single partition is a mesh.
  bool has_node_numbers() const;
  /// Of the patches and of regions 1, 2, …; empty when the file has none.
  std::vector<std::string> patch_names() const;
  std::vector<std::string> region_names() const;
  std::vector<PatchType> patch_types() const;
  /// Which marks the cells have; other programs' files have none.
  const std::vector<CellMark>& cell_marks() const;
  /// Whether the nodes have feet; those of other programs' files have none.
  bool has_feet() const;
  [[noreturn]] void fail(const std::string& what) const;

 private:
  struct Content;
  std::unique_ptr<const Content> content_;
};

/// Partitions are joined by the point array GlobalNodeId; without it there must be one partition.
/// @throws IoError, InvalidInput.
GlobalMesh read_vtkhdf(const std::filesystem::path& path);

}  // namespace tetfarm
