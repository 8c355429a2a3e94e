#include "mesh/formats/mesh_source.h"

#include <algorithm>
#include <limits>

#include "base/error.h"

namespace tetfarm {
namespace {

/// More than any real mesh has: a wrong number must not fill the memory.
constexpr std::int32_t most_names = 1'000'000;

[[noreturn]] void refuse(std::size_t part, const std::string& what) {
  throw InvalidInput(what, "sub-domain " + std::to_string(part));
}

/// Which nodes have been met.
class KnownNodes {
 public:
  /// True for the first time.
  bool meet(std::int64_t number) {
    const auto at = static_cast<std::size_t>(number);
    if (at >= is_known_.size()) is_known_.resize(std::max(at + 1, 2 * is_known_.size()), false);
    const bool is_new = !is_known_[at];
    is_known_[at] = true;
    return is_new;
  }

 private:
  std::vector<bool> is_known_;
};

void add_counts(const std::vector<std::int64_t>& counts, std::vector<std::int64_t>& sums) {
  for (std::size_t i = 0; i < counts.size(); ++i) sums[i] += counts[i];
}

/// `tets` more of a region, or its first. @throws InvalidInput.
void add_tets_of_region(std::int32_t region, std::int64_t tets, std::size_t index,
                        PartOutline& outline) {
  if (region < 1 || region > most_names) refuse(index, "a region number is out of range");
  if (region < std::ssize(outline.tets_of_region)) refuse(index, "regions are not in order");
  outline.tets_of_region.resize(static_cast<std::size_t>(region));
  outline.tets_of_region.back() += tets;
}

/// One more of a region, or of a patch from 1.
void add_to_group(std::size_t group, BlockOutline& outline) {
  if (group > outline.of_group.size()) outline.of_group.resize(group);
  ++outline.of_group[group - 1];
  ++outline.count;
}

void outline_blocks(const ElementBlocks& blocks, std::size_t index, PartOutline& outline) {
  for (const ElementType type : cell_block_types) {
    BlockOutline& here = outline.blocks[type];
    for (const std::int32_t region : blocks[type].regions) {
      if (region < 1 || region > most_names) refuse(index, "a region number is out of range");
      if (region < std::ssize(here.of_group)) refuse(index, "regions are not in order");
      add_to_group(static_cast<std::size_t>(region), here);
    }
  }
  for (const ElementType type : face_block_types) {
    for (const std::int32_t patch : blocks[type].patches) {
      if (patch < 0 || patch >= most_names) refuse(index, "a patch number is out of range");
      add_to_group(static_cast<std::size_t>(patch) + 1, outline.blocks[type]);
    }
  }
}

PartOutline outline_of_part(const CountedPart& counted, std::size_t index, std::int64_t limit,
                            KnownNodes& known) {
  const NumberedPart& part = counted.part;
  PartOutline outline;
  outline.nodes = std::ssize(part.nodes);
  outline.tets = counted.tets;
  outline.faces = counted.faces;
  for (const std::int32_t region : part.region_of_tet) {
    add_tets_of_region(region, 1, index, outline);
  }
  if (part.region_of_tet.empty() && counted.tets > 0) {
    add_tets_of_region(part.region, counted.tets, index, outline);
  }
  outline.box = bounding_box(part.nodes);
  for (const std::int64_t number : part.local2global) {
    if (number < 0 || number >= limit) refuse(index, "a node number is out of range");
    if (known.meet(number)) ++outline.owned_nodes;
  }
  for (const std::int32_t patch : part.patch_of_face) {
    if (patch < 0 || patch >= most_names) refuse(index, "a patch number is out of range");
    const auto at = static_cast<std::size_t>(patch);
    if (at >= outline.faces_of_patch.size()) outline.faces_of_patch.resize(at + 1);
    ++outline.faces_of_patch[at];
  }
  outline_blocks(part.blocks, index, outline);
  return outline;
}

/// Where the part begins in the blocks of the whole mesh, and what comes behind it.
void add_up_block(BlockOutline& here, BlockOutline& sum) {
  here.of_group.resize(sum.of_group.size());
  here.first = sum.count;
  here.first_of_group = sum.of_group;
  sum.count += here.count;
  add_counts(here.of_group, sum.of_group);
}

ElementCounts with_blocks(std::int64_t tets, std::int64_t triangles,
                          const ByType<BlockOutline>& blocks) {
  ElementCounts counts;
  counts[ElementType::tet] = tets;
  counts[ElementType::triangle] = triangles;
  for_each_block(blocks,
                 [&](ElementType type, const BlockOutline& block) { counts[type] = block.count; });
  return counts;
}

void name_the_rest(std::vector<std::string>& names, std::size_t count, const std::string& kind) {
  while (names.size() < count) names.push_back(kind + " " + std::to_string(names.size() + 1));
}

}  // namespace

CountedPart MeshSource::counted_part(std::size_t i) const {
  CountedPart counted{part(i), 0, 0};
  counted.tets = std::ssize(counted.part.tets);
  counted.faces = std::ssize(counted.part.faces);
  return counted;
}

MeshOutline outline_of(const MeshSource& source) {
  MeshOutline outline;
  KnownNodes known;
  std::int64_t largest = -1;
  std::size_t patches = 0;
  std::size_t regions = 0;
  std::int64_t points = 0;
  // A number above all points could not be of a mesh without gaps, and would cost memory.
  std::int64_t limit = 0;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const CountedPart counted = source.counted_part(i);
    points += std::ssize(counted.part.nodes);
    limit = std::max<std::int64_t>(limit, std::numeric_limits<std::int32_t>::max() + points);
    outline.parts.push_back(outline_of_part(counted, i, limit, known));
    const PartOutline& here = outline.parts.back();
    for (const std::int64_t number : counted.part.local2global) largest = std::max(largest, number);
    patches = std::max(patches, here.faces_of_patch.size());
    regions = std::max(regions, here.tets_of_region.size());
    for (const ElementType type : cell_block_types) {
      regions = std::max(regions, here.blocks[type].of_group.size());
    }
    for (const ElementType type : face_block_types) {
      patches = std::max(patches, here.blocks[type].of_group.size());
    }
  }
  outline.patch_names = source.patch_names();
  outline.region_names = source.region_names();
  outline.patch_types = source.patch_types();
  if (outline.region_names.empty() && regions <= 1) outline.region_names = {"domain"};
  name_the_rest(outline.patch_names, patches, "patch");
  name_the_rest(outline.region_names, regions, "region");
  outline.patch_types.resize(outline.patch_names.size(), PatchType::unspecified);
  add_up(outline);
  if (largest + 1 != outline.nodes) {
    throw InvalidInput("node numbers have gaps: the largest is " + std::to_string(largest) +
                           " of " + std::to_string(outline.nodes) + " nodes",
                       "");
  }
  return outline;
}

void add_up(MeshOutline& outline) {
  outline.nodes = outline.tets = outline.boundary_triangles = 0;
  outline.faces_of_patch.assign(outline.patch_names.size(), 0);
  outline.tets_of_region.assign(outline.region_names.size(), 0);
  for (const ElementType type : cell_block_types) {
    outline.blocks[type] = {0, 0, std::vector<std::int64_t>(outline.region_names.size()), {}};
  }
  for (const ElementType type : face_block_types) {
    outline.blocks[type] = {0, 0, std::vector<std::int64_t>(outline.patch_names.size()), {}};
  }
  for (PartOutline& part : outline.parts) {
    part.faces_of_patch.resize(outline.patch_names.size());
    part.tets_of_region.resize(outline.region_names.size());
    part.first_cell = outline.cells();
    part.first_tet = outline.tets;
    part.first_face = outline.boundary_triangles;
    part.first_face_of_patch = outline.faces_of_patch;
    outline.nodes += part.owned_nodes;
    outline.tets += part.tets;
    outline.boundary_triangles += part.faces;
    add_counts(part.faces_of_patch, outline.faces_of_patch);
    add_counts(part.tets_of_region, outline.tets_of_region);
    for_each_block(part.blocks, [&](ElementType type, BlockOutline& block) {
      add_up_block(block, outline.blocks[type]);
    });
  }
}

ElementCounts PartOutline::elements() const { return with_blocks(tets, faces, blocks); }
ElementCounts MeshOutline::elements() const {
  return with_blocks(tets, boundary_triangles, blocks);
}
std::int64_t MeshOutline::cells() const { return count_cells(elements()); }
std::int64_t MeshOutline::boundary_faces() const { return count_faces(elements()); }

bool MeshOutline::has_tets_alone() const {
  return cells() == tets && boundary_faces() == boundary_triangles;
}

std::int64_t MeshOutline::boundary_faces_of(std::size_t patch) const {
  std::int64_t sum = faces_of_patch[patch];
  for (const ElementType type : face_block_types) sum += blocks[type].of_group[patch];
  return sum;
}

void require_tets_alone(const MeshOutline& outline, const std::string& what) {
  if (outline.has_tets_alone()) return;
  std::string others;
  for_each_block(outline.blocks, [&](ElementType type, const BlockOutline& block) {
    if (block.count == 0) return;
    others += (others.empty() ? "" : ", ") + text_of_count(block.count, type);
  });
  throw Error(ExitCode::failed, what + " tetrahedra only; this mesh has " + others +
                                    ": choose a format that holds them, vtkhdf for instance");
}

std::int64_t RegionRun::cells() const {
  std::int64_t sum = tets;
  for (const ElementType type : cell_block_types) sum += others[type];
  return sum;
}

std::vector<RegionRun> region_runs(const MeshOutline& outline) {
  std::vector<RegionRun> runs;
  for (std::size_t i = 0; i < outline.parts.size(); ++i) {
    const PartOutline& part = outline.parts[i];
    RegionRun next;
    next.part = i;
    next.first_tet = part.first_tet;
    for (const ElementType type : cell_block_types) {
      next.first_in_block[type] = part.blocks[type].first;
    }
    const std::size_t runs_before = runs.size();
    for (std::size_t region = 0; region < part.tets_of_region.size(); ++region) {
      next.region = static_cast<std::int32_t>(region + 1);
      next.tets = part.tets_of_region[region];
      for (const ElementType type : cell_block_types) {
        next.others[type] = part.blocks[type].of_group[region];
      }
      if (next.cells() > 0) runs.push_back(next);
      next.first_tet += next.tets;
      for (const ElementType type : cell_block_types) {
        next.first_in_block[type] += next.others[type];
      }
    }
    if (runs.size() > runs_before) continue;
    runs.push_back({i, 1, part.first_tet, 0, {}, {}});
  }
  return runs;
}

}  // namespace tetfarm
