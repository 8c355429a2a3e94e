/// Curves over one axis as an SVG file of its own: what a field is along a boundary, such as the
/// pressure coefficient of an airfoil.
///
/// No scripts and no addresses; any browser shows it. What is pointed at says which curve it is.
/// The same numbers give the same bytes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/geometry/predicates.h"

namespace tetfarm {

struct LineChart {
  std::string x_name = {};
  std::string y_name = {};
  struct Curve {
    std::string name = {};
    std::string colour = {};                     ///< as of CSS
    std::vector<std::vector<Vec2>> pieces = {};  ///< lines through points that are finite
  };
  std::vector<Curve> curves = {};
  bool is_reversed = false;  ///< small values on top, as is usual for pressure coefficients
  int width = 800;
  int height = 500;
};

/// For curves in this order: told apart also by people who do not see all colours.
inline constexpr std::array chart_colours = {"#12459e", "#d64a0f", "#008f6e", "#c76ba8",
                                             "#e09e00", "#4fa8e0", "#703385", "#616161"};

/// Curves with names have them listed on top. @pre there is a point.
/// @throws UsageError when the values are too far apart to be drawn on one axis.
std::string svg_file_of(const LineChart& chart);

}  // namespace tetfarm
