#include "mesh/formats/flite/read_flite_sources.h"

#include <array>

#include "base/check.h"
#include "mesh/formats/input_scanner.h"

namespace tetfarm {
namespace {

class FliteReader {
 public:
  FliteReader(std::string_view bytes, const std::string& name) : scanner_(bytes, name) {}

  FliteSources read() {
    scanner_.rest_of_line();
    std::array<std::size_t, 5> counts{};
    for (std::size_t& count : counts) {
      constexpr std::size_t shortest_line = 2;
      count =
          scanner_.to_count(scanner_.integer("a number of nodes, tets or sources"), shortest_line);
    }
    scanner_.rest_of_line();
    for (std::size_t i = 0; i < counts[0]; ++i) read_background_node();
    for (std::size_t i = 0; i < counts[1]; ++i) line();
    for (std::size_t corners = 1; corners <= 3; ++corners) {
      // Files may end where no sources follow.
      if (scanner_.at_end() && counts[1 + corners] == 0) continue;
      line();
      for (std::size_t i = 0; i < counts[1 + corners]; ++i) read_source(corners);
    }
    return std::move(result_);
  }

 private:
  void line() {
    if (scanner_.at_end()) scanner_.fail("the file ends too early");
    scanner_.rest_of_line();
  }

  /// Fortran writes the exponent of a double with D.
  double number() {
    std::string word(scanner_.word_in_line());
    for (char& c : word) {
      if (c == 'D' || c == 'd') c = 'e';
    }
    return scanner_.to_coordinate(word);
  }
  double positive(const char* what) {
    const double value = number();
    if (!(value > 0)) scanner_.fail(std::string(what) + " must be more than 0");
    return value;
  }

  void read_background_node() {
    line();
    for (int direction = 0; direction < 3; ++direction) {
      for (int axis = 0; axis < 3; ++axis) number();
      const double spacing = positive("a spacing");
      if (result_.background > 0 && spacing != result_.background) {
        scanner_.fail("the background's spacing varies: only a uniform spacing is supported");
      }
      result_.background = spacing;
      scanner_.rest_of_line();
    }
  }

  void read_source(std::size_t corners) {
    TF_CHECK(corners >= 1 && corners <= 3);
    line();
    JobSource source;
    for (std::size_t i = 0; i < corners; ++i) {
      JobSource::Corner corner;
      corner.at = {number(), number(), number()};
      corner.spacing = positive("a spacing");
      corner.inner = positive("an inner radius");
      corner.outer = positive("an outer radius");
      if (corner.outer < corner.inner) scanner_.fail("the outer radius is less than the inner");
      source.corners.push_back(corner);
      scanner_.rest_of_line();
    }
    result_.sources.push_back(std::move(source));
  }

  InputScanner scanner_;
  FliteSources result_;
};

}  // namespace

FliteSources read_flite_sources(std::string_view bytes, const std::string& name) {
  return FliteReader(bytes, name).read();
}

}  // namespace tetfarm
