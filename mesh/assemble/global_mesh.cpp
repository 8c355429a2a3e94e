#include "mesh/assemble/global_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/assemble/mesh_digest.h"

namespace tetfarm {
namespace {

[[noreturn]] void refuse(const LeafNumbers& leaf, const std::string& what) {
  throw Error(ExitCode::failed,
              "the parts do not fit together: sub-domain " + leaf.path.text() + ": " + what);
}

/// What the sub-domains have of the surface and of the nodes, checked as they pass.
class Interfaces {
 public:
  Interfaces(const SurfaceMesh& surface, const Numbering& numbering)
      : surface_(surface),
        is_node_known_(at(numbering.nodes), false),
        is_side_known_(2 * surface.triangles.size(), false) {}

  /// True when the node is met for the first time.
  bool meet_node(const LeafNumbers& leaf, std::int64_t number) {
    if (number < 0 || number >= std::ssize(is_node_known_)) refuse(leaf, "unknown node");
    const bool is_new = !is_node_known_[at(number)];
    is_node_known_[at(number)] = true;
    return is_new;
  }

  /// Once for each region that the triangle bounds.
  void meet_surface_triangle(const LeafNumbers& leaf, std::int32_t region, std::uint32_t index) {
    if (index >= surface_.triangles.size()) refuse(leaf, "unknown triangle of the surface");
    const Sides sides = sides_of(surface_, index);
    const std::size_t side = sides[0] == region ? 0 : 1;
    if (sides[side] != region) refuse(leaf, "a surface triangle of another region");
    if (is_side_known_[2 * index + side]) {
      refuse(leaf, "a surface triangle is in two sub-domains");
    }
    is_side_known_[2 * index + side] = true;
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
  std::vector<bool> is_node_known_;
  std::vector<bool> is_side_known_;  // 2 t: behind triangle t, 2 t + 1: in front
};

void meet(const Portion& portion, const LeafNumbers& leaf, Interfaces& interfaces,
          MeshDigest& digest) {
  const NumberedPart& part = portion.part;
  TF_CHECK(part.local2global.size() == part.nodes.size());
  for (std::size_t v = 0; v < part.nodes.size(); ++v) {
    if (interfaces.meet_node(leaf, part.local2global[v])) {
      digest.add_node(part.local2global[v], part.nodes[v]);
    }
  }
  for (const std::uint32_t triangle : portion.surface_triangles) {
    interfaces.meet_surface_triangle(leaf, part.region, triangle);
  }
}

void add_triangles(const NumberedPart& part, MeshDigest& digest) {
  TF_CHECK(part.patch_of_face.size() == part.faces.size());
  for (std::size_t i = 0; i < part.faces.size(); ++i) {
    const auto& [a, b, c] = part.faces[i];
    const std::vector<std::int64_t>& global = part.local2global;
    digest.add_boundary_triangle({global[at(a)], global[at(b)], global[at(c)]},
                                 part.patch_of_face[i]);
  }
}

/// What the quads add to the volume that the surface encloses: the surface has none of them.
double volume_behind_quads(const NumberedPart& part, const Vec3& origin) {
  long double sum = 0;
  for_each_block_face(part.blocks, [&](ElementType, std::span<const std::int32_t> face,
                                       std::int32_t, std::int32_t) {
    std::array<Vec3, most_face_nodes> corners;
    std::transform(face.begin(), face.end(), corners.begin(),
                   [&part](std::int32_t v) { return part.nodes[at(v)]; });
    sum += cone_volume(origin, {corners.data(), face.size()});
  });
  return static_cast<double>(sum);
}

}  // namespace

GlobalMeshSummary assemble_global_mesh(const SurfaceMesh& surface, const Numbering& numbering,
                                       const ReadPortion& read_portion,
                                       std::span<GlobalMeshWriter* const> writers) {
  GlobalMeshSummary summary;
  summary.nodes = numbering.nodes;
  summary.tets = numbering.tets;
  summary.boundary_triangles = meshed_sides(surface);
  summary.subdomains = static_cast<std::int32_t>(numbering.leaves.size());
  Interfaces interfaces(surface, numbering);
  MeshDigest digest;
  std::uint64_t face_sum = 0;
  const Vec3 origin = bounding_box(surface.vertices).centre();
  summary.enclosed_volume = domain_volume(surface);
  for (std::size_t i = 0; i < numbering.leaves.size(); ++i) {
    const LeafNumbers& leaf = numbering.leaves[i];
    const Portion portion = read_portion(leaf);
    const NumberedPart& part = portion.part;
    if (at(part.number) != i || portion.tets != leaf.tets || portion.others != leaf.others) {
      refuse(leaf, "another portion, or different counts from the numbering");
    }
    meet(portion, leaf, interfaces, digest);
    digest.add_tets(portion.tet_digest);
    digest.add_others(portion.other_digest);
    for_each_block(summary.others,
                   [&](ElementType type, std::int64_t& count) { count += portion.others[type]; });
    add_triangles(part, digest);
    add_shapes(portion.shapes, summary.shapes);
    face_sum += portion.face_sum;
    summary.enclosed_volume += volume_behind_quads(part, origin);
    for (GlobalMeshWriter* writer : writers) writer->add(part);
  }
  interfaces.finish();
  if (face_sum != 0) {
    throw Error(ExitCode::failed,
                "the parts do not fit together: faces of neighbours differ, or their nodes");
  }
  for (const RegionShapes& region : summary.shapes.regions) summary.volume += region.volume;
  if (!(std::abs(summary.volume - summary.enclosed_volume) <= 1e-9 * summary.enclosed_volume)) {
    throw Error(ExitCode::failed,
                "the volumes of the elements do not add up to that of the domain");
  }
  for (GlobalMeshWriter* writer : writers) writer->finish();
  summary.digest = digest.finish();
  return summary;
}

}  // namespace tetfarm
