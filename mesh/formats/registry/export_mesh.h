/// Writes a finished mesh in another format (`tetfarm export`): in any that the list of formats
/// writes.
///
/// Source: thesis 4.3.4.2, final mesh options.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "mesh/core/element_block.h"
#include "mesh/formats/list/format.h"
#include "mesh/formats/mesh_source.h"

namespace tetfarm {

struct ExportCounts {
  std::int64_t nodes = 0;
  ElementCounts elements{};  ///< of each type
  std::size_t parts = 0;
};

/// All that can be written, in the order of the list of formats.
std::span<const Format> written_formats();

/// A line for each: name, ending, what it is.
std::string written_formats_text();

/// By name, or by the ending of `output` when the name is empty. @throws UsageError naming all.
const Format& find_mesh_format(std::string_view name, const std::filesystem::path& output);

/// A file cannot take the place of a folder. @throws UsageError when `output` is one and the format
/// writes files.
void require_name_of_a_file(const Format& format, const std::filesystem::path& output);

/// One file is wholly there or not at all. Of a format of many files those that others refer to
/// come last. @throws UsageError as require_name_of_a_file, IoError, InvalidInput, Error when the
/// format cannot hold the mesh.
/// Cost: O(n log n); memory of one part, see the formats.
ExportCounts export_mesh(const MeshSource& source, const Format& format,
                         const std::filesystem::path& output);

}  // namespace tetfarm
