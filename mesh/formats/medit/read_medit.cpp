#include "mesh/formats/medit/read_medit.h"

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "mesh/formats/input_scanner.h"
#include "mesh/formats/medit/medit_file.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/polygon_triangles.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

constexpr std::string_view text_start = "MeshVersionFormatted";
constexpr std::string_view too_many = "too many vertices";
constexpr std::int64_t most_vertices = std::numeric_limits<std::int32_t>::max();

/// Adds triangles and quadrangles with their references as patches.
class Faces {
 public:
  void add(std::span<const std::int32_t> corners, std::int64_t reference) {
    const std::size_t triangles = add_polygon(surface, corners);
    surface.patch_of_triangle.insert(surface.patch_of_triangle.end(), triangles,
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
    if (in_.integer("the dimension") != 3) in_.fail(std::string(medit::not_of_space));
    while (!in_.at_end()) {
      const std::string_view word = in_.word();
      if (word == "End") break;
      if (word == "Vertices") {
        read_vertices(list_length());
      } else if (word == "Triangles") {
        read_faces<3>(list_length());
      } else if (word == "Quadrilaterals") {
        read_faces<4>(list_length());
      }
      // Numbers and the names of other lists are passed over, word by word.
    }
    return faces_.take();
  }

 private:
  std::size_t list_length() { return in_.to_count(in_.integer("the length of a list"), 8); }

  void read_vertices(std::size_t count) {
    SurfaceMesh& surface = faces_.surface;
    if (count > most_vertices - surface.vertices.size()) in_.fail(std::string(too_many));
    for (std::size_t i = 0; i < count; ++i) {
      const double x = in_.coordinate();
      const double y = in_.coordinate();
      surface.vertices.push_back({x, y, in_.coordinate()});
      in_.integer("a reference");
    }
  }

  template <std::size_t N>
  void read_faces(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      std::array<std::int32_t, N> corners{};
      for (std::int32_t& v : corners) {
        v = vertex_of(in_, faces_.surface, in_.integer("a vertex number"), 1);
      }
      faces_.add(corners, in_.integer("a reference"));
    }
  }

  InputScanner in_;
  Faces faces_;
};

/// Of a list whose faces have N corners.
template <std::size_t N>
void read_faces(const MeditFile& file, medit::Keyword list, Faces& faces) {
  const std::int64_t vertices = file.count(medit::vertices);
  std::vector<std::array<std::int64_t, N + 1>> records(static_cast<std::size_t>(file.count(list)));
  file.read_elements<N + 1>(list, 0, records);
  for (std::size_t i = 0; i < records.size(); ++i) {
    std::array<std::int32_t, N> corners{};
    for (std::size_t k = 0; k < N; ++k) {
      if (records[i][k] < 1 || records[i][k] > vertices) {
        file.fail_at(list, static_cast<std::int64_t>(i),
                     "vertex " + std::to_string(records[i][k]) + " of " + std::to_string(vertices) +
                         " (counted from 1)");
      }
      corners[k] = static_cast<std::int32_t>(records[i][k] - 1);
    }
    faces.add(corners, records[i][N]);
  }
}

SurfaceMesh read_binary(const MeditFile& file) {
  const std::int64_t vertices = file.count(medit::vertices);
  if (vertices > most_vertices) file.fail_at(medit::vertices, std::string(too_many));
  Faces faces;
  faces.surface.vertices.resize(static_cast<std::size_t>(vertices));
  file.read_vertices(0, faces.surface.vertices);
  read_faces<3>(file, medit::triangles, faces);
  read_faces<4>(file, medit::quadrangles, faces);
  return faces.take();
}

}  // namespace

SurfaceMesh read_medit(std::string_view bytes, const std::string& name) {
  const bool is_text = bytes.substr(0, 200).find(text_start) != bytes.npos;
  return is_text ? TextReader(bytes, name).read() : read_binary({bytes, name});
}

}  // namespace tetfarm
