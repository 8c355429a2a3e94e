/// Writes the global mesh as AFLR3/NASA UGRID, doubles, in either order of bytes and with integers
/// of 32 or 64 bits (.lb8.ugrid, .b8.ugrid, .lb8l.ugrid, .b8l.ugrid), and the names of its patches
/// (.mapbc).
///
/// Source: UG_IO documentation, "UGRID file type". Nodes and patches are numbered from 1; the
/// normals of boundary triangles point into the domain.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mesh/assemble/global_mesh.h"
#include "mesh/core/element_block.h"

namespace tetfarm {

struct UgridLayout {
  bool big_endian = false;
  bool wide = false;  ///< integers of 64 bits
};

struct UgridCounts {
  std::int64_t nodes = 0;
  std::int64_t boundary_triangles = 0;
  std::int64_t tets = 0;
  ElementCounts others{};  ///< of the types in blocks
};

/// Parts in any order when it is told what the parts before them have (of nodes nothing).
class UgridWriter : public GlobalMeshWriter {
 public:
  virtual void add_behind(const UgridCounts& before, const NumberedPart& part) = 0;
  void add(const NumberedPart& part) final;

 private:
  UgridCounts before_;
};

/// Truncates `path`. The numbers of boundary triangles follow the parts. @throws Error when a count
/// is above 2^31 - 1 and integers are not wide; IoError, also later from the writer.
std::unique_ptr<UgridWriter> write_ugrid(const std::filesystem::path& path,
                                         const UgridCounts& counts, UgridLayout layout);

/// As .lb8.ugrid.
std::unique_ptr<GlobalMeshWriter> write_ugrid(const std::filesystem::path& path,
                                              const Numbering& numbering,
                                              std::int64_t boundary_triangles);

}  // namespace tetfarm
