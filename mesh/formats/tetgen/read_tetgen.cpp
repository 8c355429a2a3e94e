#include "mesh/formats/tetgen/read_tetgen.h"

#include <limits>

#include "mesh/formats/patch_names.h"
#include "mesh/formats/polygon_triangles.h"
#include "mesh/formats/tetgen/tetgen_lists.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

class TetgenReader {
 public:
  TetgenReader(std::string_view bytes, const std::string& name)
      : scanner_(bytes, name, tetgen_comment),
        is_smesh_(name.find(".smesh") != std::string::npos) {}

  SurfaceMesh read() {
    read_nodes();
    const std::size_t facets = tetgen_count(scanner_, "the number of facets");
    const bool has_marks = tetgen_option(scanner_, 0) != 0;
    scanner_.rest_of_line();
    for (std::size_t i = 0; i < facets; ++i) is_smesh_ ? read_polygon(has_marks) : read_facet();
    surface_.patch_names = patches_.take();
    keep_used_vertices(surface_);
    return std::move(surface_);
  }

 private:
  void read_nodes() {
    from_ = walk_tetgen_nodes(scanner_, [this](const Vec3& p) {
      if (surface_.vertices.size() == std::numeric_limits<std::int32_t>::max()) {
        scanner_.fail("too many nodes");
      }
      surface_.vertices.push_back(p);
    });
    if (surface_.vertices.empty()) {
      scanner_.fail("the nodes are in a separate file; they must be in this one");
    }
  }

  void add(const std::vector<std::int32_t>& corners, std::int64_t mark) {
    const std::size_t triangles = add_polygon(surface_, corners);
    const std::int32_t patch = patches_.number_of("mark " + std::to_string(mark));
    surface_.patch_of_triangle.insert(surface_.patch_of_triangle.end(), triangles, patch);
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
    add(corners, has_mark ? tetgen_option(scanner_, 0) : 0);
    scanner_.rest_of_line();
  }

  /// Of .poly: the number of polygons, holes and the mark, then each polygon.
  void read_facet() {
    const std::int64_t polygons = scanner_.integer("the number of polygons");
    const std::int64_t holes = tetgen_option(scanner_, 0);
    const std::int64_t mark = tetgen_option(scanner_, 0);
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
