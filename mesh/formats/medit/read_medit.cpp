#include "mesh/formats/medit/read_medit.h"

#include <limits>

#include "mesh/formats/input_scanner.h"
#include "mesh/formats/medit/medit_keywords.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

class MeditReader {
 public:
  MeditReader(std::string_view bytes, const std::string& name)
      : bytes_(bytes), scanner_(bytes, name, '#') {}

  SurfaceMesh read() {
    constexpr std::string_view text_start = "MeshVersionFormatted";
    is_text_ = bytes_.find(text_start) < 200;
    is_text_ ? read_text() : read_binary();
    surface_.patch_names = patches_.take();
    keep_used_vertices(surface_);
    return std::move(surface_);
  }

 private:
  void read_text() {
    scanner_.expect("MeshVersionFormatted");
    scanner_.integer("the version");
    scanner_.expect("Dimension");
    if (scanner_.integer("the dimension") != 3) scanner_.fail("the mesh is not three-dimensional");
    while (!scanner_.at_end()) {
      const std::string_view word = scanner_.word();
      if (word == "End") return;
      if (word == "Vertices") {
        read_vertices(list_length());
      } else if (word == "Triangles") {
        read_triangles(list_length());
      } else if (word == "Quadrilaterals" && list_length() > 0) {
        scanner_.fail("has quadrangles: only triangles are supported");
      }
      // Numbers and the names of other lists are passed over, word by word.
    }
  }

  void read_binary() {
    const auto mark = scanner_.raw<std::int32_t>();
    is_turned_ = mark == 0x01000000;
    if (mark != 1 && !is_turned_) scanner_.fail("is not a Medit file: it begins like neither form");
    version_ = static_cast<int>(small());
    if (version_ < 1 || version_ > 4) {
      scanner_.fail("version " + std::to_string(version_) + " is not supported; 1 to 4 are");
    }
    std::size_t here = 8;
    while (here + 8 <= bytes_.size()) {
      go_to(here);
      const std::int64_t keyword = small();
      if (keyword == medit::end) return;
      const std::int64_t next = version_ < 3 ? small() : large();
      if (keyword == medit::dimension) {
        if (small() != 3) scanner_.fail("the mesh is not three-dimensional");
      } else if (keyword == medit::vertices) {
        read_vertices(list_length());
      } else if (keyword == medit::triangles) {
        read_triangles(list_length());
      } else if (keyword == medit::quadrangles && list_length() > 0) {
        scanner_.fail("has quadrangles: only triangles are supported");
      }
      if (next <= static_cast<std::int64_t>(here) ||
          next > static_cast<std::int64_t>(bytes_.size())) {
        scanner_.fail("a list gives a wrong place for the next: byte " + std::to_string(next));
      }
      here = static_cast<std::size_t>(next);
    }
  }

  /// Forward only.
  void go_to(std::size_t place) {
    const std::size_t now = bytes_.size() - scanner_.bytes_left();
    if (place < now) scanner_.fail("a list runs past the beginning of the next");
    scanner_.skip_bytes(place - now);
  }

  std::size_t list_length() {
    const std::int64_t length = integer("the length of a list");
    return scanner_.to_count(length, is_text_ ? 8 : 16);
  }

  void read_vertices(std::size_t count) {
    if (count > std::numeric_limits<std::int32_t>::max()) scanner_.fail("too many vertices");
    for (std::size_t i = 0; i < count; ++i) {
      const double x = coordinate();
      const double y = coordinate();
      surface_.vertices.push_back({x, y, coordinate()});
      integer("a reference");
    }
  }

  void read_triangles(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      Triangle triangle;
      for (std::int32_t& v : triangle) {
        v = vertex_of(scanner_, surface_, integer("a vertex number"), 1);
      }
      surface_.triangles.push_back(triangle);
      surface_.patch_of_triangle.push_back(
          patches_.number_of("reference " + std::to_string(integer("a reference"))));
    }
  }

  template <class T>
  T raw() {
    return is_turned_ ? scanner_.raw_turned<T>() : scanner_.raw<T>();
  }
  std::int64_t small() { return raw<std::int32_t>(); }
  std::int64_t large() { return raw<std::int64_t>(); }
  std::int64_t integer(std::string_view what) {
    if (is_text_) return scanner_.integer(what);
    return version_ < 4 ? small() : large();
  }
  double coordinate() {
    if (is_text_) return scanner_.coordinate();
    return scanner_.finite(version_ == 1 ? static_cast<double>(raw<float>()) : raw<double>());
  }

  std::string_view bytes_;
  InputScanner scanner_;
  bool is_text_ = false;
  bool is_turned_ = false;
  int version_ = 0;
  PatchNames patches_;
  SurfaceMesh surface_;
};

}  // namespace

SurfaceMesh read_medit(std::string_view bytes, const std::string& name) {
  return MeditReader(bytes, name).read();
}

}  // namespace tetfarm
