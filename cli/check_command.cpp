#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/angle_text.h"
#include "base/counted.h"
#include "cli/commands.h"
#include "cli/defects_file.h"
#include "cli/healing_report.h"
#include "cli/job_input.h"
#include "cli/layers_report.h"
#include "cli/unit_options.h"
#include "cli/wave_options.h"
#include "json/json_line.h"
#include "json/surface_angles.h"
#include "worker/checked_input.h"
#include "worker/inspect_task.h"
#include "worker/job_domain.h"
#include "worker/job_layers.h"
#include "worker/job_remeshing.h"
#include "worker/job_surface.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

/// What the job would come to; only of a surface without defects. Of a remeshed surface, where the
/// job asks for one.
struct Estimate {
  double elements = 0;
  std::int64_t subdomains = 0;
  SurfaceAngles angles;  ///< that the domain's boundary forces
  std::vector<LayerFigures> layers;
  std::optional<PmlFigures> pml;
};

Estimate estimate(const JobFile& job, const CheckedSurface& checked) {
  const JobDomain domain = domain_of_job(job, surface_to_mesh(job, checked).surface);
  return {domain.all_elements(), wanted_parts(job, domain.elements, region_count(domain.surface)),
          surface_angles_of(domain.surface), layer_figures_of(job, domain.surface),
          domain.layers ? domain.layers->pml : std::nullopt};
}

Json report_json(const SurfaceMesh& surface, const SurfaceReport& report) {
  Json json = {{"type", "check"},
               {"can_be_meshed", report.defects.empty()},
               {"triangles", surface.triangles.size()},
               {"vertices", surface.vertices.size()},
               {"patches", surface.patch_names},
               {"shells", report.shells.size()},
               {"volume", report.volume},
               {"shortest_edge", report.shortest_edge},
               {"median_edge", report.median_edge},
               {"longest_edge", report.longest_edge},
               {"smallest_angle_deg", report.smallest_angle_deg},
               {"remarks", report.remarks},
               {"regions", Json::array()},
               {"defects", Json::array()}};
  for (const RegionFigures& region : report.regions) {
    json["regions"].push_back({{"number", region.number},
                               {"name", region.name},
                               {"void", region.number == 0},
                               {"volume", region.volume}});
  }
  for (const SurfaceDefect& defect : report.defects) {
    json["defects"].push_back(
        {{"kind", defect.kind}, {"message", defect.message}, {"triangles", defect.triangles}});
  }
  return json;
}

void print_remark(const std::string& remark) {
  std::printf("remark          %s\n", remark.c_str());
}

std::string cubed_unit(const JobFile& job) {
  const std::string unit = unit_behind(job);
  return unit.empty() ? "" : unit + "^3";
}

void print_region(const JobFile& job, const RegionFigures& region) {
  if (region.number > 0) {
    std::printf("region %-8d %s", region.number, region.name.c_str());
  } else {
    std::printf("void            %s", region.name.c_str());
  }
  if (region.volume > 0) std::printf(", volume %.9g%s", region.volume, cubed_unit(job).c_str());
  std::printf("\n");
}

void print_report(const JobFile& job, const SurfaceMesh& surface, const SurfaceReport& report) {
  const std::string unit = unit_behind(job);
  const std::string lengths = lengths_text(job);
  if (!lengths.empty()) std::printf("lengths         %s\n", lengths.c_str());
  std::printf(
      "triangles       %zu\nvertices        %zu\npatches         %zu\nshells          %zu\n",
      surface.triangles.size(), surface.vertices.size(), surface.patch_names.size(),
      report.shells.size());
  std::printf("volume          %.9g%s\n", report.volume, cubed_unit(job).c_str());
  std::printf("edges           %.4g%s shortest, %.4g%s median, %.4g%s longest\n",
              report.shortest_edge, unit.c_str(), report.median_edge, unit.c_str(),
              report.longest_edge, unit.c_str());
  std::printf("smallest angle  %s deg\n", angle_text(report.smallest_angle_deg).c_str());
  for (const RegionFigures& region : report.regions) print_region(job, region);
  for (const std::string& remark : report.remarks) print_remark(remark);
}

std::vector<std::string> remarks_on(const JobFile& job, const SurfaceReport& report,
                                    const Estimate& coming) {
  std::vector<std::string> remarks = angle_remarks(coming.angles);
  const std::string edges = remark_on_long_edges(job, report.longest_edge);
  if (!edges.empty()) remarks.push_back(edges);
  return remarks;
}

void put_estimate(const JobFile& job, const Estimate& coming,
                  const std::vector<std::string>& remarks, Json& json) {
  put_wave(job.wave, json);
  json["estimated_elements"] = coming.elements;
  json["subdomains"] = coming.subdomains;
  json["angles"] = surface_angles_json(coming.angles);
  for (const std::string& remark : remarks) json["remarks"].push_back(remark);
  if (!coming.layers.empty()) json["layers"] = layers_json(coming.layers);
  if (coming.pml) json["pml"] = pml_json(*coming.pml);
}

void print_estimate(const JobFile& job, const Estimate& coming,
                    const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks) print_remark(remark);
  if (coming.pml) std::printf("pml             %s\n", pml_text(*coming.pml).c_str());
  for (const LayerFigures& layers : coming.layers) {
    std::printf("layers          %s\n", layers_text(layers).c_str());
  }
  if (job.wave) std::printf("size            %s\n", wave_size_text(*job.wave).c_str());
  std::printf("elements        about %.3g, in %s\n", coming.elements,
              counted(static_cast<std::uint64_t>(coming.subdomains), "sub-domain").c_str());
}

JobInput input_of(const CheckOptions& options) {
  RunOptions job_options;
  job_options.input = options.input;
  job_options.size = options.size;
  job_options.wave = options.wave;
  job_options.growth = options.growth;
  job_options.remesh = options.remesh;
  job_options.size_on_body = options.size_on_body;
  job_options.outer = options.outer;
  job_options.outer_size = options.outer_size;
  job_options.layers = options.layers;
  job_options.pml = options.pml;
  job_options.patch_types = options.patch_types;
  job_options.patch_sizes = options.patch_sizes;
  job_options.scale = options.scale;
  job_options.unit = options.unit;
  job_options.symmetry = options.symmetry;
  return read_job(job_options);
}

}  // namespace

ExitCode check_command(const CheckOptions& options) {
  if (!options.store.empty()) return check_store_command(options);
  if (options.input.empty())
    throw UsageError("give a surface, a job file, or --store DIR", "check");
  const JobInput input = input_of(options);
  const SurfaceMesh surface = read_surface_of_job(input.job, input.surface, input.path);
  const CheckedSurface checked = check_surface_of_job(input.job, surface);
  const bool is_sound = checked.report.defects.empty();
  Json json = report_json(surface, checked.report);
  put_lengths(input.job, json);
  if (!options.json) print_report(input.job, surface, checked.report);
  if (is_sound) {
    const Estimate coming = estimate(input.job, checked);
    const std::vector<std::string> remarks = remarks_on(input.job, checked.report, coming);
    put_estimate(input.job, coming, remarks, json);
    if (!options.json) print_estimate(input.job, coming, remarks);
  }
  if (!is_sound && !input.job.symmetry) {
    const HealedSurface healed = heal_surface(surface, region_rules_of(input.job), {});
    json["healing"] = healing_json(healed);
    if (!options.json) print_prospect_of_healing(healed, input.path);
  }
  if (options.json) std::printf("%s\n", json_line(json).c_str());
  require_no_defects(checked.surface, checked.report, input, options.defects_file);
  return ExitCode::ok;
}

}  // namespace tetfarm
