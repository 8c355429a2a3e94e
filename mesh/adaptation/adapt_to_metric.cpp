#include "mesh/adaptation/adapt_to_metric.h"

#include <cmath>
#include <utility>

#include "mesh/adaptation/checked_plane_mesh.h"

namespace tetfarm {
namespace {

constexpr int most_tries = 5;
constexpr double close_to_the_number = 0.02;

}  // namespace

AdaptedMesh adapt_to_metric(const PlaneMesh& mesh, const TriangleComplex& complex,
                            AdaptationWish wish, const AdaptationOptions& options) {
  check_metrics(mesh, wish.metrics, wish.metric_name);
  AdaptedMesh adapted;
  if (!wish.vertices.has_value()) {
    adapted.asked = limited_metric(complex, std::move(wish.metrics), wish.limits, options.sources);
    adapted.result =
        adapt_checked_mesh(mesh, complex, std::exchange(adapted.asked.metrics, {}), options);
    return adapted;
  }
  const auto wanted = static_cast<double>(*wish.vertices);
  double complexity = wanted / nodes_per_complexity;
  for (int i = 0; i < most_tries; ++i) {
    adapted.asked = scaled_to(complex, wish.metrics, wish.limits, complexity, options.sources);
    adapted.result =
        adapt_checked_mesh(mesh, complex, std::exchange(adapted.asked.metrics, {}), options);
    const double share = static_cast<double>(adapted.result.mesh.points.size()) / wanted;
    if (std::abs(share - 1) < close_to_the_number) break;
    complexity /= share;
  }
  return adapted;
}

}  // namespace tetfarm
