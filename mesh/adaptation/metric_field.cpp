#include "mesh/adaptation/metric_field.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/adaptation/mesh_location.h"

namespace tetfarm {
namespace {

// A walk through a mesh without obtuse traps is far shorter; this only ends one that goes round.
constexpr int longest_walk = 100'000;

}  // namespace

MetricField::MetricField(std::shared_ptr<const TriangleComplex> background,
                         std::vector<Metric2> metrics, const SourcesOfField& sources)
    : background_(std::move(background)), logs_(std::move(metrics)), sources_(sources) {
  TF_CHECK(logs_.size() == background_->points.size());
  for (Metric2& m : logs_) m = log_of(m);
}

Metric2 MetricField::at(const Vec2& point, std::int32_t& home) const {
  std::array<double, 3> areas = walk_to(*background_, point, home, longest_walk);
  double sum = 0;
  for (double& area : areas) {
    area = std::max(area, 0.0);
    sum += area;
  }
  const TriangleComplex::Nodes& n = background_->nodes(home);
  Metric2 log{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    const Metric2& of_node = logs_[tetfarm::at(n[tetfarm::at(i)])];
    const double weight = sum > 0 ? areas[tetfarm::at(i)] / sum : 1.0 / 3;
    log.xx += weight * of_node.xx;
    log.xy += weight * of_node.xy;
    log.yy += weight * of_node.yy;
  }
  if (sources_.sources == nullptr) return exp_of(log);
  return sources_.sources->at(point, exp_of(log), sources_.factor);
}

}  // namespace tetfarm
