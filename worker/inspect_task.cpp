#include "worker/inspect_task.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "base/error.h"
#include "mesh/artifacts/artifact_file.h"
#include "mesh/artifacts/surface_file.h"
#include "mesh/core/triangle_angles.h"
#include "mesh/decompose/planar_cut.h"
#include "mesh/layers/layer_chunk_file.h"
#include "tasks/inspect_contract.h"
#include "worker/checked_input.h"

namespace tetfarm {
namespace {

/// Leaves to be assimilated, when their number is left to us: as many to a group as the thesis has
/// (128 to 8), but none of a few hundred elements.
constexpr double leaves_in_group = 16;
constexpr double least_leaf_elements = 1000;

/// Sub-domains when nobody says how large they are to be, by the job alone, so that all machines
/// make the same mesh (docs/decisions/0024-size-of-a-subdomain.md). A job that one core meshes in a
/// second or two stays whole; others have something to do for four workers.
constexpr double uncut_elements = 400'000;
constexpr double fewest_leaves = 4;
constexpr double largest_leaf_elements = 2'000'000;

double leaf_elements(double elements) {
  TF_CHECK(elements >= 0);
  if (elements < uncut_elements) return uncut_elements;
  return std::min(elements / fewest_leaves, largest_leaf_elements);
}

double target_elements(const JobFile& job, double elements) {
  return job.target_elements > 0 ? static_cast<double>(job.target_elements)
                                 : leaf_elements(elements);
}

void report_numbers(TaskIo& io, const JobDomain& domain, const SurfaceReport& report) {
  const SurfaceMesh& surface = domain.surface;
  io.number("input_triangles", static_cast<double>(surface.triangles.size()));
  io.number("shells", static_cast<double>(report.shells.size()));
  io.number("input_smallest_angle_deg", report.smallest_angle_deg);
  io.number("domain_volume", domain.volume);
  io.number("regions", region_count(surface));
  std::string remarks;
  for (const std::string& remark : report.remarks) remarks += remark + "\n";
  if (!remarks.empty()) io.text("remarks", remarks);
}

void report_forecast(TaskIo& io, const JobForecast& forecast) {
  io.number("forecast_bytes", forecast.task_bytes);
  io.number("forecast_disk_bytes", forecast.disk_bytes);
  io.number("forecast_seconds", forecast.seconds);
}

/// "layers_wall_triangles", "layers_short_ridge"…: how much of the wall has what was asked for.
void report_layers(TaskIo& io, const DomainLayers& layers) {
  const LayerCoverage& coverage = layers.coverage;
  io.number("layers_wall_triangles", static_cast<double>(coverage.wall_triangles));
  io.number("layers_full", static_cast<double>(coverage.full));
  io.number("layers_partial", static_cast<double>(coverage.partial()));
  io.number("layers_none", static_cast<double>(coverage.none));
  io.number("layers_cells", static_cast<double>(layers.cells));
  io.number("layers_with_first", static_cast<double>(coverage.with_first));
  io.number("layers_first_within_2", static_cast<double>(coverage.first_within_2));
  io.number("layers_first_within_10", static_cast<double>(coverage.first_within_10));
  for (const auto& [reason, triangles] : coverage.short_of_layers) {
    std::string name = name_of(reason);
    std::replace(name.begin(), name.end(), ' ', '_');
    io.number("layers_short_" + name, static_cast<double>(triangles));
  }
}

/// "layers_planes", "layers_plane_quads"…: what was changed of patches without layers.
void report_planes(TaskIo& io, const RetreatFigures& planes) {
  if (planes.planes == 0) return;
  io.number("layers_planes", static_cast<double>(planes.planes));
  io.number("layers_plane_triangles_before", static_cast<double>(planes.triangles_before));
  io.number("layers_plane_triangles_after",
            static_cast<double>(planes.triangles_after + planes.side_triangles));
  io.number("layers_plane_quads", static_cast<double>(planes.quads));
}

void report_pml(TaskIo& io, const PmlFigures& pml) {
  io.number("pml_layers", pml.layers);
  io.number("pml_height", pml.height);
  io.number("pml_thickness", pml.thickness);
  io.number("pml_cells", static_cast<double>(pml.cells()));
  io.number("pml_tets", static_cast<double>(pml.tets));
  io.number("pml_prisms", static_cast<double>(pml.prisms));
  io.number("pml_outer_triangles", static_cast<double>(pml.triangles));
}

void publish_layers(TaskIo& io, const DomainLayers& layers, InspectMade& made) {
  if (!layers.map.empty()) made.layer_map = io.publish(layers.map);
  if (layers.chunks.empty()) return;
  for (const LayerChunk& chunk : layers.chunks) {
    made.layers[chunk.path.heap] = io.publish(layer_chunk_to_bytes(chunk));
  }
  made.layer_table = io.publish(layer_table(layers.chunks, layers.top_nodes));
  if (layers.top_heights.empty()) return;
  made.top_heights = io.publish(top_heights_to_bytes(layers.top_heights));
}

static_assert(most_subdomains == most_parts);

/// Each is a sub-domain of its own, if not several.
void require_few(std::int32_t regions) {
  if (regions <= most_subdomains) return;
  throw UsageError("it has " + std::to_string(regions) + " regions, and a job has at most " +
                       std::to_string(most_subdomains) + " sub-domains",
                   "the surface");
}

}  // namespace

JobFile mesh_settings_of(const JobFile& job) {
  const JobFile defaults;
  JobFile settings = job;
  settings.name = "settings";
  settings.surface = "surface";
  settings.remeshing = defaults.remeshing;
  settings.regions = defaults.regions;
  settings.max_elements = defaults.max_elements;
  settings.subdomains = defaults.subdomains;
  settings.target_elements = defaults.target_elements;
  settings.max_memory_bytes = defaults.max_memory_bytes;
  settings.groups = defaults.groups;
  settings.assimilate_method = defaults.assimilate_method;
  settings.across_cuts = defaults.across_cuts;
  settings.min_dihedral_deg = defaults.min_dihedral_deg;
  settings.min_unforced_dihedral_deg = defaults.min_unforced_dihedral_deg;
  settings.formats = defaults.formats;
  settings.keep = defaults.keep;
  settings.layers = defaults.layers;
  settings.patches = defaults.patches;
  settings.symmetry = defaults.symmetry;
  settings.pml = defaults.pml;
  settings.scale = defaults.scale;
  settings.unit = defaults.unit;
  return settings;
}

std::int64_t wanted_parts(const JobFile& job, double elements, std::int32_t regions) {
  TF_CHECK(regions >= 1);
  if (job.subdomains > 0) return std::max<std::int64_t>(job.subdomains, regions);
  const double by_size = std::ceil(elements / target_elements(job, elements));
  const auto groups = static_cast<double>(job.groups);
  const double to_assimilate =
      std::min(leaves_in_group * groups, std::max(groups, elements / least_leaf_elements));
  const double wanted = std::max(by_size, to_assimilate);
  return static_cast<std::int64_t>(
      std::clamp(wanted, static_cast<double>(regions), static_cast<double>(most_parts)));
}

std::int64_t parts_of_job(const JobFile& job, const SubdomainSize& root, std::int32_t regions) {
  if (job.max_memory_bytes == 0) return wanted_parts(job, root.elements, regions);
  return std::max<std::int64_t>(regions,
                                parts_for_memory(root, static_cast<double>(job.max_memory_bytes)));
}

void require_room(const JobFile& job, double input_bytes, const SubdomainSize& root) {
  if (job.max_memory_bytes == 0) return;
  const auto most_bytes = static_cast<double>(job.max_memory_bytes);
  double least = least_memory(input_bytes, root);
  if (job.across_cuts && most_bytes >= least) {
    const auto parts = static_cast<double>(parts_for_memory(root, most_bytes));
    const double triangles = triangles_of_leaves(root, parts);
    if (parts > 1) least = order_cost(triangles, triangles / parts).bytes;
  }
  if (most_bytes >= least) return;
  throw UsageError("this surface needs at least " + std::to_string(std::llround(least / 1e6)) +
                       "MB however finely it is cut: to check it, make the first cuts, order the "
                       "sub-domains and assemble the mesh",
                   "[decompose] max_memory");
}

namespace {

/// Made by this program: its defects are ours.
CheckedInput remeshed_input(TaskIo& io, const JobFile& job, const TaskFile& file) {
  io.progress().begin(WorkStage::read);
  const SurfaceMesh surface = surface_from_bytes(io.read(file), "the remeshed surface");
  io.progress().begin(WorkStage::check);
  CheckedInput input{check_surface(surface, region_rules_of(job)), static_cast<double>(file.size)};
  const std::vector<SurfaceDefect>& defects = input.checked.report.defects;
  if (defects.empty()) return input;
  throw OwnDefect("the remeshed surface is not sound: " + defects.front().message, {});
}

CheckedInput surface_of(TaskIo& io, const JobFile& job, const InspectGiven& given) {
  if (given.remeshed_surface) return remeshed_input(io, job, *given.remeshed_surface);
  if (!given.input_surface) throw OwnDefect("the job has no surface", {});
  return checked_input(io, job, *given.input_surface);
}

}  // namespace

void inspect_task(TaskIo& io) {
  const auto given = io.given<InspectGiven>();
  const JobFile job = parse_job_file(io.read(given.job), "job.toml");
  auto [checked, input_bytes] = surface_of(io, job, given);
  io.progress().begin(WorkStage::spacing);
  const JobDomain domain = domain_of_job(job, checked.surface);
  std::string spacing_bytes = domain.spacing.to_bytes();
  const SubdomainSize size{
      domain.elements, static_cast<double>(domain.root.triangles.size()),
      static_cast<double>(spacing_bytes.size()),
      static_cast<double>(needle_count(domain.root.vertices, domain.root.triangles))};
  require_room(job, input_bytes, size);
  auto wall = domain.layers ? domain.layers->coverage.wall_triangles : 0;
  if (domain.layers && domain.layers->pml) wall += domain.layers->pml->triangles;
  report_cost(io, inspect_cost(input_bytes, size, static_cast<double>(wall)));
  report_numbers(io, domain, checked.report);
  const std::int32_t regions = region_count(domain.surface);
  require_few(regions);
  const std::int64_t parts = parts_of_job(job, size, regions);
  JobForecast forecast = forecast_of(job, input_bytes, size, static_cast<double>(parts));
  if (domain.layers) add_layers(*domain.layers, forecast);
  require_disk(job, forecast,
               limits_of_job(job, checked.surface, domain.volume,
                             static_cast<double>(given.free_bytes.value_or(0))));
  report_forecast(io, forecast);
  checked = CheckedSurface{};  // what is published is made in memory beside the domain
  InspectMade made;
  made.spacing = io.publish(std::exchange(spacing_bytes, {}));
  made.surface = io.publish(surface_to_bytes(domain.surface));
  made.root = io.publish(subdomain_to_bytes(domain.root));
  made.settings = io.publish(to_toml(mesh_settings_of(job)));
  made.parts = static_cast<std::uint64_t>(parts);
  made.total_work = domain.elements;
  made.groups = static_cast<std::uint64_t>(job.groups);
  made.most_bytes = static_cast<std::uint64_t>(job.max_memory_bytes);
  made.needles = static_cast<std::uint64_t>(size.needles);
  made.across_cuts = job.across_cuts;
  if (domain.layers) {
    if (!job.layers.empty()) report_layers(io, *domain.layers);
    report_planes(io, domain.layers->planes);
    if (domain.layers->pml) report_pml(io, *domain.layers->pml);
    publish_layers(io, *domain.layers, made);
    io.number("estimated_elements", domain.all_elements());
  }
  io.made(made);
}

}  // namespace tetfarm
