/// The layers that a job asks for: boundary layers, a table [[layers]] of the job file, and
/// absorbing layers, a table [[pml]]. --layers and --pml of the command line say the same in one
/// word and have the same checks (parse_layers_option, parse_pml_option).
#pragma once

#include "mesh/job_file/job_file.h"
#include "mesh/job_file/job_section.h"

namespace tetfarm {

/// Every key of a table [[layers]].
Words layers_keys();

/// @throws UsageError as JobSection does.
JobLayers parse_layers(const JobSection& top, const toml::node& node);

/// Those of the key `layers` of a table [patch.NAME], NAME being `glob`: the keys of [[layers]] but
/// for `patches`. @throws UsageError as JobSection does.
JobLayers parse_layers_of_patch(const JobSection& patch, const std::string& glob);

/// The same of a table [[pml]].
Words pml_keys();
JobPml parse_pml(const JobSection& top, const toml::node& node);

}  // namespace tetfarm
