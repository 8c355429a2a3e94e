/// The manual page of the job file, tetfarm-job(5), from the documents that are held against its
/// readers: docs/job_file.md, and of adaptation loops docs/adaptation.md.
#pragma once

#include <string>

#include "cli/manual_page.h"

namespace tetfarm {

/// What `tetfarm man` knows it by.
inline constexpr const char* name_of_job_file_page = "job";

/// @param version "0.1.0"
ManualPage job_file_page(const std::string& version);

}  // namespace tetfarm
