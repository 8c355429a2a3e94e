#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "mesh/formats/export_mesh.h"
#include "mesh/io/read_surface.h"
#include "mesh/io/write_surface.h"

namespace tetfarm {

ExitCode export_command(const ExportCommand& command) {
  const MeshFormat& format = find_mesh_format(command.format, command.output);
  const std::filesystem::path file = mesh_file(command.input);
  const ExportCounts counts = export_mesh(*open_mesh(file), format, command.output);
  if (command.json) {
    std::printf("%s\n", nlohmann::ordered_json({{"type", "export"},
                                                {"file", command.output},
                                                {"format", format.name},
                                                {"nodes", counts.nodes},
                                                {"elements", counts.tets},
                                                {"boundary_triangles", counts.boundary_triangles},
                                                {"subdomains", counts.parts}})
                            .dump()
                            .c_str());
  } else {
    std::printf("%s: %s; %lld tets, %lld nodes, %lld boundary triangles\n", command.output.c_str(),
                std::string(format.what).c_str(), static_cast<long long>(counts.tets),
                static_cast<long long>(counts.nodes),
                static_cast<long long>(counts.boundary_triangles));
  }
  return ExitCode::ok;
}

ExitCode convert_command(const ConvertCommand& command) {
  const SurfaceMesh surface = read_surface(command.input);
  write_surface(surface, command.output);
  if (command.json) {
    std::printf("%s\n", nlohmann::ordered_json({{"type", "convert"},
                                                {"file", command.output},
                                                {"vertices", surface.vertices.size()},
                                                {"triangles", surface.triangles.size()},
                                                {"patches", surface.patch_names}})
                            .dump()
                            .c_str());
  } else {
    std::printf("%s: %zu triangles, %zu vertices, %zu patches\n", command.output.c_str(),
                surface.triangles.size(), surface.vertices.size(), surface.patch_names.size());
  }
  return ExitCode::ok;
}

}  // namespace tetfarm
