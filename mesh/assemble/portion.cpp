#include "mesh/assemble/portion.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/assemble/face_balance.h"

namespace tetfarm {
namespace {

[[noreturn]] void refuse(const Subdomain& subdomain, const std::string& what) {
  throw Error(ExitCode::failed, "sub-domain " + subdomain.path.text() + ": " + what);
}

bool same_bits(const Vec3& a, const Vec3& b) {
  const auto same = [](double s, double t) {
    return std::bit_cast<std::uint64_t>(s) == std::bit_cast<std::uint64_t>(t);
  };
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

std::size_t number_of(const Subdomain& subdomain, const Numbering& numbering) {
  for (std::size_t i = 0; i < numbering.leaves.size(); ++i) {
    if (numbering.leaves[i].path == subdomain.path) return i;
  }
  refuse(subdomain, "is not a leaf of the numbering");
}

void check_counts(const MeshPart& part, const LeafNumbers& leaf) {
  const Subdomain& subdomain = part.subdomain;
  const TetMesh& mesh = part.mesh;
  if (at(mesh.boundary_nodes) != subdomain.vertices.size() ||
      subdomain.node_origin.size() != subdomain.vertices.size() ||
      std::ssize(mesh.nodes) - mesh.boundary_nodes > leaf.nodes.kept() ||
      std::ssize(mesh.tets) != leaf.tets) {
    refuse(subdomain, "different counts from the numbering");
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
  TF_CHECK(numbers.size() == part.mesh.nodes.size());
  return numbers;
}

void check_surface_nodes(const MeshPart& part, const SurfaceMesh& surface) {
  const Subdomain& subdomain = part.subdomain;
  for (std::size_t v = 0; v < subdomain.node_origin.size(); ++v) {
    const Origin& origin = subdomain.node_origin[v];
    if (origin.owner != 0) continue;
    if (!same_bits(part.mesh.nodes[v], surface.vertices[origin.index])) {
      refuse(subdomain, "a node is not where the input surface has it");
    }
  }
}

/// The triangle has the nodes that it has in the surface, turned to point out of the region.
void check_surface_triangle(const Subdomain& subdomain, std::size_t t, const SurfaceMesh& surface,
                            const Numbering& numbering,
                            const std::vector<std::int64_t>& local2global) {
  const std::uint32_t index = subdomain.triangle_origin[t].index;
  if (index >= surface.triangles.size()) refuse(subdomain, "unknown triangle of the surface");
  Triangle nodes = surface.triangles[index];
  if (sides_of(surface, index)[0] != subdomain.region) std::swap(nodes[1], nodes[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Origin vertex{0, static_cast<std::uint32_t>(nodes[i])};
    if (global_number(numbering, vertex) != local2global[at(subdomain.triangles[t][i])]) {
      refuse(subdomain, "a surface triangle has other nodes than in the input");
    }
  }
}

void add_surface_triangles(const Subdomain& subdomain, const SurfaceMesh& surface,
                           const Numbering& numbering, Portion& portion) {
  const auto& patches = surface.patch_of_triangle;
  for (std::size_t t = 0; t < subdomain.triangles.size(); ++t) {
    if (subdomain.triangle_origin[t].owner != 0) continue;
    check_surface_triangle(subdomain, t, surface, numbering, portion.part.local2global);
    const std::uint32_t index = subdomain.triangle_origin[t].index;
    portion.part.faces.push_back(subdomain.triangles[t]);
    portion.part.patch_of_face.push_back(patches.empty() ? 0 : patches[index]);
    portion.surface_triangles.push_back(index);
  }
}

/// Of the cells of a portion, and of its boundary faces of other types than triangles.
void add_digest(const NumberedPart& part, ElementCounts next, Portion& portion) {
  MeshDigest digest;
  TF_CHECK(next[ElementType::tet] >= 0);
  const std::vector<std::int64_t>& global = part.local2global;
  for (const auto& [a, b, c, d] : part.tets) {
    digest.add_tet(next[ElementType::tet]++,
                   {global[at(a)], global[at(b)], global[at(c)], global[at(d)]});
  }
  const auto add_other = [&](ElementType type, std::int64_t number_or_patch,
                             std::span<const std::int32_t> nodes) {
    std::array<std::int64_t, most_element_nodes> numbers{};
    std::transform(nodes.begin(), nodes.end(), numbers.begin(),
                   [&global](std::int32_t v) { return global[at(v)]; });
    digest.add_other(type, number_or_patch, std::span(numbers.data(), nodes.size()));
  };
  for_each_block_cell(part.blocks, [&](ElementType type, std::span<const std::int32_t> nodes,
                                       std::int32_t) { add_other(type, next[type]++, nodes); });
  for_each_block_face(part.blocks,
                      [&](ElementType type, std::span<const std::int32_t> nodes, std::int32_t,
                          std::int32_t patch) { add_other(type, patch, nodes); });
  portion.tet_digest = digest.tets();
  portion.other_digest = digest.others();
}

/// Figures of shape are of tets; the volume is of all.
void add_volume_of_blocks(const NumberedPart& part, MeshShapes& shapes) {
  for_each_block_cell(
      part.blocks, [&](ElementType type, std::span<const std::int32_t> nodes, std::int32_t) {
        std::array<Vec3, most_element_nodes> corners;
        std::transform(nodes.begin(), nodes.end(), corners.begin(),
                       [&part](std::int32_t v) { return part.nodes[at(v)]; });
        shapes.regions[at(part.region - 1)].volume +=
            static_cast<double>(element_volume(type, std::span(corners.data(), nodes.size())));
      });
}

}  // namespace

std::vector<std::int32_t> regions_of_cells(const NumberedPart& part) {
  std::vector<std::int32_t> regions = part.region_of_tet;
  regions.resize(part.tets.size(), part.region);
  for (const ElementType type : cell_block_types) {
    const ElementBlock& block = part.blocks[type];
    regions.insert(regions.end(), block.regions.begin(), block.regions.end());
  }
  return regions;
}

std::vector<std::int32_t> regions_of_boundary(const NumberedPart& part) {
  std::vector<std::int32_t> regions = part.region_of_face;
  regions.resize(part.faces.size(), part.region);
  for (const ElementType type : face_block_types) {
    const ElementBlock& block = part.blocks[type];
    regions.insert(regions.end(), block.regions.begin(), block.regions.end());
  }
  return regions;
}

std::int64_t cells_of(const NumberedPart& part) {
  std::int64_t cells = std::ssize(part.tets);
  for (const ElementType type : cell_block_types) cells += std::ssize(part.blocks[type].regions);
  return cells;
}

std::int64_t boundary_faces_of(const NumberedPart& part) {
  std::int64_t faces = std::ssize(part.faces);
  for (const ElementType type : face_block_types) faces += std::ssize(part.blocks[type].regions);
  return faces;
}

std::vector<bool> nodes_on_cuts(const Subdomain& subdomain) {
  std::vector<bool> is_on_cut(subdomain.vertices.size(), false);
  for (std::size_t t = 0; t < subdomain.triangles.size(); ++t) {
    if (subdomain.triangle_origin[t].owner == 0) continue;
    for (const std::int32_t v : subdomain.triangles[t]) is_on_cut[at(v)] = true;
  }
  return is_on_cut;
}

Portion make_portion(MeshPart part, const SurfaceMesh& surface, const Numbering& numbering) {
  const std::size_t number = number_of(part.subdomain, numbering);
  check_counts(part, numbering.leaves[number]);
  check_surface_nodes(part, surface);
  Portion portion;
  NumberedPart& numbered = portion.part;
  numbered.number = static_cast<std::int32_t>(number);
  numbered.region = part.subdomain.region;
  numbered.local2global = local2global_of(part, numbering, numbering.leaves[number]);
  add_surface_triangles(part.subdomain, surface, numbering, portion);
  numbered.nodes = std::move(part.mesh.nodes);
  numbered.tets = std::move(part.mesh.tets);
  part.is_on_cut.resize(numbered.nodes.size(), false);
  ElementCounts first{};
  first[ElementType::tet] = numbering.leaves[number].first_tet;
  take_figures(part.is_on_cut, first, portion);
  return portion;
}

void take_figures(const std::vector<bool>& is_on_cut, const ElementCounts& first,
                  Portion& portion) {
  const NumberedPart& part = portion.part;
  TF_CHECK(part.local2global.size() == part.nodes.size());
  TF_CHECK(part.region_of_tet.empty() && part.region_of_face.empty());
  portion.tets = std::ssize(part.tets);
  for_each_block(part.blocks, [&](ElementType type, const ElementBlock& block) {
    portion.others[type] = std::ssize(block.regions);
  });
  add_shapes(part.nodes, part.tets, part.region, is_on_cut, portion.shapes);
  add_volume_of_blocks(part, portion.shapes);
  portion.face_sum = face_sum_of(part);
  add_digest(part, first, portion);
}

}  // namespace tetfarm
