/// The surface of a job as a file between tasks: read whole, or in the pieces that one leaf has of
/// it, at the cost of these. The grammar is in store/formats.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/artifacts/block_file.h"
#include "mesh/core/surface_mesh.h"

namespace tetfarm {

std::string surface_to_bytes(const SurfaceMesh& surface);
/// Also of the layout before blocks, for jobs that were begun by an older version.
/// @throws CorruptFile naming `name`.
SurfaceMesh surface_from_bytes(std::string_view bytes, const std::string& name);

/// Whether a file that begins like this is a surface without blocks: it is only read whole.
bool is_surface_without_blocks(std::string_view begin);

/// Numbers of vertices and triangles of a surface, in any order.
struct WantedPieces {
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> triangles;
};

/// What the surface has under those numbers, in the same order.
struct SurfacePieces {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;    ///< vertices by their numbers in the surface
  std::vector<std::int32_t> patches;  ///< of each of these triangles; 0 in a surface without any
  std::vector<Sides> sides;           ///< of each of these triangles
};

/// @throws Error when there is no such vertex or triangle. Cost: O(pieces).
SurfacePieces pieces_of(const SurfaceMesh& surface, const WantedPieces& wanted);

/// How much a file has of what, and where in it that begins.
struct SurfaceCounts {
  std::uint64_t vertices = 0;
  std::uint64_t triangles = 0;
  std::uint64_t patched_triangles = 0;  ///< all, or none where there are no patches
  std::uint64_t patches = 0;
  std::uint64_t sided_triangles = 0;  ///< all, or none where there is one region
  std::uint64_t regions = 0;

  std::uint64_t vertices_at() const;
  std::uint64_t triangles_at() const;
  std::uint64_t patches_at() const;
  std::uint64_t sides_at() const;
  std::uint64_t names_at() const;
};

/// A file of a surface, open to read pieces of it. @throws CorruptFile naming `name`, IoError.
class SurfaceFile {
 public:
  /// Reads the counts and the names.
  SurfaceFile(const std::filesystem::path& path, const std::string& name);

  const std::vector<std::string>& patch_names() const { return patch_names_; }
  const std::vector<std::string>& region_names() const { return region_names_; }
  /// As pieces_of. Cost: O(n log n) for n pieces, and a block of the file for each at most: fewer
  /// where their numbers are near to each other.
  SurfacePieces read(const WantedPieces& wanted);
  std::uint64_t bytes_read() const { return file_.bytes_read(); }

 private:
  BlockFile file_;
  SurfaceCounts counts_;
  std::vector<std::string> patch_names_;
  std::vector<std::string> region_names_;
};

}  // namespace tetfarm
