/// How high the layers of a line are: the first, and how they grow away from the wall.
///
/// Source: thesis 4.4 takes a list of heights; geometric growth with equal layers at the wall is
/// what DPW-4's guidelines ask for, accelerated growth up to a cap is AFLR3's law. Heights come of
/// repeated multiplication alone, so that all machines have the same. Lengths in the unit of the
/// input.
#pragma once

#include <vector>

namespace tetfarm {

/// Layer i (from 1) is height(i) high: `first` for the first `equal` layers, then each `growth`
/// times as high as the one before, where `growth` itself becomes `acceleration` times as large
/// after each layer, up to `cap`.
struct HeightLaw {
  double first = 0;
  double growth = 1.2;
  double acceleration = 1;
  double cap = 1.2;  ///< at least `growth`
  int equal = 1;     ///< at least 1

  friend bool operator==(const HeightLaw&, const HeightLaw&) = default;
};

/// How far from the wall each level lies: 0, then after each of `count` layers. Cost: O(count).
std::vector<double> levels_of(const HeightLaw& law, int count);

/// The sum of `count` layers. Cost: O(count).
double total_height(const HeightLaw& law, int count);

/// The fewest layers, at most `most`, of which the last is at least `height` high.
int layers_until(const HeightLaw& law, double height, int most);

/// The fewest layers, at most `most`, that are together at least `height` high.
int layers_within(const HeightLaw& law, double height, int most);

/// How high the layer is. @pre layer >= 1. Cost: O(layer).
double height_of_layer(const HeightLaw& law, int layer);

/// The law with a lower growth with which `count` layers are as high as `room`, or the same law
/// where they fit as it is. Where even equal layers do not fit it grows by nothing (growth 1): then
/// fewer layers fit. By bisection: the total is below `room`, by at most 1e-12 of it.
HeightLaw fitted(const HeightLaw& law, int count, double room);

}  // namespace tetfarm
