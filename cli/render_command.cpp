#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "base/error.h"
#include "base/file_system.h"
#include "cli/commands.h"
#include "cli/mesh_input.h"
#include "cli/picture_options.h"
#include "cli/render_plane.h"
#include "mesh/formats/mesh_source.h"
#include "mesh/render/render_mesh.h"

namespace tetfarm {
namespace {

Vec3 direction(const std::vector<double>& numbers, const char* option) {
  const Vec3 v{numbers[0], numbers[1], numbers[2]};
  if (!(norm2(v) > 0)) throw UsageError("must not be 0, 0, 0", option);
  return v;
}

View view_of(const std::string& name) {
  return name == "cut"        ? View::cut
         : name == "exploded" ? View::exploded
         : name == "slice"    ? View::slice
                              : View::surface;
}

ColourBy colour_by(const std::string& name) {
  return name == "region"  ? ColourBy::region
         : name == "patch" ? ColourBy::patch
         : name == "layer" ? ColourBy::layer
                           : ColourBy::subdomain;
}

bool shows_cells(View view) { return view == View::cut || view == View::slice; }

/// The side of a plane from which drawings look at it: x from the front, y from the right, z from
/// above.
Vec3 before_plane(const Vec3& normal) {
  const bool is_across = std::abs(normal.y) > std::max(std::abs(normal.x), std::abs(normal.z));
  const double most = std::abs(normal.x) >= std::abs(normal.z) ? normal.x : normal.z;
  const bool is_before = is_across ? normal.y < 0 : most > 0;
  return is_before ? normal : -normal;
}

RenderOptions options_of(const RenderCommand& command) {
  RenderOptions options;
  options.view = view_of(command.view);
  options.colour_by = colour_by(command.colour);
  if (options.colour_by == ColourBy::layer && !shows_cells(options.view)) {
    throw UsageError("layers have colours in cuts and slices; give --view cut or --view slice",
                     "--colour layer");
  }
  std::tie(options.width, options.height) = picture_size(command.size);
  options.edge_width = command.edge_width.value_or(options.edge_width);
  options.camera.up = direction(command.up, "--up");
  options.camera.zoom = command.zoom;
  options.camera.across = command.across;
  options.bodies = command.bodies;
  options.hidden = command.hidden;
  options.cut_normal = direction(command.plane, "--plane");
  if (!command.from.empty()) {
    options.camera.from = direction(command.from, "--from");
  } else if (options.view == View::slice) {
    options.camera.from = before_plane(options.cut_normal);
  }
  if (command.centre.size() == 2) {
    throw UsageError("a place in space has three numbers: X,Y,Z", "--centre");
  }
  if (!command.centre.empty()) {
    options.camera.centre = Vec3{command.centre[0], command.centre[1], command.centre[2]};
  }
  options.cut_at = command.at;
  options.explosion = command.explode;
  return options;
}

/// Pieces of a file that does not know the sub-domains have one colour, and stay together.
Picture picture_of(const MeshSource& mesh, RenderOptions options) {
  if (options.colour_by == ColourBy::layer && mesh.cell_marks().empty()) {
    throw UsageError(
        "the mesh has no layers, or its file does not tell; the .vtkhdf file that a "
        "run writes does",
        "--colour layer");
  }
  const bool has_subdomains = mesh.knows_subdomains();
  if (!has_subdomains) options.explosion = 0;
  const auto for_each_part = [&](const auto& visit) {
    for (std::size_t i = 0; i < mesh.size(); ++i) {
      NumberedPart part = mesh.part(i);
      if (!has_subdomains) part.number = 0;
      visit(part);
    }
  };
  return render_mesh(for_each_part, mesh.patch_names(), options);
}

}  // namespace

ExitCode render_command(const RenderCommand& command) {
  if (is_plane_mesh_name(command.input)) return render_plane(command);
  require_no_plane_options(command);
  require_png(command.output);
  const RenderOptions options = options_of(command);
  const std::filesystem::path folder = std::filesystem::absolute(command.output).parent_path();
  const MeshInput mesh = find_mesh(command.input, command.source, folder);
  const Picture picture = picture_of(*open_mesh(mesh, folder), options);
  write_file_atomically(command.output, png_of(picture));
  return ExitCode::ok;
}

}  // namespace tetfarm
