#include "cli/proposed_job.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/defect_text.h"
#include "worker/checked_input.h"
#include "worker/inspect_task.h"
#include "worker/job_domain.h"
#include "worker/job_remeshing.h"
#include "worker/job_surface.h"

namespace tetfarm {
namespace {

using EdgeLengths = std::vector<double>;

void add_edges(const SurfaceMesh& surface, std::size_t triangle, EdgeLengths& edges) {
  const Triangle& t = surface.triangles[triangle];
  for (std::size_t i = 0; i < 3; ++i) {
    edges.push_back(distance(surface.vertices[static_cast<std::size_t>(t[i])],
                             surface.vertices[static_cast<std::size_t>(t[(i + 1) % 3])]));
  }
}

double median_length(EdgeLengths edges) {
  if (edges.empty()) return 0;
  const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
  std::nth_element(edges.begin(), middle, edges.end());
  return *middle;
}

std::vector<ProposedPatch> patches_of(const SurfaceMesh& surface) {
  std::vector<std::string> names = surface.patch_names;
  if (names.empty()) names = {"surface"};
  std::vector<EdgeLengths> edges(names.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    add_edges(surface, t, edges[static_cast<std::size_t>(patch_of(surface, t))]);
  }
  std::vector<ProposedPatch> patches;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto triangles = static_cast<std::int64_t>(edges[i].size() / 3);
    patches.push_back({std::move(names[i]), triangles, median_length(std::move(edges[i]))});
  }
  return patches;
}

CheckedSurface checked_surface(const JobInput& input, const SurfaceMesh& surface) {
  CheckedSurface checked = check_surface(surface, region_rules_of(input.job));
  if (checked.report.defects.empty()) return checked;
  throw Error(ExitCode::bad_geometry, input.path + ": " + defects_text(checked.report.defects));
}

/// Of the triangles behind the first `before`, which the outer boundary added.
double longest_edge_behind(const SurfaceMesh& surface, std::size_t before) {
  EdgeLengths edges;
  for (std::size_t t = before; t < surface.triangles.size(); ++t) add_edges(surface, t, edges);
  return edges.empty() ? 0 : *std::max_element(edges.begin(), edges.end());
}

void measure_box(const JobInput& input, const SurfaceMesh& surface, ProposedJob& proposed) {
  JobInput boxed{input.job, input.path, {}};
  boxed.job.outer_kind = "box";
  boxed.job.outer_factor = default_outer_factor("box");
  const CheckedSurface checked = checked_surface(boxed, surface);
  const JobDomain domain = domain_of_job(boxed.job, checked.surface);
  proposed.elements_in_box = domain.elements;
  proposed.edge_of_box = longest_edge_behind(domain.surface, checked.surface.triangles.size());
}

}  // namespace

ProposedJob propose_job(const JobInput& input) {
  const SurfaceMesh surface = read_surface_of_job(input.job, input.surface, input.path);
  JobInput any{input.job, input.path, {}};
  any.job.max_elements = 0;  // the file says how many are too many
  const CheckedSurface checked = checked_surface(any, surface);
  ProposedJob proposed;
  proposed.name = input.job.name;
  proposed.surface = input.path;
  proposed.scale = input.job.scale;
  proposed.unit = input.job.unit;
  proposed.triangles = static_cast<std::int64_t>(surface.triangles.size());
  proposed.box = bounding_box(checked.surface.vertices);
  proposed.report = checked.report;
  proposed.patches = patches_of(surface);
  const JobDomain domain = domain_of_job(any.job, checked.surface);
  proposed.elements = domain.elements;
  proposed.subdomains = wanted_parts(any.job, domain.elements, region_count(domain.surface));
  measure_box(any, surface, proposed);
  any.job.remeshing.emplace();
  proposed.remeshing = remesh_options_of(any.job, checked.surface);
  return proposed;
}

}  // namespace tetfarm
