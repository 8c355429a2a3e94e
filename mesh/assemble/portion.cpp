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
#include "mesh/assemble/part_cells.h"

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

void check_counts(const MeshPart& part, const LeafNumbering& numbering) {
  const Subdomain& subdomain = part.subdomain;
  const TetMesh& mesh = part.mesh;
  if (at(mesh.boundary_nodes) != subdomain.vertices.size() ||
      subdomain.node_origin.size() != subdomain.vertices.size() ||
      std::ssize(mesh.nodes) - mesh.boundary_nodes > numbering.kept_nodes ||
      std::ssize(mesh.tets) != numbering.tets || counts_of(part.blocks) != numbering.others) {
    refuse(subdomain, "different counts from the numbering");
  }
}

std::vector<std::int64_t> local2global_of(const MeshPart& part, const LeafNumbering& numbering) {
  TF_CHECK(numbering.node_numbers.size() == part.subdomain.node_origin.size());
  std::vector<std::int64_t> numbers = numbering.node_numbers;
  numbers.reserve(part.mesh.nodes.size());
  const std::int64_t interior = std::ssize(part.mesh.nodes) - part.mesh.boundary_nodes;
  for (std::int64_t i = 0; i < interior; ++i) numbers.push_back(numbering.first_node + i);
  TF_CHECK(numbers.size() == part.mesh.nodes.size());
  return numbers;
}

void check_surface_nodes(const MeshPart& part, const SurfacePieces& surface) {
  const Subdomain& subdomain = part.subdomain;
  std::size_t next = 0;
  for (std::size_t v = 0; v < subdomain.node_origin.size(); ++v) {
    if (subdomain.node_origin[v].owner != 0) continue;
    if (!same_bits(part.mesh.nodes[v], surface.vertices.at(next++))) {
      refuse(subdomain, "a node is not where the input surface has it");
    }
  }
  TF_CHECK(next == surface.vertices.size());
}

/// The triangle has the nodes that it has in the surface, turned to point out of the region.
void check_surface_triangle(const Subdomain& subdomain, std::size_t t, Triangle nodes,
                            const Sides& sides) {
  if (sides[0] != subdomain.region) std::swap(nodes[1], nodes[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto local = at(subdomain.triangles[t][i]);
    const Origin vertex{0, static_cast<std::uint32_t>(nodes[i])};
    if (local >= subdomain.node_origin.size() || subdomain.node_origin[local] != vertex) {
      refuse(subdomain, "a surface triangle has other nodes than in the input");
    }
  }
}

/// By the numbers that the nodes have in the whole mesh.
NodeFeet with_global_feet(NodeFeet feet, const std::vector<std::int64_t>& local2global) {
  TF_CHECK(feet.empty() || feet.foot.size() == local2global.size());
  TF_CHECK(feet.foot.size() == feet.depth.size());
  for (std::int64_t& foot : feet.foot) {
    if (foot != no_foot) foot = local2global.at(static_cast<std::size_t>(foot));
  }
  return feet;
}

void add_surface_triangles(const Subdomain& subdomain, const SurfacePieces& surface,
                           Portion& portion) {
  std::size_t next = 0;
  for (std::size_t t = 0; t < subdomain.triangles.size(); ++t) {
    if (subdomain.triangle_origin[t].owner != 0) continue;
    check_surface_triangle(subdomain, t, surface.triangles.at(next), surface.sides.at(next));
    portion.part.faces.push_back(subdomain.triangles[t]);
    portion.part.patch_of_face.push_back(surface.patches.at(next));
    portion.surface_triangles.push_back(subdomain.triangle_origin[t].index);
    ++next;
  }
  TF_CHECK(next == surface.triangles.size());
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

/// The volumes alone.
MeshShapes without_shapes(const MeshShapes& shapes) {
  MeshShapes volumes;
  for (const RegionShapes& region : shapes.regions) volumes.regions.push_back({region.volume, {}});
  return volumes;
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
    if (!is_of_cut(subdomain.triangle_origin[t])) continue;
    for (const std::int32_t v : subdomain.triangles[t]) is_on_cut[at(v)] = true;
  }
  return is_on_cut;
}

WantedPieces surface_pieces(const Subdomain& subdomain) {
  WantedPieces wanted;
  for (const auto& [origins, numbers] :
       {std::pair{&subdomain.node_origin, &wanted.vertices},
        std::pair{&subdomain.triangle_origin, &wanted.triangles}}) {
    for (const Origin& origin : *origins) {
      if (origin.owner == 0) numbers->push_back(origin.index);
    }
  }
  return wanted;
}

Portion make_portion(MeshPart part, const SurfacePieces& surface, const LeafNumbering& numbering) {
  check_counts(part, numbering);
  check_surface_nodes(part, surface);
  Portion portion;
  NumberedPart& numbered = portion.part;
  numbered.number = numbering.number;
  numbered.region = part.subdomain.region;
  numbered.local2global = local2global_of(part, numbering);
  add_surface_triangles(part.subdomain, surface, portion);
  numbered.nodes = std::move(part.mesh.nodes);
  numbered.tets = std::move(part.mesh.tets);
  numbered.blocks = std::move(part.blocks);
  numbered.marks = std::move(part.marks);
  numbered.feet = with_global_feet(std::move(part.feet), numbered.local2global);
  part.is_on_cut.resize(numbered.nodes.size(), false);
  ElementCounts first = numbering.first_other;
  first[ElementType::tet] = numbering.first_tet;
  take_figures(part.is_on_cut, first, portion);
  if (part.is_of_layers) portion.shapes = without_shapes(portion.shapes);
  return portion;
}

void take_figures(const std::vector<bool>& is_on_cut, const ElementCounts& first,
                  Portion& portion) {
  const NumberedPart& part = portion.part;
  TF_CHECK(part.local2global.size() == part.nodes.size());
  TF_CHECK(part.region_of_tet.empty() && part.region_of_face.empty());
  portion.tets = std::ssize(part.tets);
  portion.others = counts_of(part.blocks);
  add_shapes(part.nodes, part.tets, part.region, is_on_cut, portion.shapes);
  add_volume_of_blocks(part, portion.shapes);
  portion.face_sum = face_sum_of(part);
  add_digest(part, first, portion);
}

}  // namespace tetfarm
