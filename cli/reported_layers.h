/// What a page about a mesh tells of its boundary layers, from the map of the wall that lies among
/// the results of a job (layer_coverage.h) and from the mesh.
#pragma once

#include <filesystem>
#include <optional>

#include "cli/command_line.h"
#include "cli/mesh_input.h"
#include "mesh/formats/mesh_source.h"
#include "report/report_page.h"

namespace tetfarm {

/// The text of the map of the mesh in a file, which lies beside it under its name, and of a job,
/// among its results; nothing where there is none. @throws as bring_file_of_job does.
std::optional<std::string> layer_map_of(const std::filesystem::path& mesh_file);
std::optional<std::string> layer_map_of(const wire::JobStatus& status, const ViewOptions& view,
                                        const std::filesystem::path& scratch_folder);

/// @param map the text of it. @param status of the job that made the mesh, if one is known.
/// @throws InvalidInput when the map is none. Memory: the map, and a part of the mesh.
ReportedLayers reported_layers(std::string_view map, const MeshSource& mesh,
                               const wire::JobStatus* status);

}  // namespace tetfarm
