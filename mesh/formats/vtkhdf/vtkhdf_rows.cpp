#include "mesh/formats/vtkhdf/vtkhdf_rows.h"

#include <algorithm>

#include "base/check.h"
#include "mesh/core/element_block.h"

namespace tetfarm {
namespace {

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

template <class Id>
FileRange write_ids(const VtkhdfPlace& place, const NumberedPart& part, OutputFile* file) {
  Row<Id> ids(file, place);
  ids.add_nodes(part.tets);
  for (const ElementType type : cell_block_types) ids.add_nodes(type, part.blocks[type]);
  ids.add_nodes(part.faces);
  for (const ElementType type : face_block_types) ids.add_nodes(type, part.blocks[type]);
  return ids.finish();
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
  const VtkhdfCellPlaces here = cell_places(places, before, vtkhdf_counts(part));
  std::vector<FileRange> written = {places.id_size == sizeof(std::int32_t)
                                        ? write_ids<std::int32_t>(here.connectivity, part, file)
                                        : write_ids<std::int64_t>(here.connectivity, part, file)};
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
