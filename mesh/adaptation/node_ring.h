/// The triangles round a node, with the places and metrics of the nodes opposite it side by side:
/// for trying many places of the node.
///
/// Source: none. Cost: O(triangles of the ball) to gather and for each place.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/adaptation/metric_mesh.h"

namespace tetfarm {

/// What the triangles of the ball would be with the node at a place.
struct RingEnergies {
  double sum = 0;  ///< infinite where one does not turn anticlockwise
  /// Every triangle turns anticlockwise, whatever the rounding; false leaves it open.
  bool is_certain = true;
};

class NodeRing {
 public:
  struct Place {
    Vec2 point;
    Metric2 metric;
    std::int32_t node = 0;
  };

  void gather(const MetricMesh& mesh, std::int32_t node);

  std::int32_t triangles() const { return static_cast<std::int32_t>(ball_.corners.size()); }
  std::int32_t triangle(std::int32_t k) const { return triangle_of(ball_.corners[at(k)]); }
  /// The nodes opposite, anticlockwise: triangle k has those from k to k + 1. Of a node inside the
  /// last is the first again.
  const std::vector<Place>& places() const { return places_; }

  /// What triangle k would be. `is_certain` becomes false where its turn is not.
  double energy(std::int32_t k, const NodePlace& place, bool& is_certain) const {
    const Place& b = places_[at(k)];
    const Place& c = places_[at(k) + 1];
    const Vec2 u{b.point.x - place.point.x, b.point.y - place.point.y};
    const Vec2 v{c.point.x - place.point.x, c.point.y - place.point.y};
    const double left = u.x * v.y;
    const double right = u.y * v.x;
    const double doubled = left - right;
    // Shewchuk's bound for orient2d() is 3.33e-16.
    is_certain = is_certain && doubled > 4e-16 * (std::abs(left) + std::abs(right));
    return energy_of_sides(u, v, doubled, sum_of(place.metric, sum_of(b.metric, c.metric)));
  }
  /// Of all of them; keeps each.
  RingEnergies energies_at(const NodePlace& place);
  /// Of the triangles as the mesh has them.
  double noted_sum(MetricMesh& mesh) const;
  /// Those of the last place become those of the mesh, whose triangles have changed.
  void note(MetricMesh& mesh) const;

  /// Exact: whether every triangle turns anticlockwise with the node at the point.
  bool sees_all(const MetricMesh& mesh, const Vec2& point) const {
    return sees_ball(mesh.complex, ball_, point);
  }
  /// The nodes opposite become active.
  void activate(MetricMesh& mesh) const;

 private:
  Ball ball_;
  std::vector<Place> places_;
  std::vector<double> energies_;
};

}  // namespace tetfarm
