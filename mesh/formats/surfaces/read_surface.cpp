#include "mesh/formats/surfaces/read_surface.h"

#include "base/check.h"
#include "base/counted.h"
#include "base/error.h"
#include "mesh/formats/gzip.h"
#include "mesh/formats/open_edge_welding.h"
#include "mesh/formats/patch_names.h"
#include "mesh/formats/surfaces/surface_formats.h"

namespace tetfarm {

SurfaceMesh read_surface(const std::string& path) {
  surface_format_of(path);  // a wrong ending is told before a large file is read
  return read_surface_bytes(read_maybe_gzip(path), path);
}

SurfaceMesh read_surface_bytes(std::string_view bytes, const std::string& name) {
  const Format& format = surface_format_of(name);
  if (bytes.empty()) throw InvalidInput("the file is empty", name);
  SurfaceMesh surface = format.read_surface(bytes, name);
  if (surface.triangles.empty()) {
    const std::size_t points = surface.vertices.size();
    throw InvalidInput(points == 0 ? "the file has no triangles"
                                   : "the file has " + counted(points, "point") +
                                         ", but no triangles: make a surface of them first",
                       name);
  }
  weld_open_edges(surface);
  if (surface.patch_names.empty()) {
    surface.patch_names = {std::string(unnamed_patch)};
    surface.patch_of_triangle.assign(surface.triangles.size(), 0);
  }
  TF_CHECK(surface.patch_of_triangle.size() == surface.triangles.size());
  return surface;
}

std::string read_maybe_gzip(const std::string& path) {
  std::string bytes = read_whole_file(path);
  return is_gzip(bytes) ? unpack_gzip(bytes, path) : bytes;
}

}  // namespace tetfarm
