#include "mesh/formats/medit/read_medit.h"

#include <limits>
#include <vector>

#include "mesh/formats/input_scanner.h"
#include "mesh/formats/medit/medit_file.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

constexpr std::string_view text_start = "MeshVersionFormatted";
constexpr std::string_view has_quadrangles = "has quadrangles: only triangles are supported";
constexpr std::string_view too_many = "too many vertices";
constexpr std::int64_t most_vertices = std::numeric_limits<std::int32_t>::max();

/// Adds triangles with their references as patches.
class Triangles {
 public:
  void add(const Triangle& triangle, std::int64_t reference) {
    surface.triangles.push_back(triangle);
    surface.patch_of_triangle.push_back(
        patches_.number_of("reference " + std::to_string(reference)));
  }
  SurfaceMesh take() {
    surface.patch_names = patches_.take();
    keep_used_vertices(surface);
    return std::move(surface);
  }

  SurfaceMesh surface;

 private:
  PatchNames patches_;
};

class TextReader {
 public:
  TextReader(std::string_view bytes, const std::string& name) : in_(bytes, name, '#') {}

  SurfaceMesh read() {
    in_.expect(text_start);
    in_.integer("the version");
    in_.expect("Dimension");
    if (in_.integer("the dimension") != 3) in_.fail("the mesh is not three-dimensional");
    while (!in_.at_end()) {
      const std::string_view word = in_.word();
      if (word == "End") break;
      if (word == "Vertices") {
        read_vertices(list_length());
      } else if (word == "Triangles") {
        read_triangles(list_length());
      } else if (word == "Quadrilaterals" && list_length() > 0) {
        in_.fail(std::string(has_quadrangles));
      }
      // Numbers and the names of other lists are passed over, word by word.
    }
    return triangles_.take();
  }

 private:
  std::size_t list_length() { return in_.to_count(in_.integer("the length of a list"), 8); }

  void read_vertices(std::size_t count) {
    SurfaceMesh& surface = triangles_.surface;
    if (count > most_vertices - surface.vertices.size()) in_.fail(std::string(too_many));
    for (std::size_t i = 0; i < count; ++i) {
      const double x = in_.coordinate();
      const double y = in_.coordinate();
      surface.vertices.push_back({x, y, in_.coordinate()});
      in_.integer("a reference");
    }
  }

  void read_triangles(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      Triangle triangle;
      for (std::int32_t& v : triangle) {
        v = vertex_of(in_, triangles_.surface, in_.integer("a vertex number"), 1);
      }
      triangles_.add(triangle, in_.integer("a reference"));
    }
  }

  InputScanner in_;
  Triangles triangles_;
};

SurfaceMesh read_binary(const MeditFile& file) {
  if (file.count(medit::quadrangles) > 0) {
    file.fail_at(medit::quadrangles, std::string(has_quadrangles));
  }
  const std::int64_t vertices = file.count(medit::vertices);
  if (vertices > most_vertices) file.fail_at(medit::vertices, std::string(too_many));
  Triangles triangles;
  triangles.surface.vertices.resize(static_cast<std::size_t>(vertices));
  file.read_vertices(0, triangles.surface.vertices);
  std::vector<std::array<std::int64_t, 4>> records(
      static_cast<std::size_t>(file.count(medit::triangles)));
  file.read_elements<4>(medit::triangles, 0, records);
  for (std::size_t t = 0; t < records.size(); ++t) {
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      if (records[t][k] < 1 || records[t][k] > vertices) {
        file.fail_at(medit::triangles, static_cast<std::int64_t>(t),
                     "vertex " + std::to_string(records[t][k]) + " of " + std::to_string(vertices) +
                         " (counted from 1)");
      }
      triangle[k] = static_cast<std::int32_t>(records[t][k] - 1);
    }
    triangles.add(triangle, records[t][3]);
  }
  return triangles.take();
}

}  // namespace

SurfaceMesh read_medit(std::string_view bytes, const std::string& name) {
  const bool is_text = bytes.substr(0, 200).find(text_start) != bytes.npos;
  return is_text ? TextReader(bytes, name).read() : read_binary({bytes, name});
}

}  // namespace tetfarm
