#include "mesh/assemble/global_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "base/error.h"
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

/// What sub-domains share, compared as they pass.
class Interfaces {
 public:
  Interfaces(const SurfaceMesh& surface, const Numbering& numbering)
      : surface_(surface),
        numbering_(numbering),
        nodes_(at(numbering.shared_nodes())),
        is_node_known_(nodes_.size(), false),
        is_triangle_known_(surface.triangles.size(), false) {}

  /// True when the node is met for the first time.
  bool meet_node(const Subdomain& subdomain, std::size_t v, std::int64_t number) {
    const Vec3& here = subdomain.vertices[v];
    const Origin& origin = subdomain.node_origin[v];
    if (origin.owner == 0 && !same_bits(here, surface_.vertices[origin.index])) {
      refuse(subdomain, "a node lies elsewhere than in the input surface");
    }
    if (is_node_known_[at(number)]) {
      if (!same_bits(here, nodes_[at(number)])) {
        refuse(subdomain, "a node lies elsewhere than in another sub-domain");
      }
      return false;
    }
    is_node_known_[at(number)] = true;
    nodes_[at(number)] = here;
    return true;
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

  /// Each inter-domain triangle has to come twice, in opposite directions: then its hash is added
  /// once and subtracted once.
  void meet_cut_triangle(const Subdomain& subdomain, std::size_t t,
                         const std::vector<std::int64_t>& local2global) {
    std::array<std::int64_t, 4> nodes = {subdomain.triangle_origin[t].index, 0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      nodes[i + 1] = local2global[at(subdomain.triangles[t][i])];
    }
    std::rotate(nodes.begin() + 1, std::min_element(nodes.begin() + 1, nodes.end()), nodes.end());
    const bool is_forward = nodes[2] < nodes[3];
    if (!is_forward) std::swap(nodes[2], nodes[3]);
    const std::uint64_t hash = hash128(nodes.data(), sizeof nodes).low;
    std::uint64_t& balance = cut_balance_[subdomain.triangle_origin[t].owner];
    balance = is_forward ? balance + hash : balance - hash;
  }

  void finish() const {
    const auto check = [](bool is_right, const std::string& what) {
      if (!is_right) throw Error(ExitCode::failed, "the parts do not fit together: " + what);
    };
    for (const auto& [owner, balance] : cut_balance_) {
      check(balance == 0, "the sides of cut " + TreePath{owner}.text() + " differ");
    }
    const auto all = [](const std::vector<bool>& known) {
      return std::find(known.begin(), known.end(), false) == known.end();
    };
    check(all(is_triangle_known_), "a triangle of the surface is in no sub-domain");
    check(all(is_node_known_), "a node of a cut is in no sub-domain");
  }

 private:
  const SurfaceMesh& surface_;
  const Numbering& numbering_;
  std::vector<Vec3> nodes_;
  std::vector<bool> is_node_known_;
  std::vector<bool> is_triangle_known_;
  std::map<std::uint64_t, std::uint64_t> cut_balance_;
};

void check_counts(const MeshPart& part, const LeafNumbers& leaf) {
  const auto& [subdomain, mesh] = part;
  if (subdomain.path != leaf.path) refuse(subdomain, "expected " + leaf.path.text());
  if (at(mesh.boundary_nodes) != subdomain.vertices.size() ||
      std::ssize(mesh.nodes) - mesh.boundary_nodes != leaf.interior_nodes ||
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
  for (std::int64_t i = 0; i < leaf.interior_nodes; ++i) numbers.push_back(leaf.first_node + i);
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
    if (subdomain.triangle_origin[t].owner != 0) {
      interfaces.meet_cut_triangle(subdomain, t, result.local2global);
      continue;
    }
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
  const std::size_t boundary_nodes = subdomain.vertices.size();
  for (std::size_t v = 0; v < part.nodes.size(); ++v) {
    if (v < boundary_nodes && !interfaces.meet_node(subdomain, v, part.local2global[v])) continue;
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
  for (std::size_t i = 0; i < numbering.leaves.size(); ++i) {
    MeshPart read = read_part(numbering.leaves[i]);
    check_counts(read, numbering.leaves[i]);
    const NumberedPart part = numbered_part(read, surface, numbering, i, interfaces);
    add_nodes(read.subdomain, part, interfaces, digest);
    add_elements(part, digest, summary);
    for (GlobalMeshWriter* writer : writers) writer->add(part);
  }
  interfaces.finish();
  summary.enclosed_volume = enclosed_volume(surface.vertices, surface.triangles);
  if (!(std::abs(summary.volume - summary.enclosed_volume) <= 1e-9 * summary.enclosed_volume)) {
    throw Error(ExitCode::failed, "the volumes of the tets do not add up to that of the domain");
  }
  for (GlobalMeshWriter* writer : writers) writer->finish();
  summary.digest = digest.finish();
  return summary;
}

}  // namespace tetfarm
