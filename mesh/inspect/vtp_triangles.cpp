#include "mesh/inspect/vtp_triangles.h"

#include <charconv>
#include <cmath>

#include "base/error.h"

namespace tetfarm {
namespace {

class VtpReader {
 public:
  VtpReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  NumberedTriangles read() {
    NumberedTriangles read;
    while (next_array()) {
      std::vector<double> values = numbers();
      if (array_ == "Points") {
        read.points = points_of(values);
      } else if (array_ == "connectivity") {
        read.triangles = triangles_of(values);
      } else if (array_ != "offsets") {
        read.arrays[array_] = std::move(values);
      }
    }
    require_whole(read);
    return read;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InvalidInput(what, name_); }

  /// Goes to the numbers of the next one.
  bool next_array() {
    constexpr std::string_view begin = "<DataArray ";
    constexpr std::string_view named = "Name=\"";
    const std::size_t found = text_.find(begin);
    if (found == std::string_view::npos) return false;
    text_.remove_prefix(found + begin.size());
    const std::size_t end = text_.find('>');
    const std::size_t name = text_.find(named);
    if (end == std::string_view::npos || name > end) fail("it has an array without a name");
    const std::string_view rest = text_.substr(name + named.size());
    array_ = rest.substr(0, rest.find('"'));
    if (text_.substr(0, end).find("format=\"ascii\"") == std::string_view::npos) {
      fail("the array \"" + array_ + "\" is not text; only maps as Tetfarm writes them are read");
    }
    text_.remove_prefix(end + 1);
    return true;
  }

  std::vector<double> numbers() {
    std::vector<double> values;
    for (;;) {
      const std::size_t begin = text_.find_first_not_of(" \t\r\n");
      if (begin == std::string_view::npos) fail("it ends within the array \"" + array_ + "\"");
      text_.remove_prefix(begin);
      if (text_.front() == '<') return values;
      double value = 0;
      const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
      if (error != std::errc() || !std::isfinite(value)) {
        fail("number " + std::to_string(values.size() + 1) + " of the array \"" + array_ +
             "\" is none");
      }
      values.push_back(value);
      text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    }
  }

  std::vector<Vec3> points_of(const std::vector<double>& values) const {
    if (values.size() % 3 != 0) fail("a point has three coordinates");
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < values.size(); i += 3) {
      points.push_back({values[i], values[i + 1], values[i + 2]});
    }
    return points;
  }

  std::vector<Triangle> triangles_of(const std::vector<double>& values) const {
    if (values.size() % 3 != 0) fail("a triangle has three corners");
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < values.size(); i += 3) {
      Triangle& triangle = triangles.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const double corner = values[i + k];
        if (corner < 0 || corner >= 2147483647 || corner != std::floor(corner)) {
          fail("triangle " + std::to_string(i / 3) + " has a corner that is no number of a point");
        }
        triangle.at(k) = static_cast<std::int32_t>(corner);
      }
    }
    return triangles;
  }

  void require_whole(const NumberedTriangles& read) const {
    for (std::size_t t = 0; t < read.triangles.size(); ++t) {
      for (const std::int32_t v : read.triangles[t]) {
        if (static_cast<std::size_t>(v) < read.points.size()) continue;
        fail("triangle " + std::to_string(t) + " has a corner that is no number of a point");
      }
    }
    for (const auto& [array, values] : read.arrays) {
      if (values.size() == read.triangles.size()) continue;
      fail("the array \"" + array + "\" has " + std::to_string(values.size()) + " numbers for " +
           std::to_string(read.triangles.size()) + " triangles");
    }
  }

  std::string_view text_;
  const std::string& name_;
  std::string array_;
};

}  // namespace

NumberedTriangles triangles_from_vtp(std::string_view text, const std::string& name) {
  return VtpReader(text, name).read();
}

}  // namespace tetfarm
