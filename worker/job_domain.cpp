#include "worker/job_domain.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "base/error.h"
#include "mesh/core/complaints.h"
#include "mesh/decompose/planar_cut.h"
#include "mesh/inspect/region_map.h"
#include "mesh/layers/pml_blocks.h"
#include "mesh/layers/unlayered_domain.h"
#include "worker/job_layers.h"
#include "worker/job_patch_sizes.h"
#include "worker/job_patch_types.h"
#include "worker/patch_globs.h"

namespace tetfarm {
namespace {

JobDomain domain_inside(SurfaceMesh surface, const SpacingOptions& options) {
  SpacingField spacing = make_spacing_field(surface, options);
  Subdomain root = root_subdomain(surface);
  const double elements = estimated_elements(root, spacing);
  const double volume = domain_volume(surface);
  return {std::move(surface), std::move(spacing), std::move(root), elements, volume, std::nullopt};
}

JobDomain sketched_domain(const JobFile& job, const SurfaceMesh& checked) {
  OuterBoundary outer = outer_boundary_to_add(job);
  outer.is_sketch = true;
  return domain_inside(add_outer_boundary(checked, outer, job.growth),
                       spacing_options_of(job, checked));
}

}  // namespace

void add_layers(const DomainLayers& layers, JobForecast& forecast) {
  add_layers(static_cast<double>(layers.cells), static_cast<double>(layers.chunks.size()),
             forecast);
}

OuterBoundary outer_boundary_to_add(const JobFile& job) {
  OuterBoundary outer = outer_boundary_of(job);
  if (job.symmetry) outer.kind = OuterBoundary::Kind::none;
  return outer;
}

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
  outer.default_spacing = job.spacing_default;
  return outer;
}

namespace {

SourceShape shape_of(const JobSource& source) {
  switch (source.shape) {
    case JobSource::Shape::box:
      return SourceShape::box;
    case JobSource::Shape::cylinder:
      return SourceShape::cylinder;
    default:
      return SourceShape::hull;
  }
}

}  // namespace

SpacingOptions spacing_options_of(const JobFile& job) {
  if (!job.sources_file.empty()) {
    throw UsageError("the sources of this file must be in the job itself when it is submitted",
                     job.sources_file);
  }
  SpacingOptions options;
  options.background = job.spacing_default;
  options.growth = job.growth;
  options.inherit_surface = job.inherit_surface;
  for (const JobSource& source : job.sources) {
    Source& added = options.sources.emplace_back();
    added.shape = shape_of(source);
    added.radii = source.radii;
    for (const JobSource::Corner& corner : source.corners) {
      added.corners.push_back({.at = corner.at,
                               .spacing = corner.spacing,
                               .inner_radius = corner.inner,
                               .outer_radius = corner.outer});
    }
  }
  return options;
}

SpacingOptions spacing_options_of(const JobFile& job, const SurfaceMesh& checked) {
  SpacingOptions options = spacing_options_of(job);
  if (!job.patches.empty()) {
    options.triangles = patch_demands(job, checked, own_patch_names(job, checked));
  }
  return options;
}

JobLimits limits_of_job(const JobFile& job, const SurfaceMesh& checked, double volume,
                        double free_bytes) {
  const auto elements_with = [&job, &checked](double size) {
    JobFile coarser = job;
    coarser.spacing_default = size;
    return sketched_domain(coarser, checked).elements;
  };
  return {volume, elements_with, free_bytes};
}

namespace {

/// That of the job but for its layers.
JobDomain domain_without_layers(const JobFile& job, const SurfaceMesh& checked) {
  JobDomain sketch = sketched_domain(job, checked);
  require_few_elements(job, sketch.elements, limits_of_job(job, checked, sketch.volume, 0));
  const OuterBoundary outer = outer_boundary_to_add(job);
  if (outer.kind == OuterBoundary::Kind::none) return sketch;
  SurfaceMesh surface = add_outer_boundary(checked, outer, job.growth);
  if (surface.triangles.size() == sketch.surface.triangles.size()) return sketch;
  return domain_inside(std::move(surface), spacing_options_of(job, checked));
}

/// Layers grow behind the triangles of a surface that bounds one region.
void require_one_region(const JobFile& job, const SurfaceMesh& surface) {
  const auto other =
      std::find_if(surface.sides.begin(), surface.sides.end(), [](const Sides& sides) {
        return sides != Sides{1, 0};
      });
  if (other == surface.sides.end()) return;
  const auto triangle = static_cast<std::size_t>(other - surface.sides.begin());
  const std::string where =
      "triangle " + std::to_string(triangle) + " at " +
      text_of(surface.vertices[static_cast<std::size_t>(surface.triangles[triangle][0])]);
  const bool is_within = (*other)[0] == (*other)[1];
  const std::string what =
      is_within ? "and " + where +
                      " lies within the domain, which is on both of its sides; leave "
                      "it out, or the layers"
                : "and this one bounds " + std::to_string(region_count(surface)) + ", as " + where +
                      " shows; mesh its regions as surfaces of their own, or leave out the layers";
  throw UsageError("layers grow in a surface that bounds one region, " + what,
                   job.layers.empty() ? "[[pml]]" : "[[layers]]");
}

/// Of the walls of boundary layers alone: absorbing ones have all layers, or there is no plan.
LayerCoverage coverage_without(const std::vector<std::int32_t>& pml_patches,
                               const SurfaceMesh& surface, std::vector<WallLayers> walls) {
  std::erase_if(walls, [&](const WallLayers& wall) {
    return std::binary_search(pml_patches.begin(), pml_patches.end(),
                              patch_of(surface, static_cast<std::size_t>(wall.triangle)));
  });
  return coverage_of(walls);
}

LayerPlan plan_of(const SurfaceMesh& surface, const std::vector<LayerRequest>& requests) {
  if (!requests.empty()) return plan_layers(surface, requests);
  LayerPlan none;
  none.vertex2line.assign(surface.vertices.size(), -1);
  return none;
}

void add_layers(const JobFile& job, const SurfaceMesh& checked, JobDomain& domain) {
  const SurfaceMesh& surface = domain.surface;
  require_one_region(job, surface);
  std::vector<LayerRequest> requests = layer_requests_of(job, surface);
  DomainLayers layers;
  std::vector<std::int32_t> pml_patches;
  PmlBlocksRequest blocks;  // of absorbing layers that are planned behind the others
  if (job.pml) {
    PmlBlock block = has_pml_blocks(job) ? pml_blocks_of(job, surface) : pml_block_of(job, surface);
    require_few_elements(job, domain.elements + static_cast<double>(block.figures.cells()),
                         limits_of_job(job, checked, domain.volume, 0));
    layers.pml = std::move(block.figures);
    if (has_pml_blocks(job)) {
      blocks = request_of_blocks(block);
    } else {
      pml_patches = block.request.patches;
      requests.push_back(std::move(block.request));
      domain.surface = std::move(block.surface);
      domain.volume = domain_volume(domain.surface);
    }
  }
  LayerPlan plan = plan_of(surface, requests);
  const std::vector<WallLayers> walls = wall_layers(plan, surface);
  layers.coverage = coverage_without(pml_patches, surface, walls);
  if (!job.layers.empty()) layers.map = layer_map_vtp(walls, plan, surface);
  const SpacingOptions options = spacing_options_of(job, checked);
  std::optional<PlaneRetreat> retreat = retreat_planes(surface, plan, [&](const auto& round) {
    const auto field = std::make_shared<SpacingField>(make_spacing_field(round, options));
    return [field](const Vec3& place) { return field->at(place); };
  });
  if (retreat) {
    layers.planes = retreat->figures;
    plan = std::move(retreat->plan);
    domain.surface = std::move(retreat->surface);
  }
  if (has_pml_blocks(job)) {
    PmlBlocks grown = with_pml_blocks(surface, std::move(plan), blocks);
    plan = std::move(grown.plan);
    domain.surface = std::move(grown.surface);
    domain.volume = domain_volume(domain.surface);
  }
  layers.chunks = chunks_of(plan, surface);
  for (const LayerChunk& chunk : layers.chunks) layers.cells += counts_of(chunk).cells();
  if (!layers.chunks.empty()) {
    UnlayeredDomain rest = unlayered_domain(plan, surface, unlayered_path, top_of_layers);
    layers.top_nodes = rest.top_nodes;
    layers.top_heights = top_heights(plan, surface, rest);
    domain.root = std::move(rest.root);
    const SurfaceMesh boundary{domain.root.vertices, domain.root.triangles, {}, {}, {}, {}};
    domain.spacing = make_spacing_field(boundary, options);
    domain.elements = estimated_elements(domain.root, domain.spacing);
  }
  domain.layers = std::move(layers);
}

}  // namespace

JobDomain domain_of_job(const JobFile& job, const SurfaceMesh& checked) {
  require_patch_sizes(job, own_patch_names(job, checked));
  JobDomain domain = domain_without_layers(job, checked);
  require_patch_types(job, patch_names_of(domain.surface));
  if (job.layers.empty() && !job.pml) return domain;
  add_layers(job, checked, domain);
  require_few_elements(job, domain.all_elements(), limits_of_job(job, checked, domain.volume, 0));
  return domain;
}

}  // namespace tetfarm
