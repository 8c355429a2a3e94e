#include <charconv>
#include <cmath>
#include <system_error>

#include "mesh/job_file/job_file.h"

namespace tetfarm {
namespace {

std::string_view without_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

}  // namespace

std::optional<AxisPlane> parse_symmetry(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  const std::string_view letter = without_blanks(text.substr(0, equals));
  const std::string_view number = without_blanks(text.substr(equals + 1));
  if (letter.size() != 1 || letter[0] < 'x' || letter[0] > 'z') return std::nullopt;
  AxisPlane plane;
  plane.axis = letter[0] - 'x';
  const char* const end = number.data() + number.size();
  const auto [stopped, error] = std::from_chars(number.data(), end, plane.height);
  if (error != std::errc() || stopped != end || !std::isfinite(plane.height)) return std::nullopt;
  return plane;
}

}  // namespace tetfarm
