#include "mesh/formats/vtkhdf/packed_cells.h"

#include "base/array_index.h"
#include "mesh/core/element_block.h"

namespace tetfarm {
namespace {

constexpr std::int32_t no_patch = -1;

constexpr auto type_code(ElementType type) {
  return static_cast<std::uint8_t>(code_of(ElementCodes::vtk, type));
}

/// All types and how many there are of each, in the order of the file.
template <class Visit>
void for_each_run(const VtkhdfCounts& counts, const Visit& visit) {
  visit(ElementType::tet, at(counts.tets));
  for (const ElementType type : cell_block_types) visit(type, at(counts.others[type]));
  visit(ElementType::triangle, at(counts.faces));
  for (const ElementType type : face_block_types) visit(type, at(counts.others[type]));
}

/// One of each element, or for want of them the one that all have.
void add_of_each(const std::vector<std::int32_t>& of_each, std::size_t count, std::int32_t of_all,
                 PackedRows<std::int32_t>& rows) {
  TF_CHECK(of_each.empty() || of_each.size() == count);
  if (of_each.empty()) rows.add(count, of_all);
  for (const std::int32_t value : of_each) rows.add(value);
}

}  // namespace

PackedCells::Offsets PackedCells::offsets_in(Hdf5Output& file, std::int64_t rows,
                                             std::int64_t id_size) {
  constexpr const char* name = "VTKHDF/Offsets";
  if (id_size == sizeof(std::int32_t)) return PackedRows<std::int32_t>(file, name, rows);
  return PackedRows<std::int64_t>(file, name, rows);
}

PackedCells::PackedCells(Hdf5Output& file, std::int64_t partitions, const VtkhdfBefore& all,
                         std::int64_t id_size)
    : offsets_(offsets_in(file, all.cells + partitions, id_size)),
      types_(file, "VTKHDF/Types", all.cells),
      subdomains_(file, "VTKHDF/CellData/subdomain", all.cells),
      regions_(file, "VTKHDF/CellData/region", all.cells),
      patches_(file, "VTKHDF/CellData/patch", all.cells) {}

void PackedCells::add(const NumberedPart& part, const VtkhdfCounts& counts,
                      const VtkhdfBefore& before) {
  std::visit(
      [&]<class Id>(PackedRows<Id>& offsets) {
        // A partition has one offset more than cells.
        offsets.go_to(before.cells + part.number);
        Id offset = 0;
        offsets.add(offset);
        for_each_run(counts, [&](ElementType type, std::size_t count) {
          const Id step = static_cast<Id>(nodes_of(type));
          for (std::size_t i = 0; i < count; ++i) offsets.add(offset += step);
        });
      },
      offsets_);
  types_.go_to(before.cells);
  for_each_run(counts,
               [&](ElementType type, std::size_t count) { types_.add(count, type_code(type)); });
  subdomains_.go_to(before.cells);
  subdomains_.add(at(cells_of(counts)), part.number);
  regions_.go_to(before.cells);
  add_regions(part, counts);
  patches_.go_to(before.cells);
  add_patches(part, counts);
}

void PackedCells::add_regions(const NumberedPart& part, const VtkhdfCounts& counts) {
  for_each_run(counts, [&](ElementType type, std::size_t count) {
    const std::vector<std::int32_t>& of_each = type == ElementType::tet ? part.region_of_tet
                                               : type == ElementType::triangle
                                                   ? part.region_of_face
                                                   : part.blocks[type].regions;
    add_of_each(of_each, count, part.region, regions_);
  });
}

void PackedCells::add_patches(const NumberedPart& part, const VtkhdfCounts& counts) {
  for_each_run(counts, [&](ElementType type, std::size_t count) {
    if (is_cell(type)) {
      patches_.add(count, no_patch);
      return;
    }
    const std::vector<std::int32_t>& patches =
        type == ElementType::triangle ? part.patch_of_face : part.blocks[type].patches;
    TF_CHECK(patches.size() == count);
    add_of_each(patches, count, no_patch, patches_);
  });
}

void PackedCells::finish() {
  std::visit([](auto& offsets) { offsets.finish(); }, offsets_);
  types_.finish();
  subdomains_.finish();
  regions_.finish();
  patches_.finish();
}

}  // namespace tetfarm
