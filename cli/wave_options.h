/// Edge lengths by the wavelength, as the command line and the job file have them together.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "cli/command_line.h"
#include "mesh/job_file/job_file.h"

namespace tetfarm {

/// Whether any of the words was typed.
bool is_given(const WaveOptions& typed);

/// The command line's words win over the job file's, one by one; nothing where there is no
/// frequency. @throws UsageError where there are other words but no frequency, and where the
/// numbers make no size.
std::optional<WaveSize> wave_of(const WaveOptions& typed, const std::optional<WaveSize>& of_job);

/// The job's other sizes must not be above what its wavelength allows. @throws UsageError that
/// names the larger one.
void require_within_wave(const JobFile& job);

/// What becomes of edges of a surface that are longer than the wavelength allows; "" where none is,
/// where there is no wave, and where the surface is remeshed.
std::string remark_on_long_edges(const JobFile& job, double longest_edge);

/// On standard error, what the frequency comes to; nothing where there is none.
void tell_wave(const JobFile& job, ProgressStyle style);

/// For programs, as `size` and `wavelength`.
void put_wave(const std::optional<WaveSize>& wave, nlohmann::ordered_json& json);

}  // namespace tetfarm
