/// How high the layers of a line are: the first, and how they grow away from the wall.
///
/// Source: thesis 4.4 takes a list of heights; geometric growth with equal layers at the wall is
/// what DPW-4's guidelines ask for, accelerated growth up to a cap is AFLR3's law. Heights come of
/// repeated multiplication alone, so that all machines have the same. Lengths in the unit of the
/// input.
#pragma once

#include <memory>
#include <span>
#include <vector>

namespace tetfarm {

/// A layer of a list is at most so many times as high as the one before, and at least so many
/// times.
inline constexpr double most_height_ratio = 2;
inline constexpr double least_height_ratio = 0.5;

/// What a list of heights says beside the first: of each layer from the second on how many times as
/// high it is as the one before. Copies share the numbers.
class HeightRatios {
 public:
  HeightRatios() = default;  ///< there is no list
  /// A list of as many heights and one more. @pre each is from least_height_ratio to
  /// most_height_ratio.
  explicit HeightRatios(std::vector<double> ratios);

  bool are_listed() const { return ratios_ != nullptr; }
  std::span<const double> values() const {
    return are_listed() ? *ratios_ : std::span<const double>();
  }

  /// By the numbers. Cost: O(1) for copies of one list.
  friend bool operator==(const HeightRatios& a, const HeightRatios& b);

 private:
  std::shared_ptr<const std::vector<double>> ratios_;
};

/// Layer i (from 1) is height(i) high: `first` for the first `equal` layers, then each `growth`
/// times as high as the one before, where `growth` itself becomes `acceleration` times as large
/// after each layer, up to `cap`. Where there is a list each layer is 1 + `share` (r - 1) times as
/// high as the one before, r being its ratio, but r where this is below 1; and only what is listed
/// has a height.
struct HeightLaw {
  double first = 0;
  double growth = 1.2;
  double acceleration = 1;
  double cap = 1.2;          ///< at least `growth`
  int equal = 1;             ///< at least 1
  HeightRatios ratios = {};  ///< of the list that takes the place of the four before
  double share = 1;          ///< of a list's growth; 0 to 1

  friend bool operator==(const HeightLaw&, const HeightLaw&) = default;
};

/// The law of listed heights. @pre there are some, positive, with ratios as HeightRatios has them.
HeightLaw law_of_heights(std::span<const double> heights);

/// How many layers the law has heights for, at most `most`.
int most_layers_of(const HeightLaw& law, int most);

/// How far from the wall each level lies: 0, then after each of `count` layers.
/// @pre here and below: the law has heights for `count` layers. Cost: O(count).
std::vector<double> levels_of(const HeightLaw& law, int count);

/// The sum of `count` layers. Cost: O(count).
double total_height(const HeightLaw& law, int count);

/// The same without any growth.
double least_height(const HeightLaw& law, int count);

/// The fewest layers, at most `most` and as many as there are, of which the last is at least
/// `height` high.
int layers_until(const HeightLaw& law, double height, int most);

/// The fewest layers, at most `most` and as many as there are, that are together at least `height`
/// high.
int layers_within(const HeightLaw& law, double height, int most);

/// How high the layer is. @pre layer >= 1. Cost: O(layer).
double height_of_layer(const HeightLaw& law, int layer);

/// The law with a lower growth with which `count` layers are as high as `room`, or the same law
/// where they fit as it is. Where even layers that do not grow do not fit it grows by nothing: then
/// fewer layers fit. By bisection: the total is below `room`, by at most 1e-12 of it.
HeightLaw fitted(const HeightLaw& law, int count, double room);

}  // namespace tetfarm
