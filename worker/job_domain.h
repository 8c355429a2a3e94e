/// The domain of a job before it is cut: its boundary, its spacing, and how many elements it will
/// have.
///
/// Source: thesis 4.3.1.9; 4.4, where layers are grown before the rest is meshed. Shared by the
/// task `inspect` and by the commands that tell what a job would come to. What cannot be meshed
/// within the job's limit is found out from a sketch of the outer boundary: a fine one may be
/// larger than the memory.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <string>

#include "mesh/core/subdomain.h"
#include "mesh/core/surface_mesh.h"
#include "mesh/inspect/outer_boundary.h"
#include "mesh/job_file/job_file.h"
#include "mesh/layers/layer_chunks.h"
#include "mesh/layers/layer_coverage.h"
#include "mesh/layers/plane_retreat.h"
#include "mesh/layers/top_heights.h"
#include "mesh/spacing/spacing_field.h"
#include "worker/job_forecast.h"
#include "worker/job_pml.h"

namespace tetfarm {

/// The layers that grow in a domain.
struct DomainLayers {
  std::vector<LayerChunk> chunks;  ///< none where nothing grows
  std::int64_t top_nodes = 0;
  std::vector<TopHeight> top_heights;
  std::int64_t cells = 0;
  LayerCoverage coverage;  ///< of boundary layers alone
  std::string map;         ///< for people: layer_map_vtp; empty without boundary layers
  std::optional<PmlFigures> pml = {};
  RetreatFigures planes = {};  ///< none where layers run in no plane
};

struct JobDomain {
  /// With the outer boundary, which is that of absorbing layers, and with planes that begin where
  /// layers end: what is between is the layers' sides.
  SurfaceMesh surface;
  // Of what the layers leave:
  SpacingField spacing;
  Subdomain root;
  double elements = 0;  ///< estimated
  double volume = 0;    ///< of all that is meshed, layers included
  /// Nothing where the job asks for none.
  std::optional<DomainLayers> layers = {};

  double all_elements() const {
    return elements + (layers ? static_cast<double>(layers->cells) : 0);
  }
};

/// What the layers add to what a job will come to.
void add_layers(const DomainLayers& layers, JobForecast& forecast);

/// The job's words in the terms of the mesh rooms. @throws UsageError for an unknown outer
/// boundary.
OuterBoundary outer_boundary_of(const JobFile& job);
/// The same of a checked surface, which has it already where the job has a plane of symmetry.
OuterBoundary outer_boundary_to_add(const JobFile& job);
/// But for what its patches ask for.
SpacingOptions spacing_options_of(const JobFile& job);
/// All of it. @param checked the surface of check_surface_of_job, or what it is remeshed to.
SpacingOptions spacing_options_of(const JobFile& job, const SurfaceMesh& checked);

/// @pre `checked` is a surface without defects. @throws UsageError when it would have more elements
/// than the job may have, when layers are to grow in several regions, or as add_outer_boundary and
/// layer_requests_of, pml_block_of and require_patch_sizes do; InvalidInput as make_spacing_field
/// does. Cost: that of the spacing field, twice when the outer boundary is large, once more with
/// layers, and theirs (plan_layers); nine times as much when the job is refused.
JobDomain domain_of_job(const JobFile& job, const SurfaceMesh& checked);

/// For require_disk: the domain's volume, and what a coarser job would come to.
/// @pre job and `checked` outlive the result.
JobLimits limits_of_job(const JobFile& job, const SurfaceMesh& checked, double volume,
                        double free_bytes);

}  // namespace tetfarm
