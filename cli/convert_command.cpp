#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/counted.h"
#include "cli/commands.h"
#include "json/json_line.h"
#include "mesh/formats/surfaces/read_surface.h"
#include "mesh/formats/surfaces/write_surface.h"
#include "mesh/shapes/boxed_body.h"
#include "mesh/shapes/refined_surface.h"

namespace tetfarm {
namespace {

SurfaceMesh converted(const ConvertCommand& command) {
  SurfaceMesh surface = read_surface(command.input);
  if (command.scale != 1) {
    for (Vec3& vertex : surface.vertices) vertex *= command.scale;
  }
  if (command.max_edge > 0) surface = refined_surface(surface, command.max_edge);
  if (command.box > 0) surface = boxed_body(surface, {command.box, command.box_size});
  return surface;
}

}  // namespace

ExitCode convert_command(const ConvertCommand& command) {
  const SurfaceMesh surface = converted(command);
  write_surface(surface, command.output);
  if (command.json) {
    std::printf("%s\n", json_line({{"type", "convert"},
                                   {"file", command.output},
                                   {"vertices", surface.vertices.size()},
                                   {"triangles", surface.triangles.size()},
                                   {"patches", surface.patch_names}})
                            .c_str());
  } else {
    std::printf("%s: %zu triangles, %zu vertices, %s\n", command.output.c_str(),
                surface.triangles.size(), surface.vertices.size(),
                counted(surface.patch_names.size(), "patch", "patches").c_str());
  }
  return ExitCode::ok;
}

}  // namespace tetfarm
