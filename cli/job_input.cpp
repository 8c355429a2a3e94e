#include "cli/job_input.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/error.h"
#include "base/error_with_help.h"
#include "base/file_system.h"
#include "base/hash.h"
#include "base/job_name.h"
#include "cli/output_formats.h"
#include "cli/unit_options.h"
#include "cli/wave_options.h"
#include "mesh/formats/flite/read_flite_sources.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/formats/surfaces/surface_formats.h"
#include "mesh/inspect/defect_text.h"
#include "mesh/job_file/loop_job.h"
#include "mesh/job_file/toml_limits.h"
#include "worker/checked_input.h"
#include "worker/job_domain.h"
#include "worker/job_layers.h"
#include "worker/job_patch_sizes.h"
#include "worker/job_patch_types.h"
#include "worker/job_pml.h"
#include "worker/job_surface.h"
#include "worker/patch_globs.h"

namespace tetfarm {
namespace {

/// A size wins over a frequency of the job file, and the other way.
void set_size(JobFile& job, const RunOptions& options) {
  if (options.size) {
    job.spacing_default = *options.size;
    job.wave.reset();
    return;
  }
  job.wave = wave_of(options.wave, job.wave);
  if (job.wave) job.spacing_default = size_of(*job.wave);
}

void set_outer(JobFile& job, const std::string& text) {
  const std::size_t colon = text.find(':');
  job.outer_kind = text.substr(0, colon);
  if (job.outer_kind == "none" && colon == std::string::npos) return;
  if (job.outer_kind != "box" && job.outer_kind != "sphere") {
    throw UsageError("\"" + text + "\" is not box[:FACTOR] or sphere[:FACTOR]", "--outer");
  }
  job.outer_factor = default_outer_factor(job.outer_kind);
  if (colon == std::string::npos) return;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data() + colon + 1, end, job.outer_factor);
  const bool is_number = error == std::errc() && stopped == end && std::isfinite(job.outer_factor);
  if (!is_number || job.outer_factor <= 1) {
    throw UsageError("the factor in \"" + text + "\" must be a number above 1", "--outer");
  }
}

void set_outer_size(JobFile& job, double size) {
  if (job.outer_kind == "none") {
    throw UsageError("there is no outer boundary; also give --outer box or --outer sphere",
                     "--outer-size");
  }
  job.outer_spacing = size;
}

void set_remeshing(JobFile& job, const RunOptions& options) {
  if (options.remesh && !job.remeshing) job.remeshing.emplace();
  if (options.size_on_body) {
    if (!job.remeshing) {
      throw UsageError("the surface is meshed as it is; also give --remesh", "--size-on-body");
    }
    job.remeshing->size = *options.size_on_body;
  }
  if (!job.remeshing) return;
  const double size = job.remeshing->size > 0 ? job.remeshing->size : job.spacing_default;
  if (size > 0 && job.remeshing->min_size > size) {
    throw UsageError("must not be more than the size of the edges", "[surface] min_size");
  }
}

void set_max_memory(JobFile& job, const std::string& text) {
  const auto bytes = parse_memory(text);
  if (!bytes)
    throw UsageError("\"" + text + "\" is not an amount such as 2GiB or 500MB", "--max-memory");
  job.max_memory_bytes = *bytes;
  job.subdomains = 0;
  job.groups = 0;
}

void set_layers(JobFile& job, const std::vector<std::string>& typed) {
  if (typed.empty()) return;
  job.layers.clear();
  for (const std::string& text : typed) job.layers.push_back(parse_layers_option(text));
}

/// @pre all else of the job is set.
void set_symmetry(JobFile& job, const std::string& typed) {
  if (!typed.empty()) {
    job.symmetry = parse_symmetry(typed);
    if (!job.symmetry) {
      throw UsageError("\"" + typed + "\" is not " + symmetry_examples, "--symmetry");
    }
  }
  const std::string obstacle = obstacle_to_symmetry(job);
  if (!obstacle.empty()) {
    throw UsageError("cannot be given together with " + obstacle, "--symmetry ([domain] symmetry)");
  }
}

/// As far as it can be told of a surface that need not have been checked.
void require_patches(const JobFile& job, const SurfaceMesh& surface) {
  if (job.layers.empty() && !job.pml && job.patches.empty()) return;
  OuterBoundary outer = outer_boundary_to_add(job);
  outer.is_sketch = true;
  require_patch_sizes(job, own_patch_names(job, surface));
  const SurfaceMesh domain = add_outer_boundary(surface, outer, job.growth);
  require_patch_types(job, patch_names_of(domain));
  layer_requests_of(job, domain);
  if (job.pml) pml_patches_of(job, domain);
}

std::string without_ending(const std::string& name, const std::string& ending) {
  return name.ends_with(ending) ? name.substr(0, name.size() - ending.size()) : name;
}

/// The job carries its sources itself: those who work on it see no file but the surface.
void take_sources_of_file(JobFile& job) {
  if (job.sources_file.empty()) return;
  const FliteSources file = read_flite_sources(read_file(job.sources_file), job.sources_file);
  job.sources.insert(job.sources.end(), file.sources.begin(), file.sources.end());
  if (job.spacing_default == 0) job.spacing_default = file.background;
  job.sources_file.clear();
}

JobFile base_job(const std::string& input) {
  if (input.ends_with(".toml")) {
    const std::string text = text_of_job_file(input);
    if (is_loop_job(text, input)) {
      throw ErrorWithHelp(ExitCode::usage, input + ": this is the job file of an adaptation loop",
                          "run it with `tetfarm loop " + input + " -o DIR`");
    }
    JobFile read = parse_job_file(text, input);
    take_sources_of_file(read);
    return read;
  }
  JobFile job;
  if (std::filesystem::is_directory(input)) {
    throw UsageError("is a folder, not a surface or a job file", input);
  }
  job.surface = input;
  job.name =
      std::filesystem::path(without_ending(input, ".gz")).filename().replace_extension("").string();
  return job;
}

}  // namespace

std::string text_of_job_file(const std::string& path) {
  // One byte too many is enough to be refused by who parses it.
  return read_part_of_file(path, 0, largest_job_file + 1);
}

JobInput describe_job(const RunOptions& options) {
  JobInput input{base_job(options.input), {}, {}};
  JobFile& job = input.job;
  if (options.subdomains || options.groups) job.max_memory_bytes = 0;
  if (options.subdomains) job.subdomains = *options.subdomains;
  if (options.groups) job.groups = *options.groups;
  if (!options.max_memory.empty()) set_max_memory(job, options.max_memory);
  if (job.subdomains > 0 && job.subdomains < job.groups) {
    throw UsageError("must not be more than the number of sub-domains", "--groups");
  }
  set_scale(job, options.scale, options.unit);
  set_size(job, options);
  if (options.growth) job.growth = *options.growth;
  set_remeshing(job, options);
  if (options.outer) set_outer(job, *options.outer);
  if (options.outer_size) set_outer_size(job, *options.outer_size);
  require_within_wave(job);
  set_layers(job, options.layers);
  job.patches =
      patches_of_options(options.patch_types, options.patch_sizes, std::move(job.patches));
  if (!options.pml.empty()) job.pml = parse_pml_option(options.pml);
  set_symmetry(job, options.symmetry);
  if (options.max_elements) job.max_elements = *options.max_elements;
  if (options.force) job.max_elements = 0;
  if (!options.formats.empty()) {
    require_known_formats(options.formats);
    job.formats = options.formats;
  }
  if (!options.keep.empty()) job.keep = options.keep;
  input.path = job.surface;
  surface_format_of(input.path);  // refused before a file is read or anything is started
  job.surface = std::filesystem::path(without_ending(job.surface, ".gz")).filename().string();
  return input;
}

JobInput read_job(const RunOptions& options) {
  JobInput input = describe_job(options);
  input.surface = read_maybe_gzip(input.path);
  return input;
}

void check_submittable(const JobInput& input) {
  const std::string problem = problem_with_job_name(input.job.name);
  if (!problem.empty()) {
    throw UsageError("the job takes its name from this file, and a job's name " + problem +
                         "; rename the file, or give a job file with a `name`",
                     input.path);
  }
  const std::size_t size = to_toml(input.job).size();
  if (size > largest_job_file) {
    throw UsageError("the job with its sources has " + std::to_string(size) +
                         " bytes, more than the " + std::to_string(largest_job_file) +
                         " allowed: use fewer sources",
                     input.path);
  }
}

void require_readable(const JobInput& input) {
  const SurfaceMesh surface = read_surface_of_job(input.job, input.surface, input.path);
  require_patches(input.job,
                  input.job.symmetry ? check_surface_of_job(input.job, surface).surface : surface);
}

void require_meshable(const JobInput& input) {
  const CheckedSurface checked =
      check_surface_of_job(input.job, read_surface_of_job(input.job, input.surface, input.path));
  if (!checked.report.defects.empty()) {
    throw Error(ExitCode::bad_geometry, input.path + ": " + defects_text(checked.report.defects));
  }
  require_patches(input.job, checked.surface);
}

std::string key_of(const JobInput& input) {
  Hasher hasher;
  const std::string toml = to_toml(input.job);
  const std::string surface = hash128(input.surface).hex();
  hasher.add(toml.data(), toml.size());
  hasher.add(surface.data(), surface.size());
  return hasher.finish().hex();
}

}  // namespace tetfarm
