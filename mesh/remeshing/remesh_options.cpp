#include "mesh/remeshing/remesh_options.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "mesh/spacing/sources.h"
#include "mesh/spacing/triangle_demands.h"

namespace tetfarm {
namespace {

constexpr double size_share = 1.0 / 20;
constexpr double min_size_share = 1.0 / 16;
constexpr double tolerance_share = 1e-3;

void check_length(double value, const std::string& option) {
  if (!(value >= 0) || !std::isfinite(value)) {
    throw UsageError("must be a length, and positive", option);
  }
}

}  // namespace

RemeshOptions with_defaults(RemeshOptions options, const SurfaceMesh& surface) {
  check_length(options.size, "--size");
  check_length(options.min_size, "--min-size");
  check_length(options.tolerance, "--tolerance");
  if (!(options.angle_deg > 0 && options.angle_deg < 180)) {
    throw UsageError("must lie between 0 and 180 degrees", "--angle");
  }
  if (!(options.growth > 0) || !std::isfinite(options.growth)) {
    throw UsageError("must be positive", "--growth");
  }
  const double diagonal = norm(bounding_box(surface.vertices).size());
  if (options.size == 0) options.size = std::max(size_share * diagonal, options.min_size);
  if (options.min_size == 0) options.min_size = min_size_share * options.size;
  if (options.min_size > options.size) {
    throw UsageError("is larger than --size", "--min-size");
  }
  if (options.tolerance == 0) {
    options.tolerance = tolerance_share * diagonal;
    options.has_local_tolerance = true;
  }
  check_sources(options.sources);
  check_triangle_demands(options.triangles);
  return options;
}

}  // namespace tetfarm
