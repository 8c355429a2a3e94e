#include <algorithm>
#include <array>
#include <cstddef>

#include "mesh/job_file/job_file.h"

namespace tetfarm {
namespace {

constexpr std::array<std::string_view, 7> units_of_length = {"m",  "km", "cm", "mm",
                                                             "um", "in", "ft"};
constexpr std::array<double, 7> metres_in_unit = {1, 1000, 0.01, 0.001, 1e-6, 0.0254, 0.3048};

}  // namespace

std::span<const std::string_view> length_units() { return units_of_length; }

std::optional<double> metres_of(std::string_view unit) {
  const auto found = std::find(units_of_length.begin(), units_of_length.end(), unit);
  if (found == units_of_length.end()) return std::nullopt;
  return metres_in_unit[static_cast<std::size_t>(found - units_of_length.begin())];
}

}  // namespace tetfarm
