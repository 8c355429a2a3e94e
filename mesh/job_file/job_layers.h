/// The boundary layers that a job asks for: a table [[layers]] of the job file. --layers of the
/// command line says the same in one word and has the same checks (parse_layers_option).
#pragma once

#include "mesh/job_file/job_file.h"
#include "mesh/job_file/job_section.h"

namespace tetfarm {

/// Every key of a table [[layers]].
Words layers_keys();

/// @throws UsageError as JobSection does.
JobLayers parse_layers(const JobSection& top, const toml::node& node);

}  // namespace tetfarm
