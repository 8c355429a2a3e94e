#include "mesh/formats/vtkhdf/vtkhdf_cells.h"

#include <algorithm>

#include "base/array_index.h"

namespace tetfarm {
namespace {

template <class Element>
const std::int64_t* take(const std::int64_t* ids, Element& element) {
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

std::int64_t VtkhdfCells::count_tets() {
  std::int64_t tets = 0;
  for_each_block([&](std::int64_t, std::int64_t cells) { tets += tets_of_block(cells); });
  return tets;
}

std::vector<std::int32_t> VtkhdfCells::patches(bool has_patches, std::int64_t faces) {
  std::vector<std::int32_t> patch_of_face(at(faces), 0);
  if (!has_patches) return patch_of_face;
  const Hdf5Rows patch_rows = file_.rows("VTKHDF/CellData/patch");
  patch_rows.check(here_.first_cell, here_.cells);
  std::vector<std::int32_t> patches;
  std::size_t face = 0;
  for_each_block([&](std::int64_t first, std::int64_t cells) {
    if (tets_of_block(cells) == cells) return;
    patches.resize(at(cells));
    patch_rows.read(here_.first_cell + first, cells, patches.data());
    for (std::size_t i = 0; i < patches.size(); ++i) {
      if (types_[i] != vtkhdf_tet_type) patch_of_face[face++] = patches[i];
    }
  });
  return patch_of_face;
}

void VtkhdfCells::read_nodes(std::vector<Tet>& tets, std::vector<Triangle>& faces) {
  const Hdf5Rows offset_rows = file_.rows("VTKHDF/Offsets");
  const Hdf5Rows id_rows = file_.rows("VTKHDF/Connectivity");
  id_rows.check(here_.first_id, here_.ids);
  std::vector<std::int64_t> offsets;
  std::vector<std::int64_t> ids;
  for_each_block([&](std::int64_t first, std::int64_t cells) {
    offsets.resize(at(cells) + 1);
    offset_rows.read(here_.first_cell + here_.number + first, cells + 1, offsets.data());
    check_offsets(offsets);
    ids.resize(at(offsets.back() - offsets.front()));
    id_rows.read(here_.first_id + offsets.front(), std::ssize(ids), ids.data());
    check_nodes(ids);
    const auto tets_here = at(tets_of_block(cells));
    tets.resize(tets.size() + tets_here);
    faces.resize(faces.size() + at(cells) - tets_here);
    Tet* tet = tets.data() + (tets.size() - tets_here);
    Triangle* face = faces.data() + (faces.size() + tets_here - at(cells));
    const std::int64_t* next = ids.data();
    for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
      next = types_[i] == vtkhdf_tet_type ? take(next, *tet++) : take(next, *face++);
    }
  });
}

void VtkhdfCells::check_offsets(const std::vector<std::int64_t>& offsets) const {
  for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
    const std::uint8_t type = types_[i];
    const int nodes = type == vtkhdf_tet_type ? 4 : type == vtkhdf_triangle_type ? 3 : 0;
    if (nodes == 0) {
      file_.fail("a cell of type " + std::to_string(type) +
                 "; only triangles (5) and tetrahedra (10) are read");
    }
    if (offsets[i] < 0 || offsets[i + 1] > here_.ids || offsets[i + 1] - offsets[i] != nodes) {
      file_.fail("the offset of a cell is wrong");
    }
  }
}

void VtkhdfCells::check_nodes(const std::vector<std::int64_t>& ids) const {
  const auto points = static_cast<std::uint64_t>(here_.points);
  bool is_wrong = false;
  for (const std::int64_t v : ids) is_wrong |= static_cast<std::uint64_t>(v) >= points;
  if (is_wrong) file_.fail("a cell has a node that does not exist");
}

}  // namespace tetfarm
