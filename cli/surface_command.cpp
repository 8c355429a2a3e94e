#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/angle_text.h"
#include "cli/commands.h"
#include "cli/defects_file.h"
#include "cli/job_input.h"
#include "cli/place_text.h"
#include "json/json_line.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/formats/surfaces/write_surface.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/remeshing/remesh.h"
#include "mesh/remeshing/remeshing_figures.h"
#include "worker/inspect_task.h"
#include "worker/job_domain.h"

namespace tetfarm {
namespace {

JobInput input_of(const SurfaceCommand& command) {
  RunOptions options;
  options.input = command.input;
  if (command.size > 0) options.size = command.size;
  if (command.growth > 0) options.growth = command.growth;
  return read_job(options);
}

RemeshOptions remesh_options_of(const SurfaceCommand& command, const JobFile& job) {
  const SpacingOptions spacing = spacing_options_of(job);
  RemeshOptions options;
  options.size = spacing.background;
  options.min_size = command.min_size;
  options.angle_deg = command.angle;
  options.tolerance = command.tolerance;
  options.growth = spacing.growth;
  options.sources = spacing.sources;
  return options;
}

/// @throws UsageError when the result would replace its input.
std::string output_of(const SurfaceCommand& command, const JobInput& input) {
  std::string output = command.output.empty() ? input.job.name + ".remeshed.stl" : command.output;
  std::error_code none;
  if (std::filesystem::equivalent(output, input.path, none)) {
    throw UsageError("would overwrite the surface that it is made from: give another -o", output);
  }
  return output;
}

/// A fault of ours, whatever the input: such a surface is not written.
void require_sound(const SurfaceMesh& surface, const JobFile& job) {
  SurfaceMesh plain = surface;
  plain.sides.clear();
  plain.region_names.clear();
  const CheckedSurface checked = check_surface(plain, region_rules_of(job));
  if (checked.report.defects.empty()) return;
  throw Error(ExitCode::failed,
              "the remeshed surface is not sound, which is a fault of Tetfarm; "
              "it is not written: " +
                  checked.report.defects.front().message);
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
  std::printf("%s\n", output.c_str());
}

nlohmann::ordered_json figures_json(const RemeshingFigures& f, const std::string& output) {
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

}  // namespace

ExitCode surface_command(const SurfaceCommand& command) {
  const JobInput input = input_of(command);
  const std::string output = output_of(command, input);
  const SurfaceMesh surface = read_surface_bytes(input.surface, input.path);
  const CheckedSurface checked = check_surface(surface, region_rules_of(input.job));
  require_no_defects(surface, checked.report, input, command.defects_file);
  const RemeshOptions options =
      with_defaults(remesh_options_of(command, input.job), checked.surface);
  const SurfaceFeatures features = surface_features(checked.surface, options.angle_deg);
  const RemeshingSpacing spacing = remeshing_spacing(checked.surface, features, options);
  const RemeshedSurface result = remesh(checked.surface, features, spacing, options);
  require_sound(result.surface, input.job);
  write_surface(result.surface, output);
  const RemeshingFigures figures = remeshing_figures(checked.surface, result, spacing);
  if (command.json) {
    std::printf("%s\n", json_line(figures_json(figures, output)).c_str());
  } else {
    print_figures(figures, output);
  }
  return ExitCode::ok;
}

}  // namespace tetfarm
