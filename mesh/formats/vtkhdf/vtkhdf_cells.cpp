#include "mesh/formats/vtkhdf/vtkhdf_cells.h"

#include <algorithm>

#include "base/array_index.h"

namespace tetfarm {
namespace {

template <class Id, class Element>
const Id* take(const Id* ids, Element& element) {
  for (std::int32_t& v : element) v = static_cast<std::int32_t>(*ids++);
  return ids;
}

}  // namespace

VtkhdfCells::VtkhdfCells(const Hdf5Input& file, const VtkhdfPartition& here)
    : file_(file),
      here_(here),
      type_rows_(file.rows("VTKHDF/Types")),
      types_(at(std::min(here.cells, vtkhdf_cells_of_block))) {
  type_rows_.check(here.first_cell, here.cells);
}

template <class Visit>
void VtkhdfCells::for_each_block(const Visit& visit) {
  for (std::int64_t first = 0; first < here_.cells; first += vtkhdf_cells_of_block) {
    const std::int64_t cells = std::min(vtkhdf_cells_of_block, here_.cells - first);
    type_rows_.read(here_.first_cell + first, cells, types_.data());
    visit(first, cells);
  }
}

std::int64_t VtkhdfCells::tets_of_block(std::int64_t cells) const {
  return std::count(types_.begin(), types_.begin() + cells, vtkhdf_tet_type);
}

/// Whether there are others than tets and triangles.
bool VtkhdfCells::has_blocks(std::int64_t cells) const {
  return std::any_of(types_.begin(), types_.begin() + cells, [](std::uint8_t type) {
    return type != vtkhdf_tet_type && type != vtkhdf_triangle_type;
  });
}

ElementCounts VtkhdfCells::count() {
  ElementCounts counts;
  for_each_block([&](std::int64_t, std::int64_t cells) {
    const std::int64_t tets = tets_of_block(cells);
    counts[ElementType::tet] += tets;
    if (!has_blocks(cells)) {
      counts[ElementType::triangle] += cells - tets;
      return;
    }
    for (std::int64_t i = 0; i < cells; ++i) {
      const std::uint8_t code = types_[at(i)];
      if (code != vtkhdf_tet_type) ++counts[type_of_cell(code)];
    }
  });
  return counts;
}

ElementType VtkhdfCells::type_of_cell(std::uint8_t code) const {
  const std::optional<ElementType> type = type_of(ElementCodes::vtk, code);
  if (!type) {
    file_.fail("a cell of type " + std::to_string(code) +
               "; only triangles (5), quads (9), tetrahedra (10), hexahedra (12), wedges (13) and "
               "pyramids (14) are read");
  }
  return *type;
}

void VtkhdfCells::read_patches(bool has_patches, const ElementCounts& counts, NumberedPart& part) {
  part.patch_of_face.assign(at(counts[ElementType::triangle]), 0);
  for (const ElementType type : face_block_types) {
    part.blocks[type].patches.assign(at(counts[type]), 0);
  }
  if (!has_patches) return;
  const Hdf5Rows patch_rows = file_.rows("VTKHDF/CellData/patch");
  patch_rows.check(here_.first_cell, here_.cells);
  std::vector<std::int32_t> patches;
  ByType<std::size_t> next;
  for_each_block([&](std::int64_t first, std::int64_t cells) {
    if (tets_of_block(cells) == cells) return;
    patches.resize(at(cells));
    patch_rows.read(here_.first_cell + first, cells, patches.data());
    for (std::size_t i = 0; i < patches.size(); ++i) {
      if (types_[i] == vtkhdf_triangle_type) {
        part.patch_of_face[next[ElementType::triangle]++] = patches[i];
      } else if (types_[i] != vtkhdf_tet_type) {
        const ElementType type = type_of_cell(types_[i]);
        if (!is_cell(type)) part.blocks[type].patches[next[type]++] = patches[i];
      }
    }
  });
}

/// As they are in the file: converted by the library, they would cost more than to be read.
void VtkhdfCells::read_nodes(NumberedPart& part) {
  const Hdf5Rows id_rows = file_.rows("VTKHDF/Connectivity");
  id_rows.check(here_.first_id, here_.ids);
  if (id_rows.number_size() <= sizeof(std::int32_t)) {
    read_nodes_as<std::int32_t>(id_rows, part);
  } else {
    read_nodes_as<std::int64_t>(id_rows, part);
  }
}

template <class Id>
void VtkhdfCells::read_nodes_as(const Hdf5Rows& id_rows, NumberedPart& part) {
  std::vector<Tet>& tets = part.tets;
  std::vector<Triangle>& faces = part.faces;
  const Hdf5Rows offset_rows = file_.rows("VTKHDF/Offsets");
  std::vector<std::int64_t> offsets;
  std::vector<Id> ids;
  for_each_block([&](std::int64_t first, std::int64_t cells) {
    offsets.resize(at(cells) + 1);
    offset_rows.read(here_.first_cell + here_.number + first, cells + 1, offsets.data());
    check_offsets(offsets);
    ids.resize(at(offsets.back() - offsets.front()));
    id_rows.read(here_.first_id + offsets.front(), std::ssize(ids), ids.data());
    check_nodes(ids);
    if (has_blocks(cells)) {
      read_mixed_nodes(ids.data(), cells, part);
      return;
    }
    const auto tets_here = at(tets_of_block(cells));
    tets.resize(tets.size() + tets_here);
    faces.resize(faces.size() + at(cells) - tets_here);
    Tet* tet = tets.data() + (tets.size() - tets_here);
    Triangle* face = faces.data() + (faces.size() + tets_here - at(cells));
    const Id* next = ids.data();
    for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
      next = types_[i] == vtkhdf_tet_type ? take(next, *tet++) : take(next, *face++);
    }
  });
}

template <class Id>
void VtkhdfCells::read_mixed_nodes(const Id* next, std::int64_t cells, NumberedPart& part) const {
  for (std::int64_t i = 0; i < cells; ++i) {
    const ElementType type = type_of_cell(types_[at(i)]);
    if (type == ElementType::tet) {
      next = take(next, part.tets.emplace_back());
    } else if (type == ElementType::triangle) {
      next = take(next, part.faces.emplace_back());
    } else {
      std::vector<std::int32_t>& nodes = part.blocks[type].nodes;
      const std::size_t count = nodes_of(type);
      nodes.resize(nodes.size() + count);
      take_from_order_of(ElementCodes::vtk, type, std::span(next, count),
                         std::span(nodes).last(count));
      next += count;
    }
  }
}

void VtkhdfCells::check_offsets(const std::vector<std::int64_t>& offsets) const {
  for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
    const std::uint8_t code = types_[i];
    const auto nodes =
        static_cast<std::int64_t>(code == vtkhdf_tet_type        ? 4
                                  : code == vtkhdf_triangle_type ? 3
                                                                 : nodes_of(type_of_cell(code)));
    if (offsets[i] < 0 || offsets[i + 1] > here_.ids || offsets[i + 1] - offsets[i] != nodes) {
      file_.fail("the offset of a cell is wrong");
    }
  }
}

template <class Id>
void VtkhdfCells::check_nodes(const std::vector<Id>& ids) const {
  const auto points = static_cast<std::uint64_t>(here_.points);
  bool is_wrong = false;
  for (const Id v : ids) is_wrong |= static_cast<std::uint64_t>(v) >= points;  // or negative
  if (is_wrong) file_.fail("a cell has a node that does not exist");
}

}  // namespace tetfarm
