/// A surface remeshed as a user would have it, and what came of it.
#pragma once

#include <utility>
#include <vector>

#include "mesh/inspect/surface_check.h"
#include "mesh/remeshing/remesh.h"
#include "mesh/remeshing/remeshing_figures.h"

namespace tetfarm {

struct RemeshOutcome {
  SurfaceMesh input;
  RemeshedSurface result;
  RemeshingFigures figures;
  RemeshOptions options;
};

inline RemeshOutcome remesh_outcome(const SurfaceMesh& surface, RemeshOptions options) {
  RemeshOutcome outcome;
  outcome.input = check_surface(surface).surface;
  outcome.options = with_defaults(std::move(options), surface);
  const SurfaceFeatures features = surface_features(outcome.input, outcome.options.angle_deg);
  const RemeshingSpacing spacing = remeshing_spacing(outcome.input, features, outcome.options);
  outcome.result = remesh(outcome.input, features, spacing, outcome.options);
  outcome.figures = remeshing_figures(outcome.input, outcome.result, spacing);
  return outcome;
}

inline RemeshOutcome remesh_outcome(const SurfaceMesh& surface, double size) {
  RemeshOptions options;
  options.size = size;
  return remesh_outcome(surface, options);
}

inline std::vector<SurfaceDefect> defects_of_remeshed(SurfaceMesh surface) {
  surface.sides.clear();
  surface.region_names.clear();
  return check_surface(surface).report.defects;
}

/// A twelfth of the diagonal, and where it is narrow a quarter of that: few triangles.
inline RemeshOptions coarse_options(const SurfaceMesh& surface) {
  RemeshOptions options;
  options.size = norm(bounding_box(surface.vertices).size()) / 12;
  options.min_size = options.size / 4;
  return options;
}

}  // namespace tetfarm
