/// The background: the metric that is asked for at any point of the domain, frozen while the mesh
/// changes.
///
/// Source: thesis 3.3.1 (metrics at the nodes of the mesh of the solution). Departs: between nodes
/// the logarithms are interpolated linearly, so that no order of inputs matters and the density
/// stays between those of the nodes; nothing is taken from the mesh that is being changed. Sources,
/// where there are some, are not interpolated: they count at the point itself (3.2.2).
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "mesh/adaptation/metric_sources.h"
#include "mesh/metric/metric2.h"
#include "mesh/planar/plane_mesh.h"
#include "mesh/planar/triangle_complex.h"

namespace tetfarm {

/// What a field has beside the metrics of its nodes.
struct SourcesOfField {
  const MetricSources* sources = nullptr;  ///< that outlive the field; none
  double factor = 1;                       ///< of their metrics
};

class MetricField {
 public:
  /// `metrics` at the points of the triangles. @pre each is_metric; triangles are valid
  MetricField(std::shared_ptr<const TriangleComplex> background, std::vector<Metric2> metrics,
              const SourcesOfField& sources = {});
  MetricField(TriangleComplex background, std::vector<Metric2> metrics,
              const SourcesOfField& sources = {})
      : MetricField(std::make_shared<const TriangleComplex>(std::move(background)),
                    std::move(metrics), sources) {}

  /// The metric at a point; one outside gets that of the nearest place of the triangle where the
  /// walk ended. `home`: a triangle near the point; becomes the one that holds it.
  Metric2 at(const Vec2& point, std::int32_t& home) const;
  /// A triangle that holds the node of the background.
  std::int32_t home_of_node(std::int32_t node) const {
    return background_->node2triangle[static_cast<std::size_t>(node)];
  }
  const TriangleComplex& background() const { return *background_; }

 private:
  std::shared_ptr<const TriangleComplex> background_;
  std::vector<Metric2> logs_;
  SourcesOfField sources_;
};

}  // namespace tetfarm
