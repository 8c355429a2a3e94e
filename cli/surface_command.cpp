#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/angle_text.h"
#include "cli/commands.h"
#include "cli/defects_file.h"
#include "cli/healing_report.h"
#include "cli/job_input.h"
#include "cli/place_text.h"
#include "cli/unit_options.h"
#include "cli/wave_options.h"
#include "json/json_line.h"
#include "mesh/formats/surfaces/write_surface.h"
#include "mesh/healing/write_acts_vtp.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/remeshing/remeshing_figures.h"
#include "worker/checked_input.h"
#include "worker/job_remeshing.h"
#include "worker/job_surface.h"

namespace tetfarm {
namespace {

/// More is told, with what helps.
constexpr double notable_change_of_volume = 0.01;

using Json = nlohmann::ordered_json;

/// The command's words win over the job file's.
JobRemeshing remeshing_of(const SurfaceCommand& command, const JobFile& job) {
  JobRemeshing remeshing = job.remeshing.value_or(JobRemeshing{});
  if (command.size > 0) remeshing.size = command.size;
  if (is_given(command.wave)) remeshing.size = size_of(job.wave.value());
  if (command.min_size > 0) remeshing.min_size = command.min_size;
  if (command.angle > 0) remeshing.angle = command.angle;
  if (command.tolerance > 0) remeshing.tolerance = command.tolerance;
  return remeshing;
}

JobInput input_of(const SurfaceCommand& command) {
  RunOptions options;
  options.input = command.input;
  options.patch_sizes = command.patch_sizes;
  if (command.growth > 0) options.growth = command.growth;
  JobInput input = read_job(options);
  if (command.size > 0) {
    input.job.wave.reset();
  } else {
    input.job.wave = wave_of(command.wave, input.job.wave);
  }
  input.job.remeshing = remeshing_of(command, input.job);
  return input;
}

/// Nothing where the size of the edges on the surface is another.
std::optional<WaveSize> wave_on_surface(const JobFile& job) {
  const double size = job.remeshing.value().size;
  return job.wave && (size == 0 || size == size_of(*job.wave)) ? job.wave : std::nullopt;
}

/// @throws UsageError when the result would replace its input.
std::string output_of(const SurfaceCommand& command, const JobInput& input) {
  const char* ending = command.heal_only ? ".healed.stl" : ".remeshed.stl";
  std::string output = command.output.empty() ? input.job.name + ending : command.output;
  std::error_code none;
  if (std::filesystem::equivalent(output, input.path, none)) {
    throw UsageError("would overwrite the surface that it is made from: give another -o", output);
  }
  return output;
}

void print_figures(const RemeshingFigures& f, const std::string& output) {
  std::printf("triangles       %lld, before %lld\nvertices        %lld\n",
              static_cast<long long>(f.triangles), static_cast<long long>(f.triangles_before),
              static_cast<long long>(f.vertices));
  std::printf("smallest angle  %s deg near %s, before %s deg; %lld below 20 deg\n",
              angle_text(f.smallest_angle_deg).c_str(), place_text(f.smallest_at).c_str(),
              angle_text(f.smallest_angle_before_deg).c_str(),
              static_cast<long long>(f.below_20_deg));
  if (f.free_triangles > 0) {
    std::printf("off features    %s deg smallest, %lld of %lld below 30 deg\n",
                angle_text(f.smallest_free_angle_deg).c_str(),
                static_cast<long long>(f.free_below_30_deg),
                static_cast<long long>(f.free_triangles));
  }
  std::printf("shape           %.3f mean of 2 inradius / circumradius\n", f.mean_radius_ratio);
  std::printf("edges           %.3f of the wanted length on average, %.1f %% from 0.6 to 1.5\n",
              f.mean_length, 100 * f.well_sized);
  std::printf("distance        %.4g from the input, near %s; %.4g from it to the result, near %s\n",
              f.from_input.distance, place_text(f.from_input.at).c_str(), f.to_input.distance,
              place_text(f.to_input.at).c_str());
  std::printf("volume          %.9g, before %.9g\n", f.volume, f.volume_before);
  const double change = f.volume / f.volume_before - 1;
  if (std::abs(change) > notable_change_of_volume) {
    std::printf(
        "                %.2g %% %s: thin and rounded parts keep more of their shape with a "
        "smaller --tolerance\n",
        100 * std::abs(change), change < 0 ? "less" : "more");
  }
  std::printf("%s\n", output.c_str());
}

Json figures_json(const RemeshingFigures& f, const std::string& output) {
  return {{"type", "surface"},
          {"file", output},
          {"triangles_before", f.triangles_before},
          {"triangles", f.triangles},
          {"vertices", f.vertices},
          {"smallest_angle_before_deg", f.smallest_angle_before_deg},
          {"smallest_angle_deg", f.smallest_angle_deg},
          {"smallest_angle_at", place_json(f.smallest_at)},
          {"below_20_deg", f.below_20_deg},
          {"below_30_deg", f.below_30_deg},
          {"off_features", f.free_triangles},
          {"smallest_angle_off_features_deg", f.smallest_free_angle_deg},
          {"off_features_below_30_deg", f.free_below_30_deg},
          {"mean_radius_ratio", f.mean_radius_ratio},
          {"mean_length", f.mean_length},
          {"well_sized", f.well_sized},
          {"distance_from_input", f.from_input.distance},
          {"distance_from_input_at", place_json(f.from_input.at)},
          {"distance_to_input", f.to_input.distance},
          {"distance_to_input_at", place_json(f.to_input.at)},
          {"volume_before", f.volume_before},
          {"volume", f.volume}};
}

/// Beside the output: what was changed, to look at.
std::string acts_file(const JobInput& input, const std::string& output) {
  const std::filesystem::path folder = std::filesystem::path(output).parent_path();
  return (folder / (input.job.name + ".healed.vtp")).string();
}

/// @throws Error (bad_geometry) when not all of it could be mended.
HealedSurface mended(const SurfaceCommand& command, const JobInput& input,
                     const SurfaceMesh& surface, const std::string& output) {
  HealedSurface healed = heal_surface(surface, region_rules_of(input.job),
                                      {command.heal_tolerance, command.largest_hole});
  if (!healed.acts.empty()) write_acts_vtp(healed.acts, acts_file(input, output));
  if (!command.json) {
    print_healing(healed);
    if (!healed.acts.empty()) std::printf("%-16ssee %s\n", "", acts_file(input, output).c_str());
  }
  require_no_defects(healed.surface, healed.checked.report, input, command.defects_file);
  return healed;
}

void tell_programs(const SurfaceCommand& command, const Json& json) {
  if (command.json) std::printf("%s\n", json_line(json).c_str());
}

/// What was mended is written as it is, the rest as it was.
ExitCode write_mended(const SurfaceCommand& command, const HealedSurface& healed,
                      const SurfaceMesh& surface, const std::string& output) {
  const SurfaceMesh& made = healed.checked.surface;
  write_surface(made, output);
  if (!command.json) {
    std::printf("triangles       %zu, before %zu\n%s\n", made.triangles.size(),
                surface.triangles.size(), output.c_str());
  }
  tell_programs(command, {{"type", "surface"},
                          {"file", output},
                          {"triangles_before", surface.triangles.size()},
                          {"triangles", made.triangles.size()},
                          {"healing", healing_json(healed)}});
  return ExitCode::ok;
}

}  // namespace

ExitCode surface_command(const SurfaceCommand& command) {
  const JobInput input = input_of(command);
  const std::string output = output_of(command, input);
  const SurfaceMesh surface = read_surface_of_job(input.job, input.surface, input.path);
  std::optional<HealedSurface> healed;
  if (command.heal || command.heal_only) healed = mended(command, input, surface, output);
  if (command.heal_only) return write_mended(command, *healed, surface, output);
  const CheckedSurface checked =
      healed ? healed->checked : check_surface(surface, region_rules_of(input.job));
  require_no_defects(surface, checked.report, input, command.defects_file);
  const JobRemeshed remeshed = remesh_for_job(input.job, checked.surface);
  write_surface(remeshed.made.surface, output);
  const RemeshingFigures figures =
      remeshing_figures(checked.surface, remeshed.made, remeshed.spacing);
  const std::optional<WaveSize> wave = wave_on_surface(input.job);
  const std::string lengths = lengths_text(input.job);
  if (!lengths.empty() && !command.json) std::printf("lengths         %s\n", lengths.c_str());
  if (wave && !command.json) std::printf("size            %s\n", wave_size_text(*wave).c_str());
  if (!command.json) print_figures(figures, output);
  Json json = figures_json(figures, output);
  put_lengths(input.job, json);
  put_wave(wave, json);
  if (healed) json["healing"] = healing_json(*healed);
  tell_programs(command, json);
  return ExitCode::ok;
}

}  // namespace tetfarm
