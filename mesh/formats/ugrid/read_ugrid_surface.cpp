#include "mesh/formats/ugrid/read_ugrid_surface.h"

#include <array>
#include <limits>
#include <vector>

#include "mesh/formats/input_scanner.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/polygon_triangles.h"
#include "mesh/formats/ugrid/ugrid_file.h"
#include "mesh/formats/used_vertices.h"

namespace tetfarm {
namespace {

constexpr std::int64_t most_vertices = std::numeric_limits<std::int32_t>::max();

/// Of the next face, which gave so many triangles.
void add_patch(SurfaceMesh& surface, PatchNames& patches, std::size_t triangles,
               std::int64_t number) {
  surface.patch_of_triangle.insert(surface.patch_of_triangle.end(), triangles,
                                   patches.number_of("patch " + std::to_string(number)));
}

SurfaceMesh read_text(std::string_view bytes, const std::string& name) {
  InputScanner in(bytes, name);
  std::array<std::int64_t, 7> counts{};
  for (std::int64_t& count : counts) {
    count = in.integer("a count");
    if (count < 0) in.fail("a count is negative");
  }
  const std::size_t nodes = in.to_count(counts[0], 6);
  const std::size_t triangles = in.to_count(counts[1], 8);
  const std::size_t quadrangles = in.to_count(counts[2], 10);
  if (counts[0] > most_vertices) in.fail("too many nodes");
  SurfaceMesh surface;
  for (std::size_t i = 0; i < nodes; ++i) {
    const double x = in.coordinate();
    const double y = in.coordinate();
    surface.vertices.push_back({x, y, in.coordinate()});
  }
  for (std::size_t i = 0; i < triangles; ++i) {
    Triangle triangle;
    for (std::int32_t& v : triangle) v = vertex_of(in, surface, in.integer("a node number"), 1);
    surface.triangles.push_back(triangle);
  }
  for (std::size_t i = 0; i < quadrangles; ++i) {
    std::array<std::int32_t, 4> corners{};
    for (std::int32_t& v : corners) v = vertex_of(in, surface, in.integer("a node number"), 1);
    add_polygon(surface, corners);
  }
  PatchNames patches;
  for (std::size_t i = 0; i < triangles + quadrangles; ++i) {
    add_patch(surface, patches, i < triangles ? 1 : 2, in.integer("a patch number"));
  }
  surface.patch_names = patches.take();
  return surface;
}

void read_quadrangles(const UgridFile& file, SurfaceMesh& surface) {
  const std::int64_t nodes = file.counts().nodes;
  std::vector<std::int64_t> read(4 * static_cast<std::size_t>(file.counts().quadrangles));
  file.read_elements(ElementType::quad, 0, read);
  for (std::size_t first = 0; first < read.size(); first += 4) {
    std::array<std::int32_t, 4> corners{};
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int64_t node = read[first + k];
      if (node < 1 || node > nodes) {
        file.fail_at_quadrangle(
            "vertex " + std::to_string(node) + " of " + std::to_string(nodes) + " (counted from 1)",
            static_cast<std::int64_t>(first / 4));
      }
      corners[k] = static_cast<std::int32_t>(node - 1);
    }
    add_polygon(surface, corners);
  }
}

SurfaceMesh read_binary(const UgridFile& file) {
  const UgridListCounts& counts = file.counts();
  if (counts.nodes > most_vertices) file.fail_at_counts("too many nodes");
  const auto triangles = static_cast<std::size_t>(counts.triangles);
  SurfaceMesh surface;
  surface.vertices.resize(static_cast<std::size_t>(counts.nodes));
  file.read_nodes(0, surface.vertices);
  std::vector<std::array<std::int64_t, 3>> corners(triangles);
  file.read_triangles(0, corners);
  for (std::size_t t = 0; t < triangles; ++t) {
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t node = corners[t][k];
      if (node < 1 || node > counts.nodes) {
        file.fail_at_corner("vertex " + std::to_string(node) + " of " +
                                std::to_string(counts.nodes) + " (counted from 1)",
                            static_cast<std::int64_t>(t), k);
      }
      triangle[k] = static_cast<std::int32_t>(node - 1);
    }
    surface.triangles.push_back(triangle);
  }
  read_quadrangles(file, surface);
  std::vector<std::int64_t> numbers(triangles + static_cast<std::size_t>(counts.quadrangles));
  file.read_patches(0, numbers);
  PatchNames patches;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    add_patch(surface, patches, i < triangles ? 1 : 2, numbers[i]);
  }
  surface.patch_names = patches.take();
  return surface;
}

}  // namespace

SurfaceMesh read_ugrid_surface(std::string_view bytes, const std::string& name) {
  const std::optional<UgridForm> form = ugrid_form(name);
  SurfaceMesh surface = form ? read_binary({bytes, name, *form}) : read_text(bytes, name);
  keep_used_vertices(surface);
  return surface;
}

}  // namespace tetfarm
