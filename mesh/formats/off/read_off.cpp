#include "mesh/formats/off/read_off.h"

#include <limits>
#include <vector>

#include "base/check.h"
#include "mesh/formats/input_scanner.h"
#include "mesh/formats/polygon_triangles.h"

namespace tetfarm {
namespace {

void read_faces(InputScanner& scanner, std::size_t faces, SurfaceMesh& surface) {
  const auto vertex = [&] {
    const std::int64_t number = scanner.integer("a vertex number");
    if (number < 0 || number >= static_cast<std::int64_t>(surface.vertices.size())) {
      scanner.fail("vertex " + std::to_string(number) + " of " +
                   std::to_string(surface.vertices.size()) + " (counted from 0)");
    }
    return static_cast<std::int32_t>(number);
  };
  surface.triangles.reserve(faces);
  std::vector<std::int32_t> polygon;
  for (std::size_t i = 0; i < faces; ++i) {
    const std::int64_t corners = scanner.integer("the number of vertices of a face");
    if (corners < 3) scanner.fail("a face with " + std::to_string(corners) + " vertices");
    polygon.clear();
    for (std::int64_t corner = 0; corner < corners; ++corner) polygon.push_back(vertex());
    add_polygon(surface, polygon);
    scanner.rest_of_line();
  }
  TF_CHECK(surface.triangles.size() >= faces);
}

}  // namespace

SurfaceMesh read_off(std::string_view bytes, const std::string& name) {
  constexpr std::size_t shortest_line = 6;  // "0 0 0\n"
  InputScanner scanner(bytes, name, '#');
  const std::string_view keyword = scanner.word();
  if (keyword != "OFF" && keyword != "COFF" && keyword != "NOFF" && keyword != "CNOFF") {
    scanner.fail("expected OFF, found " + quoted(keyword));
  }
  const std::string_view first = scanner.word();
  if (first == "BINARY") scanner.fail("is binary, which is not supported; save it as text");
  const std::int64_t vertex_count = scanner.to_integer(first, "the number of vertices");
  const std::int64_t face_count = scanner.integer("the number of faces");
  const std::size_t vertices = scanner.to_count(vertex_count, shortest_line);
  const std::size_t faces = scanner.to_count(face_count, shortest_line);
  if (vertices > std::numeric_limits<std::int32_t>::max()) scanner.fail("too many vertices");
  scanner.rest_of_line();  // the number of edges, which nobody counts

  SurfaceMesh surface;
  surface.vertices.reserve(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    const double x = scanner.coordinate();
    const double y = scanner.coordinate_in_line();
    surface.vertices.push_back({x, y, scanner.coordinate_in_line()});
    scanner.rest_of_line();
  }
  read_faces(scanner, faces, surface);
  if (!scanner.at_end()) {
    scanner.fail("more text after the last face: " + quoted(scanner.word()));
  }
  return surface;
}

}  // namespace tetfarm
