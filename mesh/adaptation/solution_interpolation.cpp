#include "mesh/adaptation/solution_interpolation.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {

std::vector<double> interpolated(const TriangleComplex& background, std::span<const double> values,
                                 std::span<const PlaneLocation> places) {
  TF_CHECK(values.size() == background.points.size());
  std::vector<double> result;
  result.reserve(places.size());
  for (const PlaneLocation& place : places) {
    const TriangleComplex::Nodes& n = background.nodes(place.triangle);
    const double a = values[at(n[0])];
    const double b = values[at(n[1])];
    const double c = values[at(n[2])];
    const auto [low, high] = std::minmax({a, b, c});
    const double mean = place.weights[0] * a + place.weights[1] * b + place.weights[2] * c;
    result.push_back(std::clamp(mean, low, high));
  }
  return result;
}

}  // namespace tetfarm
