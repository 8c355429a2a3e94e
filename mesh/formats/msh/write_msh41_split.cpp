#include "mesh/formats/msh/write_msh41_split.h"

#include <algorithm>
#include <functional>

#include "mesh/formats/communication/communication_table.h"
#include "mesh/formats/count_limit.h"
#include "mesh/formats/msh/msh41_sections.h"

namespace tetfarm {
namespace {

/// A part has a surface entity for each patch, a volume entity for each region and one for its
/// ghosts.
void refuse_more_entities_than_tags(const MeshOutline& outline) {
  const std::int64_t names =
      std::ssize(std::max(outline.patch_names, outline.region_names,
                          [](const auto& a, const auto& b) { return a.size() < b.size(); }));
  require_32_bits((std::ssize(outline.parts) + 1) * names + std::ssize(outline.parts), "entities",
                  "Gmsh's split files", "ask for fewer parts");
}

/// The tag of what a partition (from 1) has of a region (from 0): behind those of the regions.
std::int32_t volume_of(const MeshOutline& outline, std::int32_t partition, std::size_t region) {
  return static_cast<std::int32_t>(std::ssize(outline.region_names)) * partition +
         static_cast<std::int32_t>(region) + 1;
}

bool has_cells(const PartOutline& part, std::size_t region) {
  bool has = part.tets_of_region[region] > 0;
  for (const ElementType type : cell_block_types) {
    has = has || part.blocks[type].of_group[region] > 0;
  }
  return has;
}

bool has_faces(const PartOutline& part, std::size_t patch) {
  bool has = part.faces_of_patch[patch] > 0;
  for (const ElementType type : face_block_types) {
    has = has || part.blocks[type].of_group[patch] > 0;
  }
  return has;
}

/// The volume that a partition's nodes are listed with.
std::int32_t first_volume(const MeshOutline& outline, std::size_t part) {
  const PartOutline& here = outline.parts[part];
  std::size_t region = 0;
  while (region + 1 < outline.region_names.size() && !has_cells(here, region)) ++region;
  return volume_of(outline, static_cast<std::int32_t>(part + 1), region);
}

/// The entity of a partition's ghosts: behind all volumes.
std::int32_t ghost_volume_of(const MeshOutline& outline, std::int32_t partition) {
  const auto partitions = static_cast<std::int32_t>(outline.parts.size());
  return volume_of(outline, partitions + 1, 0) - 1 + partition;
}

/// The cells of other partitions that have a node of this one, and their nodes that it has not.
struct Ghosts {
  std::vector<GhostCell> cells;
  std::vector<std::pair<std::int64_t, Vec3>> nodes;  ///< by number
};

Ghosts ghosts_of(const CommunicationTable& table, const GhostCorners& corners) {
  Ghosts ghosts;
  ghosts.cells = table.ghosts;
  std::vector<std::int64_t> own = table.local2global;
  std::sort(own.begin(), own.end());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::span<const std::int64_t> nodes = table.ghosts[i].all_nodes();
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const std::int64_t number = nodes[k];
      if (!std::binary_search(own.begin(), own.end(), number)) {
        ghosts.nodes.emplace_back(number, corners[i][k]);
      }
    }
  }
  const auto by_number = [](const auto& a, const auto& b) { return a.first < b.first; };
  const auto same_number = [](const auto& a, const auto& b) { return a.first == b.first; };
  std::sort(ghosts.nodes.begin(), ghosts.nodes.end(), by_number);
  ghosts.nodes.erase(std::unique(ghosts.nodes.begin(), ghosts.nodes.end(), same_number),
                     ghosts.nodes.end());
  return ghosts;
}

/// What a partition has of the whole mesh's entities: of each region and patch its part.
std::string partitioned_entities(const MeshOutline& outline, std::size_t index, bool has_ghosts) {
  const PartOutline& part = outline.parts[index];
  const auto partition = static_cast<std::int32_t>(index + 1);
  const auto patches = static_cast<std::int32_t>(outline.patch_names.size());
  std::int32_t surfaces = 0;
  for (std::size_t i = 0; i < part.faces_of_patch.size(); ++i) surfaces += has_faces(part, i);
  NumberText numbers = NumberText::raw();
  const auto put = [&](std::int32_t tag, std::int32_t dimension, std::int32_t parent) {
    for (const std::int32_t value : {tag, dimension, parent}) numbers.small(value);
    numbers.integer(1);
    numbers.small(partition);
    put_msh_box(numbers, part.box);
    numbers.integer(1);
    numbers.small(parent);
    numbers.integer(0);
  };
  numbers.words("$PartitionedEntities\n");
  numbers.integer(std::ssize(outline.parts));
  numbers.integer(has_ghosts ? 1 : 0);
  if (has_ghosts) {
    numbers.small(ghost_volume_of(outline, partition));
    numbers.small(partition);
  }
  const auto regions = static_cast<std::int32_t>(outline.region_names.size());
  std::int32_t volumes = 0;
  for (std::size_t i = 0; i < part.tets_of_region.size(); ++i) volumes += has_cells(part, i);
  for (const std::int32_t count : {0, 0, surfaces, volumes}) numbers.integer(count);
  for (std::int32_t patch = 1; patch <= patches; ++patch) {
    if (has_faces(part, static_cast<std::size_t>(patch - 1))) {
      put(patches * partition + patch, 2, patch);
    }
  }
  for (std::int32_t region = 1; region <= regions; ++region) {
    if (has_cells(part, static_cast<std::size_t>(region - 1))) {
      put(volume_of(outline, partition, static_cast<std::size_t>(region - 1)), 3, region);
    }
  }
  numbers.words(msh_section_end("PartitionedEntities", numbers));
  return numbers.take();
}

std::string nodes_of_partition(const NumberedPart& part, std::int32_t volume,
                               const Ghosts& ghosts) {
  std::vector<std::int64_t> numbers_of = part.local2global;
  std::vector<Vec3> places = part.nodes;
  for (const auto& [number, place] : ghosts.nodes) {
    numbers_of.push_back(number);
    places.push_back(place);
  }
  NumberText numbers = NumberText::raw();
  numbers.words("$Nodes\n");
  const auto [least, most] = std::minmax_element(numbers_of.begin(), numbers_of.end());
  const bool is_empty = places.empty();
  put_msh_counts(numbers, 1, std::ssize(places), is_empty ? 0 : *least + 1,
                 is_empty ? 0 : *most + 1);
  put_msh_block(numbers, {3, volume, 0, std::ssize(places)});
  for (const std::int64_t number : numbers_of) numbers.integer(number + 1);
  for (const Vec3& p : places) {
    for (const double x : {p.x, p.y, p.z}) numbers.real(x);
  }
  numbers.words(msh_section_end("Nodes", numbers));
  return numbers.take();
}

/// The number that the cell has in the whole mesh.
std::int64_t number_of_ghost(const GhostCell& ghost, const MeshOutline& outline) {
  const PartOutline& owner = outline.parts[static_cast<std::size_t>(ghost.part)];
  const MshNumbers first = first_msh_numbers(outline);
  if (ghost.type == ElementType::tet) return first.tet + owner.first_tet + ghost.cell;
  std::int64_t before = owner.tets;  // of the owner's cells those of the types before
  for (const ElementType type : cell_block_types) {
    if (type == ghost.type) break;
    before += owner.blocks[type].count;
  }
  return first.block[ghost.type] + owner.blocks[ghost.type].first + ghost.cell - before;
}

ElementCounts counts_of(const Ghosts& ghosts) {
  ElementCounts counts;
  for (const GhostCell& ghost : ghosts.cells) ++counts[ghost.type];
  return counts;
}

/// The blocks of the ghosts in $Elements: one for each type that there is.
void put_ghosts(NumberText& numbers, const Ghosts& ghosts, const MeshOutline& outline,
                std::int32_t partition) {
  const ElementCounts counts = counts_of(ghosts);
  for (const ElementType type : all_element_types) {
    if (counts[type] == 0) continue;
    put_msh_block(numbers, {3, ghost_volume_of(outline, partition), msh_code(type), counts[type]});
    const auto& order = node_order(ElementCodes::msh, type);
    for (const GhostCell& ghost : ghosts.cells) {
      if (ghost.type != type) continue;
      numbers.integer(number_of_ghost(ghost, outline));
      const std::span<const std::int64_t> nodes = ghost.all_nodes();
      for (std::size_t k = 0; k < nodes.size(); ++k) numbers.integer(nodes[order[k]] + 1);
    }
  }
}

/// $GhostElements: whose each is, and that it is a ghost here.
std::string ghost_elements(const Ghosts& ghosts, const MeshOutline& outline,
                           std::int32_t partition) {
  if (ghosts.cells.empty()) return {};
  NumberText numbers = NumberText::raw();
  numbers.words("$GhostElements\n");
  numbers.integer(std::ssize(ghosts.cells));
  for (const GhostCell& ghost : ghosts.cells) {
    numbers.integer(number_of_ghost(ghost, outline));
    numbers.small(ghost.part + 1);
    numbers.integer(1);
    numbers.small(partition);
  }
  numbers.words(msh_section_end("GhostElements", numbers));
  return numbers.take();
}

/// Faces that are no triangles, patch by patch.
void put_faces_of_blocks(NumberText& numbers, const NumberedPart& part,
                         const MeshOutline& outline) {
  const auto patches = static_cast<std::int32_t>(outline.patch_names.size());
  for (const ElementType type : face_block_types) {
    const auto faces = faces_by_patch(part.blocks[type], outline.patch_names.size());
    std::int64_t first = first_msh_numbers(outline).block[type];
    for (std::size_t patch = 0; patch < faces.size(); ++patch) {
      std::int64_t number =
          first +
          outline.parts[static_cast<std::size_t>(part.number)].blocks[type].first_of_group[patch];
      first += outline.blocks[type].of_group[patch];
      if (faces[patch].empty()) continue;
      put_msh_block(numbers, {2, patches * (part.number + 1) + static_cast<std::int32_t>(patch) + 1,
                              msh_code(type), std::ssize(faces[patch])});
      for (const std::size_t face : faces[patch])
        put_msh_element(numbers, number++, type, part, face);
    }
  }
}

/// Cells that are no tets, region by region.
void put_cells_of_blocks(NumberText& numbers, const NumberedPart& part,
                         const MeshOutline& outline) {
  const PartOutline& here = outline.parts[static_cast<std::size_t>(part.number)];
  for (const ElementType type : cell_block_types) {
    std::int64_t number = first_msh_numbers(outline).block[type] + here.blocks[type].first;
    std::size_t next = 0;
    for (std::size_t region = 0; region < here.blocks[type].of_group.size(); ++region) {
      const std::int64_t count = here.blocks[type].of_group[region];
      if (count == 0) continue;
      put_msh_block(numbers,
                    {3, volume_of(outline, part.number + 1, region), msh_code(type), count});
      for (std::int64_t i = 0; i < count; ++i)
        put_msh_element(numbers, number++, type, part, next++);
    }
  }
}

/// `first_triangle` are the numbers of the first triangle of each patch.
std::string elements_of_partition(const NumberedPart& part, const MeshOutline& outline,
                                  const std::vector<std::int64_t>& first_triangle,
                                  const Ghosts& ghosts) {
  const auto partition = static_cast<std::int32_t>(part.number + 1);
  const auto patches = static_cast<std::int32_t>(outline.patch_names.size());
  const auto faces = faces_by_patch(part, outline.patch_names.size());
  const PartOutline& here = outline.parts[static_cast<std::size_t>(part.number)];
  std::int64_t blocks = 0;
  const ElementCounts of_ghosts = counts_of(ghosts);
  for (const ElementType type : all_element_types) blocks += of_ghosts[type] > 0 ? 1 : 0;
  for (const std::int64_t tets : here.tets_of_region) blocks += tets > 0 ? 1 : 0;
  for (const auto& of_patch : faces) blocks += of_patch.empty() ? 0 : 1;
  std::int64_t elements = std::ssize(part.tets) + std::ssize(part.faces) + std::ssize(ghosts.cells);
  for_each_block(here.blocks, [&](ElementType, const BlockOutline& block) {
    for (const std::int64_t count : block.of_group) blocks += count > 0 ? 1 : 0;
    elements += block.count;
  });
  NumberText numbers = NumberText::raw();
  numbers.words("$Elements\n");
  put_msh_counts(numbers, blocks, elements, 1, outline.boundary_faces() + outline.cells());
  for (std::int32_t patch = 0; patch < patches; ++patch) {
    const auto& of_patch = faces[static_cast<std::size_t>(patch)];
    if (of_patch.empty()) continue;
    put_msh_block(numbers,
                  {2, patches * partition + patch + 1, msh_triangle_type, std::ssize(of_patch)});
    const auto index = static_cast<std::size_t>(patch);
    std::int64_t number = first_triangle[index] + here.first_face_of_patch[index];
    for (const std::size_t face : of_patch) {
      put_msh_element(numbers, number++, part.faces[face], part);
    }
  }
  put_faces_of_blocks(numbers, part, outline);
  std::int64_t number = first_msh_numbers(outline).tet + here.first_tet;
  std::size_t next = 0;
  for (std::size_t region = 0; region < here.tets_of_region.size(); ++region) {
    const std::int64_t tets = here.tets_of_region[region];
    if (tets == 0) continue;
    put_msh_block(numbers, {3, volume_of(outline, partition, region), msh_tet_type, tets});
    for (std::int64_t t = 0; t < tets; ++t)
      put_msh_element(numbers, number++, part.tets[next++], part);
  }
  put_cells_of_blocks(numbers, part, outline);
  put_ghosts(numbers, ghosts, outline, partition);
  numbers.words(msh_section_end("Elements", numbers));
  return numbers.take();
}

using WritePartition = std::function<void(std::size_t i, const Ghosts& ghosts)>;

/// What writes the file of a part, as often as wanted. @pre the arguments outlive it.
WritePartition partition_writer(const MeshSource& source, const MeshOutline& outline,
                                const std::filesystem::path& path) {
  refuse_more_entities_than_tags(outline);
  const NumberText raw = NumberText::raw();
  std::vector<MshVolume> regions;
  for (std::size_t i = 0; i < outline.region_names.size(); ++i) {
    regions.push_back({static_cast<std::int32_t>(i + 1), box_of(outline)});
  }
  const std::string head = msh_head(outline, raw) + msh_entities(outline, regions, raw);
  const std::vector<std::int64_t> first_triangle = first_msh_triangles(outline);
  return [&source, &outline, path, head, first_triangle](std::size_t i, const Ghosts& ghosts) {
    const NumberedPart part = source.part(i);
    const std::string name =
        path.stem().string() + "_" + std::to_string(i + 1) + path.extension().string();
    OutputFile file(path.parent_path() / name);
    GrowingEnd end(file);
    end.write(head + partitioned_entities(outline, i, !ghosts.cells.empty()));
    end.write(nodes_of_partition(part, first_volume(outline, i), ghosts));
    end.write(elements_of_partition(part, outline, first_triangle, ghosts));
    end.write(ghost_elements(ghosts, outline, part.number + 1));
    file.finish();
  };
}

}  // namespace

void write_msh41_split(const MeshSource& source, const MeshOutline& outline,
                       const std::filesystem::path& path) {
  const WritePartition write = partition_writer(source, outline, path);
  for (std::size_t i = 0; i < source.size(); ++i) write(i, {});
}

void write_msh41_ghosts(const MeshSource& source, const MeshOutline& outline,
                        const std::filesystem::path& path) {
  const WritePartition write = partition_writer(source, outline, path);
  for_each_part_with_ghosts(source, outline, std::filesystem::absolute(path).parent_path(),
                            [&](const CommunicationTable& table, const GhostCorners& corners) {
                              write(static_cast<std::size_t>(table.part),
                                    ghosts_of(table, corners));
                            });
}

}  // namespace tetfarm
