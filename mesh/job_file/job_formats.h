/// The formats of meshes that a job may ask for.
///
/// The tasks write some (`assemble`); every other one is converted from VTKHDF by whoever takes the
/// results out (run, wait), with mesh/formats/registry/export_mesh.h. All come from the one list of
/// formats (mesh/formats/list/known_formats.h).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetfarm {

/// What [output] formats and --format may name: all that `tetfarm export` writes.
std::span<const std::string_view> job_output_formats();

/// Of the formats of a job, those that its tasks write, in their order; VTKHDF last where another
/// is to be converted from it and it was not named.
std::vector<std::string> formats_of_tasks(const std::vector<std::string>& wanted);

/// Of the formats of a job, those that are converted, in their order.
std::vector<std::string> formats_to_convert(const std::vector<std::string>& wanted);

}  // namespace tetfarm
