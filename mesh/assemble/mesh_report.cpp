#include "mesh/assemble/mesh_report.h"

#include "base/error.h"
#include "mesh/assemble/mesh_digest.h"
#include "mesh/assemble/read_ugrid.h"
#include "mesh/assemble/read_vtkhdf.h"
#include "mesh/core/validate.h"

namespace tetfarm {
namespace {

bool all_nodes_exist(const GlobalMesh& mesh) {
  const auto exists = [&](std::int32_t v) {
    return v >= 0 && static_cast<std::size_t>(v) < mesh.mesh.nodes.size();
  };
  for (const Tet& tet : mesh.mesh.tets) {
    for (const std::int32_t v : tet) {
      if (!exists(v)) return false;
    }
  }
  for (const Triangle& triangle : mesh.boundary) {
    for (const std::int32_t v : triangle) {
      if (!exists(v)) return false;
    }
  }
  return true;
}

void add_figures(const GlobalMesh& mesh, MeshReport& report) {
  MeshDigest digest;
  for (std::size_t v = 0; v < mesh.mesh.nodes.size(); ++v) {
    digest.add_node(static_cast<std::int64_t>(v), mesh.mesh.nodes[v]);
  }
  for (const Tet& tet : mesh.mesh.tets) {
    const auto node = [&](std::size_t i) -> const Vec3& {
      return mesh.mesh.nodes[static_cast<std::size_t>(tet[i])];
    };
    digest.add_tet({tet[0], tet[1], tet[2], tet[3]});
    report.volume += tet_volume(node(0), node(1), node(2), node(3));
    report.shapes.add(node(0), node(1), node(2), node(3));
  }
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i) {
    const auto& [a, b, c] = mesh.boundary[i];
    digest.add_boundary_triangle({a, b, c}, mesh.patch_of_triangle[i]);
  }
  report.enclosed_volume = enclosed_volume(mesh.mesh.nodes, mesh.boundary);
  report.forced = forced_dihedral(mesh.mesh.nodes, mesh.boundary);
  report.digest = digest.finish();
}

}  // namespace

GlobalMesh read_global_mesh(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  if (name.ends_with(".vtkhdf") || name.ends_with(".hdf")) return read_vtkhdf(path);
  if (name.ends_with(".lb8.ugrid")) return read_ugrid(path);
  throw InvalidInput("not a mesh file: .vtkhdf and .lb8.ugrid are read", path.string());
}

MeshReport report_on(const GlobalMesh& mesh) {
  MeshReport report;
  report.nodes = std::ssize(mesh.mesh.nodes);
  report.tets = std::ssize(mesh.mesh.tets);
  report.boundary_triangles = std::ssize(mesh.boundary);
  report.subdomains = mesh.subdomains;
  report.complaints = validate(mesh.mesh, mesh.boundary);
  if (all_nodes_exist(mesh)) add_figures(mesh, report);
  return report;
}

}  // namespace tetfarm
