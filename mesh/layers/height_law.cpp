#include "mesh/layers/height_law.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace tetfarm {
namespace {

bool is_ratio(double ratio) { return ratio >= least_height_ratio && ratio <= most_height_ratio; }

/// Of a list.
template <class Visit>
void for_each_listed_height(const HeightLaw& law, int count, const Visit& visit) {
  double height = law.first;
  if (count == 0 || !visit(height)) return;
  for (const double ratio : law.ratios.values().first(static_cast<std::size_t>(count) - 1)) {
    height *= ratio > 1 ? 1 + law.share * (ratio - 1) : ratio;
    if (!visit(height)) return;
  }
}

/// Calls visit(height) for each layer until it returns false.
template <class Visit>
void for_each_height(const HeightLaw& law, int count, const Visit& visit) {
  TF_CHECK(law.first > 0 && law.growth >= 1 && law.equal >= 1);
  TF_CHECK(count == most_layers_of(law, count));
  if (law.ratios.are_listed()) {
    for_each_listed_height(law, count, visit);
    return;
  }
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
  if (law.ratios.are_listed()) lower.share = share * law.share;
  return lower;
}

}  // namespace

HeightRatios::HeightRatios(std::vector<double> ratios) {
  TF_CHECK(std::all_of(ratios.begin(), ratios.end(), is_ratio));
  ratios_ = std::make_shared<const std::vector<double>>(std::move(ratios));
}

bool operator==(const HeightRatios& a, const HeightRatios& b) {
  if (a.ratios_ == b.ratios_) return true;
  return a.are_listed() && b.are_listed() && *a.ratios_ == *b.ratios_;
}

HeightLaw law_of_heights(std::span<const double> heights) {
  TF_CHECK(!heights.empty());
  std::vector<double> ratios;
  for (std::size_t i = 1; i < heights.size(); ++i) ratios.push_back(heights[i] / heights[i - 1]);
  HeightLaw law;
  law.first = heights.front();
  law.ratios = HeightRatios(std::move(ratios));
  return law;
}

int most_layers_of(const HeightLaw& law, int most) {
  if (!law.ratios.are_listed()) return most;
  return static_cast<int>(std::min<std::ptrdiff_t>(most, std::ssize(law.ratios.values()) + 1));
}

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

double least_height(const HeightLaw& law, int count) {
  if (!law.ratios.are_listed()) return law.first * count;
  return total_height(lowered(law, 0), count);
}

int layers_until(const HeightLaw& law, double height, int most) {
  int layers = 0;
  for_each_height(law, most_layers_of(law, most), [&](double layer) {
    ++layers;
    return layer < height;
  });
  return layers;
}

int layers_within(const HeightLaw& law, double height, int most) {
  int layers = 0;
  double total = 0;
  for_each_height(law, most_layers_of(law, most), [&](double layer) {
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
