#include "mesh/layers/height_law.h"

#include <algorithm>

#include "base/check.h"

namespace tetfarm {
namespace {

/// Calls visit(height) for each layer until it returns false.
template <class Visit>
void for_each_height(const HeightLaw& law, int count, const Visit& visit) {
  TF_CHECK(law.first > 0 && law.growth >= 1 && law.equal >= 1);
  double height = law.first;
  double growth = law.growth;
  for (int layer = 1; layer <= count; ++layer) {
    if (layer > law.equal) {
      height *= growth;
      growth = std::max(law.growth, std::min(growth * law.acceleration, law.cap));
    }
    if (!visit(height)) return;
  }
}

/// The law as much lower as `share` says: 0 does not grow at all, 1 is the law itself.
HeightLaw lowered(const HeightLaw& law, double share) {
  HeightLaw lower = law;
  lower.growth = 1 + share * (law.growth - 1);
  lower.acceleration = 1 + share * (law.acceleration - 1);
  lower.cap = 1 + share * (law.cap - 1);
  return lower;
}

}  // namespace

std::vector<double> levels_of(const HeightLaw& law, int count) {
  std::vector<double> levels = {0};
  levels.reserve(static_cast<std::size_t>(count) + 1);
  for_each_height(law, count, [&levels](double height) {
    levels.push_back(levels.back() + height);
    return true;
  });
  return levels;
}

double total_height(const HeightLaw& law, int count) {
  double total = 0;
  for_each_height(law, count, [&total](double height) {
    total += height;
    return true;
  });
  return total;
}

int layers_until(const HeightLaw& law, double height, int most) {
  int layers = 0;
  for_each_height(law, most, [&](double layer) {
    ++layers;
    return layer < height;
  });
  return layers;
}

int layers_within(const HeightLaw& law, double height, int most) {
  int layers = 0;
  double total = 0;
  for_each_height(law, most, [&](double layer) {
    ++layers;
    total += layer;
    return total < height;
  });
  return layers;
}

double height_of_layer(const HeightLaw& law, int layer) {
  TF_CHECK(layer >= 1);
  double last = 0;
  for_each_height(law, layer, [&last](double height) {
    last = height;
    return true;
  });
  return last;
}

HeightLaw fitted(const HeightLaw& law, int count, double room) {
  if (total_height(law, count) <= room) return law;
  constexpr int halvings = 60;
  double fits = 0;
  double does_not = 1;
  for (int i = 0; i < halvings; ++i) {
    const double middle = fits + (does_not - fits) / 2;
    (total_height(lowered(law, middle), count) <= room ? fits : does_not) = middle;
  }
  return lowered(law, fits);
}

}  // namespace tetfarm
