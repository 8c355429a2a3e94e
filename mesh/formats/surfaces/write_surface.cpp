#include "mesh/formats/surfaces/write_surface.h"

#include "base/check.h"
#include "base/error.h"
#include "base/file_system.h"
#include "mesh/formats/list/format_by_ending.h"
#include "mesh/formats/surfaces/surface_formats.h"

namespace tetfarm {

void write_surface(const SurfaceMesh& surface, const std::string& path) {
  const Format* format = format_by_ending(
      surface_formats(), path, [](const Format& known) { return known.write_surface != nullptr; });
  if (format == nullptr) {
    throw UsageError(
        "unsupported type of surface file; surfaces are written as " + writable_surfaces(), path);
  }
  TF_CHECK(surface.patch_of_triangle.empty() ||
           surface.patch_of_triangle.size() == surface.triangles.size());
  write_file_atomically(path, format->write_surface(surface));
}

}  // namespace tetfarm
