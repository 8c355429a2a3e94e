/// The formats of meshes that a job writes itself.
#pragma once

#include <span>
#include <string_view>

namespace tetfarm {

/// What [output] formats may name. The job file's parser knows them (job_file.cpp).
std::span<const std::string_view> job_output_formats();

}  // namespace tetfarm
