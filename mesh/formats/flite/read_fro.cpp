#include "mesh/formats/flite/read_fro.h"

#include <limits>

#include "base/check.h"
#include "mesh/formats/input_scanner.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

/// Fortran writes the exponent of a double with D.
double fortran_number(InputScanner& scanner) {
  std::string word(scanner.word());
  for (char& c : word) {
    if (c == 'D' || c == 'd') c = 'e';
  }
  return scanner.to_coordinate(word);
}

void expect_number(InputScanner& scanner, std::size_t expected, std::string_view what) {
  const std::int64_t number = scanner.integer(what);
  if (number != static_cast<std::int64_t>(expected)) {
    scanner.fail("expected number " + std::to_string(expected) + ", found " +
                 std::to_string(number));
  }
}

}  // namespace

SurfaceMesh read_fro(std::string_view bytes, const std::string& name) {
  constexpr std::size_t shortest_line = 8;
  InputScanner scanner(bytes, name);
  const std::int64_t triangle_count = scanner.integer("the number of triangles");
  const std::int64_t node_count = scanner.integer("the number of nodes");
  scanner.rest_of_line();
  const std::size_t triangles = scanner.to_count(triangle_count, shortest_line);
  const std::size_t nodes = scanner.to_count(node_count, shortest_line);
  if (nodes > std::numeric_limits<std::int32_t>::max()) scanner.fail("too many nodes");
  SurfaceMesh surface;
  for (std::size_t i = 0; i < nodes; ++i) {
    expect_number(scanner, i + 1, "a node's number");
    const double x = fortran_number(scanner);
    const double y = fortran_number(scanner);
    surface.vertices.push_back({x, y, fortran_number(scanner)});
    scanner.rest_of_line();
  }
  PatchNames patches;
  for (std::size_t i = 0; i < triangles; ++i) {
    expect_number(scanner, i + 1, "a triangle's number");
    Triangle triangle;
    for (std::int32_t& v : triangle) {
      v = vertex_of(scanner, surface, scanner.integer("a node number"), 1);
    }
    surface.triangles.push_back(triangle);
    surface.patch_of_triangle.push_back(
        patches.number_of("surface " + std::to_string(scanner.integer("a surface number"))));
    scanner.rest_of_line();
  }
  TF_CHECK(surface.patch_of_triangle.size() == surface.triangles.size());
  surface.patch_names = patches.take();
  keep_used_vertices(surface);
  return surface;
}

}  // namespace tetfarm
