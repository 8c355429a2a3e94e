#include "mesh/adaptation/solution_metric.h"

#include <utility>

#include "base/check.h"
#include "mesh/adaptation/hessian_recovery.h"
#include "mesh/metric/metric_intersection.h"

namespace tetfarm {
namespace {

std::vector<Metric2> metrics_of_field(const TriangleComplex& complex,
                                      const std::vector<double>& values, bool is_alone,
                                      const SolutionMetricOptions& options) {
  const std::vector<Metric2> hessians = recover_hessians(
      complex, values,
      options.is_lp ? HessianRecovery::quadratic_fit : HessianRecovery::double_projection);
  if (!options.is_lp) return absolute(hessians);
  std::vector<Metric2> metrics = lp_metrics(hessians, options.norm);
  if (is_alone) return metrics;
  const double factor = 1 / complexity(complex, metrics);
  for (Metric2& m : metrics) m = factor * m;
  return metrics;
}

}  // namespace

std::vector<Metric2> metrics_of_solution(const TriangleComplex& complex,
                                         std::span<const std::vector<double>> fields,
                                         const SolutionMetricOptions& options) {
  TF_CHECK(!fields.empty());
  std::vector<Metric2> metrics;
  for (const std::vector<double>& values : fields) {
    std::vector<Metric2> of_field = metrics_of_field(complex, values, fields.size() == 1, options);
    if (metrics.empty()) {
      metrics = std::move(of_field);
      continue;
    }
    for (std::size_t v = 0; v < metrics.size(); ++v) {
      metrics[v] = intersection(metrics[v], of_field[v]);
    }
  }
  return metrics;
}

}  // namespace tetfarm
