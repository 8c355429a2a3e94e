/// Metric sources: points and lines round which a person says how long and how stretched triangles
/// are to be, and which way they lie.
///
/// Source: thesis 3.2.1 and 3.2.2 (two radii of an ellipse, its rotation, and one radius round the
/// source within which the metric is constant), 3.2.3 where sources overlap. Departs: beyond the
/// radius, where the thesis has nothing (figure 28), both sizes may grow, by the law of gradation:
/// at a way of metric length l from where the metric is constant they are 1 + l ln(growth) times as
/// large. Sizes never come to be above those of the background. Equation 10: see metric2.h.
/// Units: those of the mesh; angles in degrees, anticlockwise. Determinism: metrics are intersected
/// in the order of the sources, the background first. Cost: O(sources) for each point, some 20 ns
/// for one that does not act there.
#pragma once

#include <cstddef>
#include <vector>

#include "mesh/metric/metric2.h"

namespace tetfarm {

struct MetricSource {
  Vec2 from;         ///< of a line; where a point is
  Vec2 to;           ///< of a line; of a point as `from`
  double along = 1;  ///< size in the direction of the angle
  double across = 1;
  double angle_deg = 0;  ///< of a point from the x axis; of a line from the way it runs
  double radius = 1;     ///< within it the metric is constant
  double growth = 1.4;   ///< by which sizes grow from edge to edge beyond it; 0: it ends there
};

class MetricSources {
 public:
  /// @pre sizes and radii are positive; growth is 0 or above 1
  explicit MetricSources(const std::vector<MetricSource>& sources);

  std::size_t size() const { return sources_.size(); }

  /// What is asked for at a point where the background asks for `base`. `factor`: of the sources'
  /// metrics, whose lengths become longer by its square root; that of `base` is in it already.
  /// @pre is_metric(base)
  Metric2 at(const Vec2& point, const Metric2& base, double factor = 1) const;
  /// Whether a source asks there for more than the background.
  bool acts(std::size_t source, const Vec2& point, const Metric2& base) const;

  /// The same sources growing so slowly that edges which are measured at their ends notice what
  /// lies between these, however long they are.
  MetricSources noticeable() const;
  bool is_noticeable() const;

  /// How large pieces may be, round a point, over which what the sources ask for is summed.
  double piece_size(const Vec2& point) const;

 private:
  struct Source {
    Vec2 from;
    Vec2 way;  ///< to the other end
    double square = 0;
    Metric2 metric;
    double most = 0;  ///< eigenvalue of the metric
    double radius = 0;
    double slope = 0;  ///< logarithm of the growth; 0: none
    double finest = 0;
  };

  static Vec2 from_axis(const Source& source, const Vec2& point);
  static double coarsening(const Source& source, const Vec2& point);

  std::vector<Source> sources_;
};

}  // namespace tetfarm
