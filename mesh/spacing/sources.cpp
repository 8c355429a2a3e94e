#include "mesh/spacing/sources.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/check.h"
#include "base/error.h"
#include "mesh/spacing/exp_fixed.h"

namespace tetfarm {
namespace {

bool positive(double x) { return x > 0 && std::isfinite(x); }

NearestOnSource at_weights(const Source& source, const Vec3& point, std::array<double, 3> weight) {
  Vec3 nearest;
  for (std::size_t k = 0; k < source.corners.size(); ++k) {
    nearest += weight[k] * source.corners[k].at;
  }
  return {weight, distance(nearest, point)};
}

NearestOnSource nearest_on_edge(const Source& source, const Vec3& point, std::size_t a,
                                std::size_t b) {
  const Vec3 along = source.corners[b].at - source.corners[a].at;
  const double length2 = norm2(along);
  double t = length2 > 0 ? dot(point - source.corners[a].at, along) / length2 : 0;
  t = std::clamp(t, 0.0, 1.0);
  std::array<double, 3> weight{};
  weight[a] = 1 - t;
  weight[b] = t;
  return at_weights(source, point, weight);
}

NearestOnSource nearest_on_triangle(const Source& source, const Vec3& point) {
  const Vec3& a = source.corners[0].at;
  const Vec3& b = source.corners[1].at;
  const Vec3& c = source.corners[2].at;
  const Vec3 normal = cross(b - a, c - a);
  const double area2 = norm2(normal);
  if (area2 > 0) {
    const double u = dot(cross(c - b, point - b), normal) / area2;
    const double v = dot(cross(a - c, point - c), normal) / area2;
    const double w = dot(cross(b - a, point - a), normal) / area2;
    if (u >= 0 && v >= 0 && w >= 0) return at_weights(source, point, {u, v, w});
  }
  NearestOnSource best = nearest_on_edge(source, point, 0, 1);
  for (const auto& other :
       {nearest_on_edge(source, point, 1, 2), nearest_on_edge(source, point, 2, 0)}) {
    if (other.distance < best.distance) best = other;
  }
  return best;
}

/// All corners have the same parameters.
NearestOnSource nearest_on_box(const Source& source, const Vec3& point) {
  const Vec3& a = source.corners[0].at;
  const Vec3& b = source.corners[1].at;
  Vec3 nearest;
  for (int axis = 0; axis < 3; ++axis) {
    nearest[axis] = std::clamp(point[axis], std::min(a[axis], b[axis]), std::max(a[axis], b[axis]));
  }
  return {{1, 0, 0}, distance(nearest, point)};
}

/// In the half plane through the axis and the point a cylinder or a cone is a convex quadrangle:
/// (0, 0), (length, 0), (length, radii[1]), (0, radii[0]).
NearestOnSource nearest_on_cylinder(const Source& source, const Vec3& point) {
  const Vec3 axis = source.corners[1].at - source.corners[0].at;
  const double length = norm(axis);
  TF_CHECK(length > 0);
  const Vec3 direction = (1 / length) * axis;
  const Vec3 from_end = point - source.corners[0].at;
  const double along = dot(from_end, direction);
  const double away = norm(from_end - along * direction);
  const double slope = source.radii[1] - source.radii[0];
  const double radius_here = source.radii[0] + along / length * slope;
  if (along >= 0 && along <= length && away <= radius_here) return {{1, 0, 0}, 0};
  const auto off_disc = [&](double height, double radius) {
    const double beyond = std::max(0.0, away - radius);
    return std::sqrt((along - height) * (along - height) + beyond * beyond);
  };
  const double off_ends = std::min(off_disc(0, source.radii[0]), off_disc(length, source.radii[1]));
  const double side = length * length + slope * slope;
  const double t = std::clamp((along * length + (away - source.radii[0]) * slope) / side, 0.0, 1.0);
  const double off_along = along - t * length;
  const double off_away = away - source.radii[0] - t * slope;
  const double off_side = std::sqrt(off_along * off_along + off_away * off_away);
  return {{1, 0, 0}, std::min(off_ends, off_side)};
}

/// What a box or a cylinder must be. @throws InvalidInput.
void check_solid(const Source& source, const std::string& where) {
  if (source.corners.size() != 2) {
    throw InvalidInput(
        "a box or a cylinder must have 2 corners, not " + std::to_string(source.corners.size()),
        where);
  }
  if (source.shape != SourceShape::cylinder) return;
  if (!positive(distance(source.corners[0].at, source.corners[1].at))) {
    throw InvalidInput("the ends of the axis are the same point", where);
  }
  const double least = std::min(source.radii[0], source.radii[1]);
  const double most = std::max(source.radii[0], source.radii[1]);
  if (!(least >= 0) || !positive(most)) {
    throw InvalidInput("the radius of the cylinder is not positive", where);
  }
}

}  // namespace

void check_sources(const std::vector<Source>& sources) {
  for (std::size_t s = 0; s < sources.size(); ++s) {
    const std::string where = "source " + std::to_string(s + 1);
    const auto& corners = sources[s].corners;
    if (corners.empty() || corners.size() > 3) {
      throw InvalidInput(
          "a source must have 1, 2 or 3 corners, not " + std::to_string(corners.size()), where);
    }
    const bool is_solid = sources[s].shape != SourceShape::hull;
    if (is_solid) check_solid(sources[s], where);
    for (const SourceCorner& corner : corners) {
      if (!std::isfinite(corner.at.x + corner.at.y + corner.at.z)) {
        throw InvalidInput("the position is not finite", where);
      }
      if (!positive(corner.spacing)) throw InvalidInput("the spacing is not positive", where);
      const bool has_inner =
          positive(corner.inner_radius) || (is_solid && corner.inner_radius == 0);
      if (!has_inner || !positive(corner.outer_radius)) {
        throw InvalidInput("a radius is not positive", where);
      }
      if (corner.outer_radius < corner.inner_radius) {
        throw InvalidInput("the outer radius is smaller than the inner radius", where);
      }
    }
  }
}

SourceDemand source_demand(const Source& source, double growth) {
  TF_CHECK(!source.corners.empty());
  SourceDemand demand;
  demand.source = source;
  for (SourceCorner& corner : demand.source.corners) {
    for (const SourceCorner& other : source.corners) {
      corner.spacing =
          std::min(corner.spacing, other.spacing + growth * distance(corner.at, other.at));
    }
  }
  demand.floor = demand.source.corners.front();
  for (const SourceCorner& corner : demand.source.corners) {
    const SourceCorner& first = demand.source.corners.front();
    demand.varies = demand.varies || corner.spacing != first.spacing ||
                    corner.inner_radius != first.inner_radius ||
                    corner.outer_radius != first.outer_radius;
    demand.floor.spacing = std::min(demand.floor.spacing, corner.spacing);
    demand.floor.inner_radius = std::max(demand.floor.inner_radius, corner.inner_radius);
    demand.floor.outer_radius = std::max(demand.floor.outer_radius, corner.outer_radius);
  }
  return demand;
}

NearestOnSource nearest_on_source(const Source& source, const Vec3& point) {
  if (source.shape == SourceShape::box) return nearest_on_box(source, point);
  if (source.shape == SourceShape::cylinder) return nearest_on_cylinder(source, point);
  if (source.corners.size() == 1) return at_weights(source, point, {1, 0, 0});
  if (source.corners.size() == 2) return nearest_on_edge(source, point, 0, 1);
  TF_CHECK(source.corners.size() == 3);
  return nearest_on_triangle(source, point);
}

double source_law(const SourceCorner& parameters, double r, double background, double growth) {
  const double spacing = parameters.spacing;
  const double inner = parameters.inner_radius;
  const double outer = parameters.outer_radius;
  if (r <= inner) return spacing;
  const double target = background > 0 ? background : 2 * spacing;
  if (target <= spacing) return spacing;
  const double linear = spacing + growth * (r - inner);
  if (outer <= inner) return linear;
  const double rate = log_fixed(target / spacing) / (outer - inner);
  if (spacing * rate >= growth) return linear;
  double decay_end = inner + log_fixed(growth / (spacing * rate)) / rate;
  decay_end = std::min(decay_end, outer);
  if (r <= decay_end) return spacing * exp_fixed(rate * (r - inner));
  return spacing * exp_fixed(rate * (decay_end - inner)) + growth * (r - decay_end);
}

SourceValue source_value(const SourceDemand& demand, const Vec3& point, double radius,
                         double background, double growth) {
  const NearestOnSource nearest = nearest_on_source(demand.source, point);
  SourceValue value;
  value.floor =
      source_law(demand.floor, std::max(0.0, nearest.distance - radius), background, growth);
  SourceCorner here;
  for (std::size_t k = 0; k < demand.source.corners.size(); ++k) {
    const SourceCorner& corner = demand.source.corners[k];
    here.spacing += nearest.weight[k] * corner.spacing;
    here.inner_radius += nearest.weight[k] * corner.inner_radius;
    here.outer_radius += nearest.weight[k] * corner.outer_radius;
  }
  value.asked = source_law(here, nearest.distance, background, growth);
  return value;
}

}  // namespace tetfarm
