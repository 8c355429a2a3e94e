#include <cstdio>

#include "cli/commands.h"
#include "mesh/formats/surfaces/write_surface.h"
#include "mesh/shapes/make_shape.h"

namespace tetfarm {

ExitCode shape_command(const ShapeCommand& command) {
  const SurfaceMesh surface = make_shape(command.name, {command.spacing, command.growth});
  write_surface(surface, command.output);
  std::fprintf(stderr, "%s: %zu triangles, %zu vertices\n", command.output.c_str(),
               surface.triangles.size(), surface.vertices.size());
  return ExitCode::ok;
}

}  // namespace tetfarm
