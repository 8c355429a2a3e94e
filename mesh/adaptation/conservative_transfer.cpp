#include "mesh/adaptation/conservative_transfer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/adaptation/mesh_intersection.h"
#include "mesh/adaptation/solution_interpolation.h"

namespace tetfarm {
namespace {

/// Less of a triangle than this is rounding, more than one minus this all of it.
constexpr double sliver_share = 1e-12;
constexpr double whole_share = 1e-9;

using NodeValues = std::array<double, 3>;

double area_of(const TriangleComplex& complex, std::int32_t t) {
  const TriangleComplex::Nodes& n = complex.nodes(t);
  const Vec2& a = complex.point(n[0]);
  const Vec2& b = complex.point(n[1]);
  const Vec2& c = complex.point(n[2]);
  return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

/// The gradient of a linear function times twice the area of its triangle.
Vec2 gradient_times_area(const TriangleComplex& complex, std::int32_t t, const NodeValues& values) {
  const TriangleComplex::Nodes& n = complex.nodes(t);
  const Vec2& a = complex.point(n[0]);
  const Vec2& b = complex.point(n[1]);
  const Vec2& c = complex.point(n[2]);
  const double ub = values[1] - values[0];
  const double uc = values[2] - values[0];
  return {ub * (c.y - a.y) - uc * (b.y - a.y), uc * (b.x - a.x) - ub * (c.x - a.x)};
}

/// What of a target triangle the background covers.
struct Cover {
  std::span<const IntersectionPiece> pieces;
  double area = 0;
  Vec2 moment;
};

struct LinearFunction {
  double mean = 0;
  NodeValues values{};
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
};

/// The values within the bounds, with the mean that they had.
void limit(LinearFunction& function) {
  const double low = function.low;
  const double high = function.high;
  const double mean = std::clamp(function.mean, low, high);
  double missing = 3 * mean;
  for (double& value : function.values) {
    value = std::clamp(value, low, high);
    missing -= value;
  }
  const double bound = missing > 0 ? high : low;
  double room = 0;
  for (const double value : function.values) room += std::abs(bound - value);
  if (room == 0) return;
  const double part = std::min(std::abs(missing) / room, 1.0);
  for (double& value : function.values) value += part * (bound - value);
}

class ConservativePass {
 public:
  ConservativePass(const MeshLocation& background, std::span<const std::vector<double>> fields,
                   const TriangleComplex& target, std::span<const PlaneLocation> places)
      : background_(background),
        old_(background.complex()),
        fields_(fields),
        target_(target),
        places_(places),
        intersection_(old_, target),
        areas_at_(target.points.size(), 0) {
    for (const std::vector<double>& values : fields) {
      TF_CHECK(values.size() == old_.points.size());
      closest_.push_back(interpolated(old_, values, places));
    }
    result_.fields.assign(fields.size(), std::vector<double>(target.points.size(), 0));
  }

  ConservedFields run() {
    for (std::int32_t t = 0; t < target_.size(); ++t) add_triangle(t);
    for (std::size_t f = 0; f < fields_.size(); ++f) finish_field(f);
    return std::move(result_);
  }

 private:
  Cover cover_of(std::int32_t t, double area) {
    std::array<std::int32_t, 4> seeds{};
    double farthest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const PlaneLocation& place = places_[at(target_.nodes(t)[i])];
      seeds[i] = place.triangle;
      farthest = std::max(farthest, place.distance);
    }
    Cover cover = summed(intersection_.pieces_of(t, std::span(seeds).first(3)));
    const bool has_rest = cover.area < (1 - whole_share) * area;
    if (!has_rest || farthest > whole_share * std::sqrt(area)) return cover;
    // The triangles found hang together at a node alone with the rest.
    seeds[3] = background_.locate(centre_of(t), seeds[0]).triangle;
    return summed(intersection_.pieces_of(t, seeds));
  }

  static Cover summed(std::span<const IntersectionPiece> pieces) {
    Cover cover{pieces, 0, {}};
    for (const IntersectionPiece& piece : pieces) {
      cover.area += piece.area;
      cover.moment = {cover.moment.x + piece.moment.x, cover.moment.y + piece.moment.y};
    }
    return cover;
  }

  Vec2 centre_of(std::int32_t t) const {
    const TriangleComplex::Nodes& n = target_.nodes(t);
    const Vec2& a = target_.point(n[0]);
    const Vec2& b = target_.point(n[1]);
    const Vec2& c = target_.point(n[2]);
    return {(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
  }

  /// Of the old field over what is covered, gone on over all of the triangle.
  LinearFunction function_on(std::int32_t t, const Cover& cover,
                             const std::vector<double>& values) const {
    LinearFunction function;
    double mass = 0;
    Vec2 gradient;
    for (const IntersectionPiece& piece : cover.pieces) {
      NodeValues of_nodes{};
      for (std::size_t i = 0; i < 3; ++i) {
        of_nodes[i] = values[at(old_.nodes(piece.triangle)[i])];
        mass += piece.shares[i] * of_nodes[i];
        function.low = std::min(function.low, of_nodes[i]);
        function.high = std::max(function.high, of_nodes[i]);
      }
      const Vec2 part = gradient_times_area(old_, piece.triangle, of_nodes);
      const double weight = piece.area / (2 * area_of(old_, piece.triangle)) / cover.area;
      gradient = {gradient.x + weight * part.x, gradient.y + weight * part.y};
    }
    const Vec2& origin = target_.point(target_.nodes(t)[0]);
    const Vec2 middle{cover.moment.x / cover.area, cover.moment.y / cover.area};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2& p = target_.point(target_.nodes(t)[i]);
      function.values[i] = mass / cover.area + gradient.x * (p.x - origin.x - middle.x) +
                           gradient.y * (p.y - origin.y - middle.y);
    }
    function.mean = (function.values[0] + function.values[1] + function.values[2]) / 3;
    return function;
  }

  void add_triangle(std::int32_t t) {
    const double area = area_of(target_, t);
    const Cover cover = cover_of(t, area);
    const bool is_covered = cover.area > sliver_share * area;
    result_.covered_area += std::min(cover.area, area);
    const TriangleComplex::Nodes& nodes = target_.nodes(t);
    for (std::size_t f = 0; f < fields_.size(); ++f) {
      LinearFunction function;
      if (is_covered) {
        function = function_on(t, cover, fields_[f]);
        limit(function);
      } else {
        for (std::size_t i = 0; i < 3; ++i) function.values[i] = closest_[f][at(nodes[i])];
      }
      for (std::size_t i = 0; i < 3; ++i) {
        result_.fields[f][at(nodes[i])] += area * function.values[i];
      }
    }
    for (const std::int32_t v : nodes) areas_at_[at(v)] += area;
  }

  /// From sums to means; those of nodes that no triangle uses are the closest values.
  void finish_field(std::size_t f) {
    const auto [low, high] = std::minmax_element(fields_[f].begin(), fields_[f].end());
    std::vector<double>& values = result_.fields[f];
    for (std::size_t v = 0; v < values.size(); ++v) {
      values[v] =
          areas_at_[v] > 0 ? std::clamp(values[v] / areas_at_[v], *low, *high) : closest_[f][v];
    }
  }

  const MeshLocation& background_;
  const TriangleComplex& old_;
  std::span<const std::vector<double>> fields_;
  const TriangleComplex& target_;
  std::span<const PlaneLocation> places_;
  MeshIntersection intersection_;
  std::vector<double> areas_at_;
  std::vector<std::vector<double>> closest_;
  ConservedFields result_;
};

}  // namespace

ConservedFields transferred_conservatively(const MeshLocation& background,
                                           std::span<const std::vector<double>> fields,
                                           const TriangleComplex& target,
                                           std::span<const PlaneLocation> places) {
  TF_CHECK(places.size() == target.points.size());
  return ConservativePass(background, fields, target, places).run();
}

double field_integral(const TriangleComplex& complex, std::span<const double> values) {
  TF_CHECK(values.size() == complex.points.size());
  double sum = 0;
  for (std::int32_t t = 0; t < complex.size(); ++t) {
    const TriangleComplex::Nodes& n = complex.nodes(t);
    sum += area_of(complex, t) * (values[at(n[0])] + values[at(n[1])] + values[at(n[2])]) / 3;
  }
  return sum;
}

}  // namespace tetfarm
