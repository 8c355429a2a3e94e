#include "mesh/formats/plane/read_loops.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/file_system.h"

namespace tetfarm {
namespace {

constexpr std::string_view blanks = " \t\r,;";
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Takes the next number off the line.
std::optional<double> take_number(std::string_view& line) {
  const std::size_t begin = line.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return std::nullopt;
  line.remove_prefix(begin);
  if (line.front() == '+') line.remove_prefix(1);
  double value = 0;
  const auto read = std::from_chars(line.data(), line.data() + line.size(), value);
  if (read.ec != std::errc{} || !std::isfinite(value)) return std::nullopt;
  line.remove_prefix(static_cast<std::size_t>(read.ptr - line.data()));
  if (!line.empty() && blanks.find(line.front()) == std::string_view::npos) return std::nullopt;
  return value;
}

std::optional<Vec2> point_of(std::string_view line) {
  const std::optional<double> x = take_number(line);
  const std::optional<double> y = x.has_value() ? take_number(line) : std::nullopt;
  if (!y.has_value() || line.find_first_not_of(blanks) != std::string_view::npos) {
    return std::nullopt;
  }
  return Vec2{*x, *y};
}

bool is_blank(std::string_view line) {
  return line.substr(0, line.find('#')).find_first_not_of(blanks) == std::string_view::npos;
}

/// The numbers of points of the two sides of an airfoil in Lednicer's form: a line by itself, which
/// cannot be a point, since no loop has one point alone.
std::optional<std::array<std::size_t, 2>> side_counts(const Vec2& numbers) {
  constexpr double most = 1e6;
  for (const double n : {numbers.x, numbers.y}) {
    if (n != std::floor(n) || n < 2 || n > most) return std::nullopt;
  }
  return std::array{static_cast<std::size_t>(numbers.x), static_cast<std::size_t>(numbers.y)};
}

class LoopReader {
 public:
  explicit LoopReader(const std::filesystem::path& path)
      : name_(path.string()), bytes_(read_file(path)) {}

  std::vector<PlaneLoop> read() {
    std::string_view rest = bytes_;
    if (rest.starts_with(byte_order_mark)) rest.remove_prefix(byte_order_mark.size());
    while (!rest.empty()) {
      ++line_number_;
      const std::size_t end = rest.find('\n');
      const std::string_view line = rest.substr(0, end);
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
      read_line(line, is_blank(rest.substr(0, rest.find('\n'))));
    }
    counts_.has_value() ? end_sides() : end_loop();
    if (loops_.empty()) throw InvalidInput("has no points: a line \"x y\" for each", name_);
    return std::move(loops_);
  }

 private:
  std::string here() const { return name_ + ":" + std::to_string(line_number_); }

  void read_line(std::string_view line, bool is_before_blank) {
    const bool has_comment = line.find('#') != std::string_view::npos;
    line = line.substr(0, line.find('#'));
    if (is_blank(line)) {
      if (!counts_.has_value()) end_loop();
      return;
    }
    const std::optional<Vec2> point = point_of(line);
    if (!point.has_value()) {
      if (line_number_ == 1 && !has_comment) return;  // a title
      throw InvalidInput("a point is two numbers, x and y", here());
    }
    if (loops_.empty() && loop_.points.empty() && is_before_blank && !counts_.has_value()) {
      counts_ = side_counts(*point);
      if (counts_.has_value()) return;
    }
    add_point(*point);
  }

  void add_point(const Vec2& point) {
    if (loop_.points.empty()) loop_.where = here();
    const bool begins_lower = counts_.has_value() && loop_.points.size() == (*counts_)[0];
    if (!begins_lower && !loop_.points.empty() && loop_.points.back() == point) {
      throw InvalidInput("the point is that of the line before", here());
    }
    loop_.points.push_back(point);
  }

  /// Both sides as one loop: the upper one backwards to the leading edge, then the lower one.
  void end_sides() {
    const auto [upper, lower] = *counts_;
    if (loop_.points.size() != upper + lower) {
      throw InvalidInput("the sides have " + std::to_string(upper) + " and " +
                             std::to_string(lower) + " points, as the file says, but it has " +
                             std::to_string(loop_.points.size()),
                         loop_.points.empty() ? here() : loop_.where);
    }
    std::vector<Vec2>& points = loop_.points;
    std::reverse(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(upper));
    if (points[upper - 1] == points[upper]) {
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(upper));
    }
    end_loop();
  }

  void end_loop() {
    if (loop_.points.empty()) return;
    if (loop_.points.size() > 1 && loop_.points.front() == loop_.points.back()) {
      loop_.points.pop_back();
    }
    if (loop_.points.size() < 3) {
      throw InvalidInput("a loop has at least three points", loop_.where);
    }
    loops_.push_back(std::exchange(loop_, {}));
  }

  std::string name_;
  std::string bytes_;
  int line_number_ = 0;
  std::optional<std::array<std::size_t, 2>> counts_;  ///< of the sides of an airfoil
  PlaneLoop loop_;
  std::vector<PlaneLoop> loops_;
};

}  // namespace

std::vector<PlaneLoop> read_loops(const std::filesystem::path& path) {
  return LoopReader(path).read();
}

}  // namespace tetfarm
