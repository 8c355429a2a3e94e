#include "mesh/formats/vtkhdf/vtkhdf_rows.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/core/element_block.h"

namespace tetfarm {
namespace {

constexpr std::int32_t no_patch = -1;
/// What is written at once: it stays in the processor's caches until then.
constexpr std::size_t values_of_block = 65536;

/// Writes values one after the other, in blocks.
template <class T>
class Row {
 public:
  Row(OutputFile* file, const VtkhdfPlace& place)
      : file_(file), place_(place), next_(place.offset) {
    values_.reserve(values_of_block);
  }

  void add(T value) {
    values_.push_back(value);
    if (values_.size() == values_of_block) store();
  }
  void add(std::size_t count, T value) {
    while (count > 0) {
      const std::size_t here = std::min(count, values_of_block - values_.size());
      values_.resize(values_.size() + here, value);
      if (values_.size() == values_of_block) store();
      count -= here;
    }
  }
  template <class Element>
  void add_nodes(const std::vector<Element>& elements) {
    for (const Element& element : elements) {
      for (const std::int32_t v : element) add(v);
    }
  }
  /// In VTK's order.
  void add_nodes(ElementType type, const ElementBlock& block) {
    std::array<T, most_element_nodes> nodes;
    for (std::size_t i = 0; i < block.size(); ++i) {
      const std::span<T> here(nodes.data(), nodes_of(type));
      put_in_order_of(ElementCodes::vtk, type, block.element(type, i), here);
      for (const T node : here) add(node);
    }
  }
  FileRange finish() {
    store();
    TF_CHECK(next_ == place_.offset + place_.size);
    return {place_.offset, place_.size, hasher_.finish()};
  }

 private:
  void store() {
    const std::size_t bytes = values_.size() * sizeof(T);
    hasher_.add(values_.data(), bytes);
    if (file_ != nullptr) file_->write(next_, values_);
    next_ += static_cast<std::int64_t>(bytes);
    values_.clear();
  }

  OutputFile* file_;
  VtkhdfPlace place_;
  std::int64_t next_;
  Hasher hasher_;
  std::vector<T> values_;
};

constexpr auto vtk_code(ElementType type) {
  return static_cast<std::uint8_t>(code_of(ElementCodes::vtk, type));
}

FileRange write_offsets(const VtkhdfPlace& place, const NumberedPart& part, OutputFile* file) {
  Row<std::int64_t> offsets(file, place);
  std::int64_t offset = 0;
  offsets.add(offset);
  const auto add = [&](ElementType type, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      offsets.add(offset += static_cast<std::int64_t>(nodes_of(type)));
    }
  };
  add(ElementType::tet, part.tets.size());
  for (const ElementType type : cell_block_types) add(type, part.blocks[type].size());
  add(ElementType::triangle, part.faces.size());
  for (const ElementType type : face_block_types) add(type, part.blocks[type].size());
  return offsets.finish();
}

FileRange write_regions(const VtkhdfPlace& place, const NumberedPart& part, OutputFile* file) {
  Row<std::int32_t> regions(file, place);
  const auto add = [&](const std::vector<std::int32_t>& of_each, std::size_t count) {
    if (of_each.empty()) regions.add(count, part.region);
    for (const std::int32_t region : of_each) regions.add(region);
  };
  add(part.region_of_tet, part.tets.size());
  for (const ElementType type : cell_block_types) add(part.blocks[type].regions, 0);
  add(part.region_of_face, part.faces.size());
  for (const ElementType type : face_block_types) add(part.blocks[type].regions, 0);
  return regions.finish();
}

FileRange write_mark(const VtkhdfPlace& place, CellMark mark, const NumberedPart& part,
                     OutputFile* file) {
  const std::vector<std::int32_t>& of_cells = part.marks[mark];
  const auto cells = static_cast<std::size_t>(cells_of(part));
  TF_CHECK(of_cells.empty() || of_cells.size() == cells);
  Row<std::int32_t> values(file, place);
  if (of_cells.empty()) values.add(cells, 0);
  for (const std::int32_t value : of_cells) values.add(value);
  values.add(static_cast<std::size_t>(boundary_faces_of(part)), 0);
  return values.finish();
}

void write_feet(const VtkhdfFeetPlaces& places, const VtkhdfBefore& before,
                const NumberedPart& part, OutputFile& file) {
  const std::size_t nodes = part.nodes.size();
  const NodeFeet none = {std::vector<std::int64_t>(part.feet.empty() ? nodes : 0, no_foot),
                         std::vector<std::int32_t>(part.feet.empty() ? nodes : 0, no_foot)};
  const NodeFeet& feet = part.feet.empty() ? none : part.feet;
  TF_CHECK(feet.foot.size() == nodes && feet.depth.size() == nodes);
  file.write(places.foot + before.points * 8, feet.foot);
  file.write(places.depth + before.points * 4, feet.depth);
}

}  // namespace

std::vector<FileRange> write_vtkhdf_cells(const VtkhdfPlaces& places, const VtkhdfBefore& before,
                                          const NumberedPart& part, OutputFile* file) {
  const VtkhdfCellPlaces here = cell_places(places, part.number, before, vtkhdf_counts(part));
  const auto cells = static_cast<std::size_t>(cells_of(part));
  const auto faces = static_cast<std::size_t>(boundary_faces_of(part));
  Row<std::int64_t> ids(file, here.connectivity);
  ids.add_nodes(part.tets);
  for (const ElementType type : cell_block_types) ids.add_nodes(type, part.blocks[type]);
  ids.add_nodes(part.faces);
  for (const ElementType type : face_block_types) ids.add_nodes(type, part.blocks[type]);
  std::vector<FileRange> written = {ids.finish()};
  written.push_back(write_offsets(here.offsets, part, file));
  Row<std::uint8_t> types(file, here.types);
  types.add(part.tets.size(), vtk_code(ElementType::tet));
  for (const ElementType type : cell_block_types) {
    types.add(part.blocks[type].size(), vtk_code(type));
  }
  types.add(part.faces.size(), vtk_code(ElementType::triangle));
  for (const ElementType type : face_block_types) {
    types.add(part.blocks[type].size(), vtk_code(type));
  }
  written.push_back(types.finish());
  Row<std::int32_t> subdomains(file, here.subdomains);
  subdomains.add(cells + faces, part.number);
  written.push_back(subdomains.finish());
  written.push_back(write_regions(here.regions, part, file));
  TF_CHECK(part.patch_of_face.size() == part.faces.size());
  Row<std::int32_t> patches(file, here.patches);
  patches.add(cells, no_patch);
  for (const std::int32_t patch : part.patch_of_face) patches.add(patch);
  for (const ElementType type : face_block_types) {
    for (const std::int32_t patch : part.blocks[type].patches) patches.add(patch);
  }
  written.push_back(patches.finish());
  for (std::size_t i = 0; i < places.marks.size(); ++i) {
    written.push_back(write_mark(here.marks[i], places.marks[i].first, part, file));
  }
  return written;
}

void write_vtkhdf_points(const VtkhdfPlaces& places, const VtkhdfBefore& before,
                         const NumberedPart& part, OutputFile& file) {
  constexpr std::int64_t bytes_of_point = 24;
  static_assert(sizeof(Vec3) == bytes_of_point);
  TF_CHECK(part.local2global.size() == part.nodes.size());
  file.write(places.points + before.points * bytes_of_point, part.nodes);
  file.write(places.node_numbers + before.points * 8, part.local2global);
  if (places.feet) write_feet(*places.feet, before, part, file);
}

}  // namespace tetfarm
