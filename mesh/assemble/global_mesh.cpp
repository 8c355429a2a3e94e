#include "mesh/assemble/global_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/error.h"
#include "mesh/assemble/face_balance.h"
#include "mesh/assemble/mesh_digest.h"

namespace tetfarm {
namespace {

std::size_t at(std::int64_t index) { return static_cast<std::size_t>(index); }

[[noreturn]] void refuse(const Subdomain& subdomain, const std::string& what) {
  throw Error(ExitCode::failed,
              "the parts do not fit together: sub-domain " + subdomain.path.text() + ": " + what);
}

bool same_bits(const Vec3& a, const Vec3& b) {
  const auto same = [](double s, double t) {
    return std::bit_cast<std::uint64_t>(s) == std::bit_cast<std::uint64_t>(t);
  };
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

/// What the sub-domains have of the surface and of the nodes, checked as they pass.
class Interfaces {
 public:
  Interfaces(const SurfaceMesh& surface, const Numbering& numbering)
      : surface_(surface),
        numbering_(numbering),
        is_node_known_(at(numbering.nodes), false),
        is_triangle_known_(surface.triangles.size(), false) {}

  /// A node of the surface lies where the surface has it.
  void meet_surface_node(const Subdomain& subdomain, const Origin& origin, const Vec3& here) {
    if (!same_bits(here, surface_.vertices[origin.index])) {
      refuse(subdomain, "a node lies elsewhere than in the input surface");
    }
  }

  /// True when the node is met for the first time.
  bool meet_node(std::int64_t number) {
    const bool is_new = !is_node_known_[at(number)];
    is_node_known_[at(number)] = true;
    return is_new;
  }

  void meet_surface_triangle(const Subdomain& subdomain, std::size_t t,
                             const std::vector<std::int64_t>& local2global) {
    const std::uint32_t index = subdomain.triangle_origin[t].index;
    if (index >= is_triangle_known_.size()) refuse(subdomain, "unknown triangle of the surface");
    if (is_triangle_known_[index]) refuse(subdomain, "a surface triangle is in two sub-domains");
    is_triangle_known_[index] = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const Origin vertex{0, static_cast<std::uint32_t>(surface_.triangles[index][i])};
      if (global_number(numbering_, vertex) != local2global[at(subdomain.triangles[t][i])]) {
        refuse(subdomain, "a surface triangle has other nodes than in the input");
      }
    }
  }

  void finish() const {
    const auto check = [](bool is_right, const std::string& what) {
      if (!is_right) throw Error(ExitCode::failed, "the parts do not fit together: " + what);
    };
    const auto all = [](const std::vector<bool>& known) {
      return std::find(known.begin(), known.end(), false) == known.end();
    };
    check(all(is_triangle_known_), "a triangle of the surface is in no sub-domain");
    check(all(is_node_known_), "a node is in no sub-domain");
  }

 private:
  const SurfaceMesh& surface_;
  const Numbering& numbering_;
  std::vector<bool> is_node_known_;
  std::vector<bool> is_triangle_known_;
};

void check_counts(const MeshPart& part, const LeafNumbers& leaf) {
  const auto& [subdomain, mesh] = part;
  if (subdomain.path != leaf.path) refuse(subdomain, "expected " + leaf.path.text());
  if (at(mesh.boundary_nodes) != subdomain.vertices.size() ||
      subdomain.node_origin.size() != subdomain.vertices.size() ||
      std::ssize(mesh.nodes) - mesh.boundary_nodes > leaf.nodes.kept() ||
      std::ssize(mesh.tets) != leaf.tets) {
    refuse(subdomain, "other counts than in the numbering");
  }
}

std::vector<std::int64_t> local2global_of(const MeshPart& part, const Numbering& numbering,
                                          const LeafNumbers& leaf) {
  std::vector<std::int64_t> numbers;
  numbers.reserve(part.mesh.nodes.size());
  for (const Origin& origin : part.subdomain.node_origin) {
    numbers.push_back(global_number(numbering, origin));
  }
  const std::int64_t interior = std::ssize(part.mesh.nodes) - part.mesh.boundary_nodes;
  for (std::int64_t i = 0; i < interior; ++i) numbers.push_back(leaf.nodes.first_node + i);
  return numbers;
}

/// Takes the mesh out of `part`, and leaves the sub-domain.
NumberedPart numbered_part(MeshPart& part, const SurfaceMesh& surface, const Numbering& numbering,
                           std::size_t number, Interfaces& interfaces) {
  NumberedPart result;
  result.number = static_cast<std::int32_t>(number);
  result.local2global = local2global_of(part, numbering, numbering.leaves[number]);
  const Subdomain& subdomain = part.subdomain;
  for (std::size_t t = 0; t < subdomain.triangles.size(); ++t) {
    if (subdomain.triangle_origin[t].owner != 0) continue;
    interfaces.meet_surface_triangle(subdomain, t, result.local2global);
    const std::uint32_t index = subdomain.triangle_origin[t].index;
    const auto& patches = surface.patch_of_triangle;
    result.faces.push_back(subdomain.triangles[t]);
    result.patch_of_face.push_back(patches.empty() ? 0 : patches[index]);
  }
  result.nodes = std::move(part.mesh.nodes);
  result.tets = std::move(part.mesh.tets);
  return result;
}

template <std::size_t N>
std::array<std::int64_t, N> global_nodes(const std::array<std::int32_t, N>& local,
                                         const NumberedPart& part) {
  std::array<std::int64_t, N> global;
  for (std::size_t i = 0; i < N; ++i) global[i] = part.local2global[at(local[i])];
  return global;
}

void add_elements(const NumberedPart& part, MeshDigest& digest, GlobalMeshSummary& summary) {
  double volume = 0;
  for (const Tet& tet : part.tets) {
    const auto node = [&](std::size_t i) -> const Vec3& { return part.nodes[at(tet[i])]; };
    volume += tet_volume(node(0), node(1), node(2), node(3));
    summary.shapes.add(node(0), node(1), node(2), node(3));
    digest.add_tet(global_nodes(tet, part));
  }
  for (std::size_t i = 0; i < part.faces.size(); ++i) {
    digest.add_boundary_triangle(global_nodes(part.faces[i], part), part.patch_of_face[i]);
  }
  summary.volume += volume;
}

void add_nodes(const Subdomain& subdomain, const NumberedPart& part, Interfaces& interfaces,
               MeshDigest& digest) {
  for (std::size_t v = 0; v < part.nodes.size(); ++v) {
    if (v < subdomain.node_origin.size() && subdomain.node_origin[v].owner == 0) {
      interfaces.meet_surface_node(subdomain, subdomain.node_origin[v], part.nodes[v]);
    }
    if (interfaces.meet_node(part.local2global[v]))
      digest.add_node(part.local2global[v], part.nodes[v]);
  }
}

}  // namespace

GlobalMeshSummary assemble_global_mesh(const SurfaceMesh& surface, const Numbering& numbering,
                                       const ReadPart& read_part,
                                       std::span<GlobalMeshWriter* const> writers) {
  GlobalMeshSummary summary;
  summary.nodes = numbering.nodes;
  summary.tets = numbering.tets;
  summary.boundary_triangles = std::ssize(surface.triangles);
  summary.subdomains = static_cast<std::int32_t>(numbering.leaves.size());
  Interfaces interfaces(surface, numbering);
  MeshDigest digest;
  FaceBalance faces;
  for (std::size_t i = 0; i < numbering.leaves.size(); ++i) {
    MeshPart read = read_part(numbering.leaves[i]);
    check_counts(read, numbering.leaves[i]);
    const NumberedPart part = numbered_part(read, surface, numbering, i, interfaces);
    add_nodes(read.subdomain, part, interfaces, digest);
    add_elements(part, digest, summary);
    faces.add(part);
    for (GlobalMeshWriter* writer : writers) writer->add(part);
  }
  interfaces.finish();
  if (!faces.is_even()) {
    throw Error(ExitCode::failed,
                "the parts do not fit together: faces of neighbours differ, or their nodes");
  }
  summary.enclosed_volume = enclosed_volume(surface.vertices, surface.triangles);
  if (!(std::abs(summary.volume - summary.enclosed_volume) <= 1e-9 * summary.enclosed_volume)) {
    throw Error(ExitCode::failed, "the volumes of the tets do not add up to that of the domain");
  }
  for (GlobalMeshWriter* writer : writers) writer->finish();
  summary.digest = digest.finish();
  return summary;
}

}  // namespace tetfarm
