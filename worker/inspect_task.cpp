#include "worker/inspect_task.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "mesh/decompose/planar_cut.h"
#include "mesh/io/artifact_file.h"
#include "mesh/io/gzip.h"
#include "mesh/io/read_surface.h"
#include "worker/evidence.h"

namespace tetfarm {
namespace {

/// Above this the decomposition tree would be deeper than its heap numbers reach.
constexpr double most_parts = 1e6;
/// Leaves to be assimilated, when their number is left to us: as many to a group as the thesis has
/// (128 to 8), but none of a few hundred elements.
constexpr double leaves_in_group = 16;
constexpr double least_leaf_elements = 1000;

void report_numbers(TaskIo& io, const SurfaceMesh& surface, const SurfaceReport& report) {
  io.number("input_triangles", static_cast<double>(surface.triangles.size()));
  io.number("shells", static_cast<double>(report.shells.size()));
  io.number("input_smallest_angle_deg", report.smallest_angle_deg);
  io.number("domain_volume", domain_volume(surface));
  io.number("regions", region_count(surface));
  std::string remarks;
  for (const std::string& remark : report.remarks) remarks += remark + "\n";
  if (!remarks.empty()) io.text("remarks", remarks);
}

/// A file that the coordinator took as it was may be packed.
std::string unpacked(std::string bytes) {
  return is_gzip(bytes) ? unpack_gzip(bytes, "input_surface") : std::move(bytes);
}

}  // namespace

OuterBoundary outer_boundary_of(const JobFile& job) {
  OuterBoundary outer;
  if (job.outer_kind == "box") {
    outer.kind = OuterBoundary::Kind::box;
  } else if (job.outer_kind == "sphere") {
    outer.kind = OuterBoundary::Kind::sphere;
  } else if (job.outer_kind != "none") {
    throw UsageError("unknown outer boundary \"" + job.outer_kind + "\"", "[domain] outer");
  }
  outer.factor = job.outer_factor;
  outer.spacing = job.outer_spacing;
  return outer;
}

SpacingOptions spacing_options_of(const JobFile& job) {
  if (!job.sources_file.empty()) {
    throw UsageError("sources of another file must be in the job when it is submitted",
                     job.sources_file);
  }
  SpacingOptions options;
  options.background = job.spacing_default;
  options.growth = job.growth;
  options.inherit_surface = job.inherit_surface;
  for (const JobSource& source : job.sources) {
    Source& added = options.sources.emplace_back();
    for (const JobSource::Corner& corner : source.corners) {
      added.corners.push_back({.at = corner.at,
                               .spacing = corner.spacing,
                               .inner_radius = corner.inner,
                               .outer_radius = corner.outer});
    }
  }
  return options;
}

RegionRules region_rules_of(const JobFile& job) {
  RegionRules rules;
  rules.is_outside_meshed = job.outer_kind != "none";
  for (const JobRegion& region : job.regions) {
    rules.wishes.push_back({region.at, region.name, region.is_void});
  }
  return rules;
}

JobFile mesh_settings_of(const JobFile& job) {
  const JobFile defaults;
  JobFile settings = job;
  settings.name = "settings";
  settings.surface = "surface";
  settings.regions = defaults.regions;
  settings.subdomains = defaults.subdomains;
  settings.target_elements = defaults.target_elements;
  settings.max_memory_bytes = defaults.max_memory_bytes;
  settings.groups = defaults.groups;
  settings.assimilate_method = defaults.assimilate_method;
  settings.across_cuts = defaults.across_cuts;
  settings.min_dihedral_deg = defaults.min_dihedral_deg;
  settings.formats = defaults.formats;
  return settings;
}

std::int64_t wanted_parts(const JobFile& job, double elements, std::int32_t regions) {
  if (job.subdomains > 0) return std::max<std::int64_t>(job.subdomains, regions);
  const double by_size = std::ceil(elements / static_cast<double>(job.target_elements));
  const auto groups = static_cast<double>(job.groups);
  const double to_assimilate =
      std::min(leaves_in_group * groups, std::max(groups, elements / least_leaf_elements));
  const double wanted = std::max(by_size, to_assimilate);
  return static_cast<std::int64_t>(std::clamp(wanted, static_cast<double>(regions), most_parts));
}

void require_room(const JobFile& job, double input_bytes, const SubdomainSize& root) {
  if (job.max_memory_bytes == 0) return;
  const auto most_bytes = static_cast<double>(job.max_memory_bytes);
  double least = least_memory(input_bytes, root);
  if (job.across_cuts && most_bytes >= least) {
    const auto parts = static_cast<double>(parts_for_memory(root, most_bytes));
    if (parts > 1) least = order_cost(triangles_of_leaves(root, parts)).bytes;
  }
  if (most_bytes >= least) return;
  throw UsageError("this surface needs at least " + std::to_string(std::llround(least / 1e6)) +
                       "MB, however finely it is cut: to be checked, cut at first, put in order, "
                       "and assembled",
                   "[decompose] max_memory");
}

std::string defect_message(const std::vector<SurfaceDefect>& defects) {
  std::string message = "the surface cannot be meshed";
  for (const SurfaceDefect& defect : defects) {
    message += "\n  " + defect.kind + ": " + defect.message;
  }
  return message;
}

void inspect_task(TaskIo& io) {
  const JobFile job = parse_job_file(io.read("job"), "job.toml");
  io.progress("read", 0);
  const std::string input = unpacked(io.read("input_surface"));
  const auto input_bytes = static_cast<double>(input.size());
  SurfaceMesh surface = read_surface_bytes(input, job.surface);
  io.progress("check", 0);
  CheckedSurface checked = check_surface(surface, region_rules_of(job));
  if (!checked.report.defects.empty()) {
    const std::string defects = defects_as_vtp(io.store(), surface, checked.report.defects);
    throw RefusedInput(defect_message(checked.report.defects),
                       {{job.name + ".defects.vtp", defects}});
  }
  const OuterBoundary outer = outer_boundary_of(job);
  surface = outer.kind == OuterBoundary::Kind::none
                ? std::move(checked.surface)
                : add_outer_boundary(checked.surface, outer, job.growth);
  io.progress("spacing", 0);
  const SpacingField spacing = make_spacing_field(surface, spacing_options_of(job));
  const Subdomain root = root_subdomain(surface);
  const double elements = estimated_elements(root, spacing);
  const std::string spacing_bytes = spacing.to_bytes();
  const SubdomainSize size{elements, static_cast<double>(root.triangles.size()),
                           static_cast<double>(spacing_bytes.size())};
  require_room(job, input_bytes, size);
  report_cost(io, inspect_cost(input_bytes, size.triangles, size.spacing_bytes));
  report_numbers(io, surface, checked.report);
  io.number("total_work", elements);
  const std::int32_t regions = region_count(surface);
  const auto most_bytes = static_cast<double>(job.max_memory_bytes);
  const std::int64_t parts =
      most_bytes > 0 ? std::max<std::int64_t>(regions, parts_for_memory(size, most_bytes))
                     : wanted_parts(job, elements, regions);
  io.number("parts", static_cast<double>(parts));
  io.number("most_bytes", most_bytes);
  io.number("groups", static_cast<double>(job.groups));
  io.number("across_cuts", job.across_cuts ? 1 : 0);
  io.publish("surface", surface_to_bytes(surface));
  io.publish("spacing", spacing_bytes);
  io.publish("root", subdomain_to_bytes(root));
  io.publish("settings", to_toml(mesh_settings_of(job)));
}

}  // namespace tetfarm
