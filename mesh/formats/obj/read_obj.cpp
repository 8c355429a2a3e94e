#include "mesh/formats/obj/read_obj.h"

#include <algorithm>
#include <array>

#include "base/check.h"
#include "mesh/formats/input_scanner.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/polygon_triangles.h"

namespace tetfarm {
namespace {

/// One of the three ways in which OBJ names its faces.
struct Naming {
  std::string_view keyword;
  std::string_view current = {};
  PatchNames patches = {};
  std::vector<std::int32_t> patch_of_triangle = {};
};

constexpr std::array<std::string_view, 14> passed_over = {
    "vt",  "vn",    "vp",       "l",        "p",         "s",          "mtllib",
    "lod", "bevel", "c_interp", "d_interp", "trace_obj", "shadow_obj", "usemap"};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const std::string& name) : scanner_(bytes, name, '#') {}

  SurfaceMesh read() {
    while (!scanner_.at_end()) {
      const std::string_view keyword = scanner_.word();
      const auto naming = std::find_if(namings_.begin(), namings_.end(),
                                       [&](const Naming& n) { return n.keyword == keyword; });
      if (keyword == "v") {
        read_vertex();
      } else if (keyword == "f") {
        read_face();
      } else if (naming != namings_.end()) {
        naming->current = scanner_.rest_of_line();
      } else if (std::find(passed_over.begin(), passed_over.end(), keyword) != passed_over.end()) {
        scanner_.rest_of_line();
      } else {
        scanner_.fail("unknown OBJ statement " + quoted(keyword));
      }
    }
    const auto best =
        std::max_element(namings_.begin(), namings_.end(), [](const Naming& a, const Naming& b) {
          return std::pair(a.patches.size(), !a.current.empty()) <
                 std::pair(b.patches.size(), !b.current.empty());
        });
    TF_CHECK(best->patch_of_triangle.size() == surface_.triangles.size());
    surface_.patch_names = best->patches.take();
    surface_.patch_of_triangle = std::move(best->patch_of_triangle);
    return std::move(surface_);
  }

 private:
  void read_vertex() {
    const double x = scanner_.coordinate_in_line();
    const double y = scanner_.coordinate_in_line();
    surface_.vertices.push_back({x, y, scanner_.coordinate_in_line()});
    scanner_.rest_of_line();
  }

  void read_face() {
    corners_.clear();
    for (;;) {
      const std::string_view word = scanner_.word_in_line();
      if (word.empty()) break;
      corners_.push_back(vertex_number(word));
    }
    if (corners_.size() < 3) {
      scanner_.fail("a face with " + std::to_string(corners_.size()) + " vertices");
    }
    const std::size_t triangles = add_polygon(surface_, corners_);
    for (Naming& naming : namings_) {
      naming.patch_of_triangle.insert(naming.patch_of_triangle.end(), triangles,
                                      naming.patches.number_of(naming.current));
    }
  }

  /// Of "7", "7/1", "7//3", "7/1/3" or "-1": the vertex, from 0.
  std::int32_t vertex_number(std::string_view word) {
    const auto defined = static_cast<std::int64_t>(surface_.vertices.size());
    const std::int64_t given =
        scanner_.to_integer(word.substr(0, word.find('/')), "a vertex number");
    const std::int64_t vertex = given < 0 ? defined + given : given - 1;
    if (given == 0 || vertex < 0 || vertex >= defined) {
      scanner_.fail("vertex " + std::to_string(given) + " of the " + std::to_string(defined) +
                    " so far");
    }
    return static_cast<std::int32_t>(vertex);
  }

  InputScanner scanner_;
  SurfaceMesh surface_;
  std::vector<std::int32_t> corners_;  ///< of the face at hand
  std::array<Naming, 3> namings_ = {Naming{"g"}, Naming{"o"}, Naming{"usemtl"}};
};

}  // namespace

SurfaceMesh read_obj(std::string_view bytes, const std::string& name) {
  return ObjReader(bytes, name).read();
}

}  // namespace tetfarm
