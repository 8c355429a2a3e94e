#include "mesh/formats/tetgen/read_tetgen.h"

#include <limits>

#include "mesh/formats/input_scanner.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

class TetgenReader {
 public:
  TetgenReader(std::string_view bytes, const std::string& name)
      : scanner_(bytes, name, '#'), is_smesh_(name.find(".smesh") != std::string::npos) {}

  SurfaceMesh read() {
    read_nodes();
    constexpr std::size_t shortest_facet = 8;
    const std::int64_t count = scanner_.integer("the number of facets");
    const std::size_t facets = scanner_.to_count(count, shortest_facet);
    const bool has_marks = optional_integer(0) != 0;
    scanner_.rest_of_line();
    for (std::size_t i = 0; i < facets; ++i) is_smesh_ ? read_polygon(has_marks) : read_facet();
    surface_.patch_names = patches_.take();
    keep_used_vertices(surface_);
    return std::move(surface_);
  }

 private:
  /// The next number of this line, if there is one.
  std::int64_t optional_integer(std::int64_t otherwise) {
    const std::string_view word = scanner_.word_in_line();
    return word.empty() ? otherwise : scanner_.to_integer(word, "an integer");
  }

  void read_nodes() {
    constexpr std::size_t shortest_line = 8;
    const std::int64_t count = scanner_.integer("the number of nodes");
    if (count == 0) scanner_.fail("the nodes are in a separate file; they must be in this one");
    const std::size_t nodes = scanner_.to_count(count, shortest_line);
    if (nodes > std::numeric_limits<std::int32_t>::max()) scanner_.fail("too many nodes");
    if (optional_integer(3) != 3) scanner_.fail("the nodes are not three-dimensional");
    scanner_.rest_of_line();
    for (std::size_t i = 0; i < nodes; ++i) {
      const std::int64_t number = scanner_.integer("a node number");
      if (i == 0) from_ = number;
      if ((from_ != 0 && from_ != 1) || number != from_ + static_cast<std::int64_t>(i)) {
        scanner_.fail("nodes are not numbered consecutively from 0 or 1");
      }
      const double x = scanner_.coordinate_in_line();
      const double y = scanner_.coordinate_in_line();
      surface_.vertices.push_back({x, y, scanner_.coordinate_in_line()});
      scanner_.rest_of_line();
    }
  }

  void add(const std::vector<std::int32_t>& corners, std::int64_t mark) {
    add_polygon(surface_, corners, patches_.number_of("mark " + std::to_string(mark)));
  }

  std::vector<std::int32_t> read_corners() {
    const std::int64_t count = scanner_.integer("the number of corners");
    if (count < 3) scanner_.fail("a polygon with " + std::to_string(count) + " corners");
    std::vector<std::int32_t> corners;
    for (std::size_t i = scanner_.to_count(count, 2); i > 0; --i) {
      corners.push_back(vertex_of(scanner_, surface_, scanner_.integer("a node number"), from_));
    }
    return corners;
  }

  /// A line of .smesh.
  void read_polygon(bool has_mark) {
    const std::vector<std::int32_t> corners = read_corners();
    add(corners, has_mark ? optional_integer(0) : 0);
    scanner_.rest_of_line();
  }

  /// Of .poly: the number of polygons, holes and the mark, then each polygon.
  void read_facet() {
    const std::int64_t polygons = scanner_.integer("the number of polygons");
    const std::int64_t holes = optional_integer(0);
    const std::int64_t mark = optional_integer(0);
    if (polygons != 1 || holes != 0) {
      scanner_.fail("a facet of " + std::to_string(polygons) + " polygons and " +
                    std::to_string(holes) + " holes: only one polygon without holes is supported");
    }
    scanner_.rest_of_line();
    add(read_corners(), mark);
    scanner_.rest_of_line();
  }

  InputScanner scanner_;
  bool is_smesh_;
  std::int64_t from_ = 0;
  PatchNames patches_;
  SurfaceMesh surface_;
};

}  // namespace

SurfaceMesh read_tetgen(std::string_view bytes, const std::string& name) {
  return TetgenReader(bytes, name).read();
}

}  // namespace tetfarm
