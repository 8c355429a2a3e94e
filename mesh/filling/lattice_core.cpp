#include "mesh/filling/lattice_core.h"

#include <bit>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

// Which tets.
//
// Type 4 * axis + 2 * along + side of a cell: the tet on the cell's high face normal to `axis`.
// With u and v the axes after it, the tet's edge runs along u at the low or high side of v (along
// 0), or along v at the low or high side of u (along 1). Its nodes: the cell's centre, the centre
// beyond the face, and the edge's low and high end, these two swapped where that makes it positive.

constexpr int tets_of_cell = 12;

constexpr unsigned all_types = (1U << tets_of_cell) - 1;

/// How many of a cell's tets a mask has. std::popcount is a call where the machine's own
/// instruction may not be used.
constexpr std::array<std::uint8_t, 64> bits_of_six = [] {
  std::array<std::uint8_t, 64> bits{};
  for (std::size_t mask = 0; mask < 64; ++mask) {
    bits[mask] = static_cast<std::uint8_t>(std::popcount(mask));
  }
  return bits;
}();
static_assert(tets_of_cell <= 12);
std::int32_t count_of(unsigned mask) { return bits_of_six[mask & 63U] + bits_of_six[mask >> 6U]; }

constexpr int tet_type(int axis, int along, int side) { return 4 * axis + 2 * along + side; }
constexpr int ends_swapped(int along, int side) { return (along == 0) == (side == 1) ? 1 : 0; }
constexpr std::size_t bit(int axis) { return std::size_t{1} << axis; }

/// The offsets of the corners at the low and high end of the edge of a tet.
struct EdgeEnds {
  std::size_t low;
  std::size_t high;
};
constexpr EdgeEnds edge_ends(int axis, int along, int side) {
  const std::size_t u = bit((axis + 1) % 3), v = bit((axis + 2) % 3);
  const std::size_t low = bit(axis) | (side == 0 ? 0 : (along == 0 ? v : u));
  return {low, low | (along == 0 ? u : v)};
}

std::int32_t step(const LatticeGrid& grid, std::int32_t slot, int axis, int by) {
  return grid.neighbour(slot, axis == 0 ? by : 0, axis == 1 ? by : 0, axis == 2 ? by : 0);
}

}  // namespace

LatticeCore::LatticeCore(LatticeGrid grid, std::vector<std::uint8_t> is_core)
    : grid_(std::move(grid)), is_core_(std::move(is_core)) {
  find_tets();
}

std::vector<std::int32_t> LatticeCore::core_nodes() const {
  std::vector<std::int32_t> nodes;
  for (std::size_t v = 0; v < is_core_.size(); ++v) {
    if (is_core_[v] != 0) nodes.push_back(static_cast<std::int32_t>(v));
  }
  return nodes;
}

void LatticeCore::leave_out(std::span<const std::int32_t> nodes) {
  for (const std::int32_t v : nodes) is_core_[at(v)] = 0;
  find_tets();
}

void LatticeCore::find_tets() {
  cells_.assign(at(grid_.slot_count()), {});
  hull_.clear();
  tet_count_ = 0;
  for (std::int32_t slot = 0; slot < grid_.slot_count(); ++slot) {
    const std::uint16_t present = find_tets_of(slot);
    cells_[at(slot)] = {tet_count_, present};
    tet_count_ += count_of(present);
  }
  for (std::int32_t slot = 0; slot < grid_.slot_count(); ++slot) {
    if (!has_tets_near(slot) || has_all_tets_near(slot)) continue;
    visit_touching(slot, [this](const Side& a, const Side& b) {
      if (number_of(a) < 0) {
        if (number_of(b) >= 0) add_to_hull(b);
      } else if (number_of(b) < 0) {
        add_to_hull(a);
      }
    });
  }
}

unsigned LatticeCore::present_at(std::int32_t slot) const {
  return slot == LatticeGrid::none ? 0 : cells_[at(slot)].present;
}

bool LatticeCore::has_tets_near(std::int32_t slot) const {
  return (present_at(slot) | present_at(step(grid_, slot, 0, -1)) |
          present_at(step(grid_, slot, 1, -1)) | present_at(step(grid_, slot, 2, -1))) != 0;
}

bool LatticeCore::has_all_tets_near(std::int32_t slot) const {
  return (present_at(slot) & present_at(step(grid_, slot, 0, -1)) &
          present_at(step(grid_, slot, 1, -1)) & present_at(step(grid_, slot, 2, -1))) == all_types;
}

std::uint16_t LatticeCore::find_tets_of(std::int32_t slot) const {
  const std::int32_t centre = grid_.centre(slot);
  if (centre == LatticeGrid::none) return 0;
  std::array<bool, 8> is_core_corner;
  for (std::size_t k = 0; k < 8; ++k) {
    const std::int32_t v = grid_.corner(slot, k);
    is_core_corner[k] = v != LatticeGrid::none && is_core(v);
  }
  unsigned present = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t beyond = step(grid_, slot, axis, 1);
    if (beyond == LatticeGrid::none || grid_.centre(beyond) == LatticeGrid::none) continue;
    const bool has_core_centre = is_core(centre) || is_core(grid_.centre(beyond));
    for (const int along : {0, 1}) {
      for (const int side : {0, 1}) {
        const EdgeEnds ends = edge_ends(axis, along, side);
        if (has_core_centre || is_core_corner[ends.low] || is_core_corner[ends.high]) {
          present |= 1U << tet_type(axis, along, side);
        }
      }
    }
  }
  return static_cast<std::uint16_t>(present);
}

std::int32_t LatticeCore::number_of(const Side& side) const {
  if (side.slot == LatticeGrid::none) return -1;
  const CellTets& cell = cells_[at(side.slot)];
  const unsigned mask = 1U << side.type;
  if ((cell.present & mask) == 0) return -1;
  return cell.first + count_of(cell.present & (mask - 1));
}

Tet LatticeCore::nodes_of(std::int32_t slot, int type) const {
  const int axis = type / 4, along = type / 2 % 2, side = type % 2;
  const EdgeEnds ends = edge_ends(axis, along, side);
  Tet tet = {grid_.centre(slot), grid_.centre(step(grid_, slot, axis, 1)),
             grid_.corner(slot, ends.low), grid_.corner(slot, ends.high)};
  if (ends_swapped(along, side) != 0) std::swap(tet[2], tet[3]);
  return tet;
}

template <class Visitor>
void LatticeCore::visit_touching(std::int32_t slot, Visitor&& visit) const {
  // The four tets on one face lie round the line between the two centres: each two of them touch at
  // a corner of the face, (x, y) on the axes u and v, with the faces opposite the edges' other
  // ends.
  if (cells_[at(slot)].present != 0) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const int x : {0, 1}) {
        for (const int y : {0, 1}) {
          visit(Side{slot, tet_type(axis, 0, y), 2 + ((1 - x) ^ ends_swapped(0, y))},
                Side{slot, tet_type(axis, 1, x), 2 + ((1 - y) ^ ends_swapped(1, x))});
        }
      }
    }
  }
  // At each edge of the cell, along d, two tets share the edge and the cell's centre, one on each
  // face there. Seen from the face normal to m the axes are n and d, from that normal to n d and m.
  const std::array<std::int32_t, 3> below = {step(grid_, slot, 0, -1), step(grid_, slot, 1, -1),
                                             step(grid_, slot, 2, -1)};
  for (int d = 0; d < 3; ++d) {
    const int m = (d + 1) % 3;
    const int n = (d + 2) % 3;
    for (const int on_m : {0, 1}) {
      for (const int on_n : {0, 1}) {
        visit(Side{on_m == 1 ? slot : below[at(m)], tet_type(m, 1, on_n), on_m},
              Side{on_n == 1 ? slot : below[at(n)], tet_type(n, 0, on_m), on_n});
      }
    }
  }
}

void LatticeCore::add_to_hull(const Side& side) {
  hull_.push_back({face_handle(number_of(side), side.face), nodes_of(side.slot, side.type)});
}

void LatticeCore::write(TetComplex& complex, std::int32_t first,
                        std::span<const std::int32_t> node_numbers) const {
  for (std::int32_t slot = 0; slot < grid_.slot_count(); ++slot) {
    const CellTets& cell = cells_[at(slot)];
    if (cell.present == 0) continue;
    std::int32_t tet = first + cell.first;
    for (int type = 0; type < tets_of_cell; ++type) {
      if ((cell.present >> type & 1U) == 0) continue;
      Tet nodes = nodes_of(slot, type);
      for (std::int32_t& v : nodes) {
        TF_CHECK(v != LatticeGrid::none);
        v = node_numbers[at(v)];
        complex.node2tet[at(v)] = tet;
      }
      complex.nodes[at(tet)] = nodes;
      complex.neighbours[at(tet)] = {no_face, no_face, no_face, no_face};
      ++tet;
    }
  }
  for (std::int32_t slot = 0; slot < grid_.slot_count(); ++slot) {
    if (!has_tets_near(slot)) continue;
    visit_touching(slot, [&](const Side& a, const Side& b) {
      const std::int32_t tet_a = number_of(a);
      const std::int32_t tet_b = number_of(b);
      if (tet_a < 0 || tet_b < 0) return;
      complex.glue(face_handle(first + tet_a, a.face), face_handle(first + tet_b, b.face));
    });
  }
}

}  // namespace tetfarm
