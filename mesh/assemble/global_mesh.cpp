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
        is_side_known_(2 * surface.triangles.size(), false) {}

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

  /// Once for each region that the triangle bounds, turned to point out of it.
  void meet_surface_triangle(const Subdomain& subdomain, std::size_t t,
                             const std::vector<std::int64_t>& local2global) {
    const std::uint32_t index = subdomain.triangle_origin[t].index;
    if (index >= surface_.triangles.size()) refuse(subdomain, "unknown triangle of the surface");
    const Sides sides = sides_of(surface_, index);
    const std::size_t side = sides[0] == subdomain.region ? 0 : 1;
    if (sides[side] != subdomain.region) refuse(subdomain, "a surface triangle of another region");
    if (is_side_known_[2 * index + side]) {
      refuse(subdomain, "a surface triangle is in two sub-domains");
    }
    is_side_known_[2 * index + side] = true;
    Triangle nodes = surface_.triangles[index];
    if (side == 1) std::swap(nodes[1], nodes[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const Origin vertex{0, static_cast<std::uint32_t>(nodes[i])};
      if (global_number(numbering_, vertex) != local2global[at(subdomain.triangles[t][i])]) {
        refuse(subdomain, "a surface triangle has other nodes than in the input");
      }
    }
  }

  void finish() const {
    const auto check = [](bool is_right, const std::string& what) {
      if (!is_right) throw Error(ExitCode::failed, "the parts do not fit together: " + what);
    };
    for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
      const Sides sides = sides_of(surface_, t);
      check(
          (is_side_known_[2 * t] || sides[0] == 0) && (is_side_known_[2 * t + 1] || sides[1] == 0),
          "a triangle of the surface is in no sub-domain");
    }
    check(std::find(is_node_known_.begin(), is_node_known_.end(), false) == is_node_known_.end(),
          "a node is in no sub-domain");
  }

 private:
  const SurfaceMesh& surface_;
  const Numbering& numbering_;
  std::vector<bool> is_node_known_;
  std::vector<bool> is_side_known_;  // 2 t: behind triangle t, 2 t + 1: in front
};

void check_counts(const MeshPart& part, const LeafNumbers& leaf) {
  const Subdomain& subdomain = part.subdomain;
  const TetMesh& mesh = part.mesh;
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
  result.region = part.subdomain.region;
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

void add_elements(const MeshPart& read, const NumberedPart& part, MeshDigest& digest,
                  GlobalMeshSummary& summary) {
  std::vector<bool> is_on_cut = read.is_on_cut;
  is_on_cut.resize(part.nodes.size(), false);
  add_shapes(part.nodes, part.tets, part.region, std::move(is_on_cut), summary.shapes);
  for (const Tet& tet : part.tets) digest.add_tet(global_nodes(tet, part));
  for (std::size_t i = 0; i < part.faces.size(); ++i) {
    digest.add_boundary_triangle(global_nodes(part.faces[i], part), part.patch_of_face[i]);
  }
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

std::vector<bool> nodes_on_cuts(const Subdomain& subdomain) {
  std::vector<bool> is_on_cut(subdomain.vertices.size(), false);
  for (std::size_t t = 0; t < subdomain.triangles.size(); ++t) {
    if (subdomain.triangle_origin[t].owner == 0) continue;
    for (const std::int32_t v : subdomain.triangles[t]) is_on_cut[at(v)] = true;
  }
  return is_on_cut;
}

GlobalMeshSummary assemble_global_mesh(const SurfaceMesh& surface, const Numbering& numbering,
                                       const ReadPart& read_part,
                                       std::span<GlobalMeshWriter* const> writers) {
  GlobalMeshSummary summary;
  summary.nodes = numbering.nodes;
  summary.tets = numbering.tets;
  summary.boundary_triangles = meshed_sides(surface);
  summary.subdomains = static_cast<std::int32_t>(numbering.leaves.size());
  Interfaces interfaces(surface, numbering);
  MeshDigest digest;
  FaceBalance faces;
  for (std::size_t i = 0; i < numbering.leaves.size(); ++i) {
    MeshPart read = read_part(numbering.leaves[i]);
    check_counts(read, numbering.leaves[i]);
    const NumberedPart part = numbered_part(read, surface, numbering, i, interfaces);
    add_nodes(read.subdomain, part, interfaces, digest);
    add_elements(read, part, digest, summary);
    faces.add(part);
    for (GlobalMeshWriter* writer : writers) writer->add(part);
  }
  interfaces.finish();
  if (!faces.is_even()) {
    throw Error(ExitCode::failed,
                "the parts do not fit together: faces of neighbours differ, or their nodes");
  }
  for (const RegionShapes& region : summary.shapes.regions) summary.volume += region.volume;
  summary.enclosed_volume = domain_volume(surface);
  if (!(std::abs(summary.volume - summary.enclosed_volume) <= 1e-9 * summary.enclosed_volume)) {
    throw Error(ExitCode::failed, "the volumes of the tets do not add up to that of the domain");
  }
  for (GlobalMeshWriter* writer : writers) writer->finish();
  summary.digest = digest.finish();
  return summary;
}

}  // namespace tetfarm
