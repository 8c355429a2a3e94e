#include "mesh/formats/su2/read_su2.h"

#include <array>
#include <limits>
#include <utility>

#include "mesh/formats/input_scanner.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

constexpr std::int64_t vtk_triangle = 5;

class Su2Reader {
 public:
  Su2Reader(std::string_view bytes, const std::string& name) : scanner_(bytes, name, '%') {}

  SurfaceMesh read() {
    while (!scanner_.at_end()) {
      const std::string key = keyword();
      if (key == "NDIME") {
        if (count("the number of dimensions") != 3)
          scanner_.fail("the mesh is not three-dimensional");
      } else if (key == "NPOIN") {
        read_points();
      } else if (key == "NELEM") {
        read_elements(count("the number of elements"));
      } else if (key == "MARKER_TAG") {
        read_marker();
      } else {
        scanner_.rest_of_line();
      }
    }
    return finish();
  }

 private:
  /// An element, as the file has it: points may come after it.
  struct Corner {
    std::array<std::int64_t, 3> nodes{};
    std::int32_t patch = 0;
  };

  /// "KEY=" or "KEY =": the word before the sign.
  std::string keyword() {
    std::string key(scanner_.word());
    if (!key.ends_with('=')) {
      const std::size_t sign = key.find('=');
      if (sign != std::string::npos) {
        value_ = key.substr(sign + 1);
        return key.substr(0, sign);
      }
      scanner_.expect("=");
      return key;
    }
    key.pop_back();
    return key;
  }
  std::string_view value() {
    if (value_.empty()) value_ = scanner_.word_in_line();
    taken_ = std::exchange(value_, "");
    return taken_;
  }
  std::int64_t count(std::string_view what) {
    const std::int64_t number = scanner_.to_integer(value(), what);
    scanner_.rest_of_line();
    if (number < 0) scanner_.fail("a negative count");
    return number;
  }

  void read_points() {
    constexpr std::size_t shortest_line = 6;
    const std::size_t points = scanner_.to_count(count("the number of points"), shortest_line);
    if (points > std::numeric_limits<std::int32_t>::max()) scanner_.fail("too many points");
    for (std::size_t i = 0; i < points; ++i) {
      const double x = scanner_.coordinate();
      const double y = scanner_.coordinate_in_line();
      surface_.vertices.push_back({x, y, scanner_.coordinate_in_line()});
      scanner_.rest_of_line();
    }
  }

  void read_triangle(std::vector<Corner>& triangles, std::int32_t patch) {
    Corner corner;
    for (std::int64_t& node : corner.nodes) {
      node = scanner_.to_integer(scanner_.word_in_line(), "a point's number");
    }
    corner.patch = patch;
    triangles.push_back(corner);
  }

  void read_elements(std::int64_t elements) {
    for (std::int64_t i = 0; i < elements; ++i) {
      if (scanner_.integer("the type of an element") == vtk_triangle) read_triangle(elements_, 0);
      scanner_.rest_of_line();
    }
  }

  void read_marker() {
    const std::int32_t patch = patches_.number_of(value());
    scanner_.rest_of_line();
    if (keyword() != "MARKER_ELEMS") scanner_.fail("expected MARKER_ELEMS");
    for (std::int64_t i = count("the number of elements"); i > 0; --i) {
      if (scanner_.integer("the type of an element") != vtk_triangle) {
        scanner_.fail("an element of a marker is not a triangle (5)");
      }
      read_triangle(markers_, patch);
      scanner_.rest_of_line();
    }
  }

  SurfaceMesh finish() {
    const bool has_markers = !markers_.empty();
    for (const Corner& corner : has_markers ? markers_ : elements_) {
      Triangle triangle;
      for (std::size_t k = 0; k < 3; ++k) {
        triangle[k] = vertex_of(scanner_, surface_, corner.nodes[k], 0);
      }
      surface_.triangles.push_back(triangle);
      if (has_markers) surface_.patch_of_triangle.push_back(corner.patch);
    }
    if (has_markers) surface_.patch_names = patches_.take();
    keep_used_vertices(surface_);
    return std::move(surface_);
  }

  InputScanner scanner_;
  std::string value_;
  std::string taken_;
  PatchNames patches_;
  std::vector<Corner> markers_;
  std::vector<Corner> elements_;
  SurfaceMesh surface_;
};

}  // namespace

SurfaceMesh read_su2(std::string_view bytes, const std::string& name) {
  return Su2Reader(bytes, name).read();
}

}  // namespace tetfarm
