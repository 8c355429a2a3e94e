/// Writes a finished mesh in another format (`tetfarm export`): one table of what can be written.
///
/// Source: thesis 4.3.4.2, final mesh options.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "mesh/formats/mesh_source.h"

namespace tetfarm {

struct MeshFormat {
  std::string_view name;    ///< as --format takes it
  std::string_view ending;  ///< of the file that tells the format; empty for a folder
  std::string_view what;    ///< for people
  /// Files of a single name are written under another one first: `file` is where to write to.
  bool is_single_file = true;
  void (*write)(const MeshSource& source, const MeshOutline& outline,
                const std::filesystem::path& file) = nullptr;
  /// Writes what goes beside `file`, where there is something.
  void (*write_beside)(const MeshOutline& outline, const std::filesystem::path& file) = nullptr;
  bool holds_parts = false;  ///< the file tells of each tet which part it is in
};

struct ExportCounts {
  std::int64_t nodes = 0;
  std::int64_t tets = 0;
  std::int64_t boundary_triangles = 0;
  std::size_t parts = 0;
};

/// The longest endings come before those that they end with.
std::span<const MeshFormat> mesh_formats();

/// By name, or by the ending of `output` when the name is empty. @throws UsageError naming all.
const MeshFormat& find_mesh_format(std::string_view name, const std::filesystem::path& output);

/// One file is wholly there or not at all. Of a format of many files those that others refer to
/// come last. @throws IoError, InvalidInput, Error when the format cannot hold the mesh.
/// Cost: O(n log n); memory of one part, see the formats.
ExportCounts export_mesh(const MeshSource& source, const MeshFormat& format,
                         const std::filesystem::path& output);

}  // namespace tetfarm
