#include "mesh/partition/part_pieces.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/assemble/part_cells.h"
#include "mesh/core/element_block.h"
#include "mesh/formats/node_records.h"
#include "mesh/partition/reordered_marks.h"

namespace tetfarm {
namespace {

using Face = FaceNodes<std::int32_t>;

/// Of each boundary face the cell that has it, on the side that its normal points away from.
std::vector<std::int32_t> cells_of_boundary(const NumberedPart& part) {
  std::vector<std::pair<Face, std::int32_t>> wanted;
  std::vector<bool> is_on_boundary(part.nodes.size(), false);
  for_each_boundary_face(part, [&](std::int32_t number, const Face& face, std::int32_t) {
    wanted.emplace_back(face.smallest_first(), number);
    for (const std::int32_t v : face) is_on_boundary[at(v)] = true;
  });
  std::sort(wanted.begin(), wanted.end());
  std::vector<std::int32_t> cell_of_face(wanted.size(), -1);
  for_each_face_of_cells(part, [&](std::int32_t cell, const Face& nodes) {
    const auto is_inside = [&](std::int32_t v) { return !is_on_boundary[at(v)]; };
    if (std::any_of(nodes.begin(), nodes.end(), is_inside)) return;
    const Face face = nodes.smallest_first();
    const auto found =
        std::lower_bound(wanted.begin(), wanted.end(), std::pair(face, std::int32_t{0}));
    if (found != wanted.end() && found->first == face) cell_of_face[at(found->second)] = cell;
  });
  if (std::count(cell_of_face.begin(), cell_of_face.end(), -1) > 0) {
    throw InvalidInput("a boundary face is not an outer face of a cell",
                       "sub-domain " + std::to_string(part.number));
  }
  return cell_of_face;
}

/// The elements of one part, with their nodes numbered anew as they are met.
class PieceOfPart {
 public:
  PieceOfPart(const NumberedPart& from, std::vector<std::int32_t>& new_number)
      : from_(from), new_number_(new_number) {}

  /// Counted as in part_cells.h, ascending.
  void add_cells(std::span<const std::size_t> cells) {
    std::size_t first = add_run(cells, 0, from_.tets.size(), [this](std::size_t t) {
      piece_.region_of_tet.push_back(from_.region_of(t));
      piece_.tets.push_back(renumbered(from_.tets[t]));
    });
    for (const ElementType type : cell_block_types) first = add_of_block(cells, first, type);
    TF_CHECK(cells.empty() || cells.back() < first);
    add_marks(cells);
  }
  void add_faces(std::span<const std::size_t> faces) {
    std::size_t first = add_run(faces, 0, from_.faces.size(), [this](std::size_t f) {
      piece_.region_of_face.push_back(from_.region_of_boundary(f));
      piece_.faces.push_back(renumbered(from_.faces[f]));
      piece_.patch_of_face.push_back(from_.patch_of_face[f]);
    });
    for (const ElementType type : face_block_types) first = add_of_block(faces, first, type);
    TF_CHECK(faces.empty() || faces.back() < first);
  }
  /// The numbers are forgotten, for the next piece.
  NumberedPart take() {
    for (const std::int32_t v : old_number_) new_number_[at(v)] = -1;
    return std::move(piece_);
  }

 private:
  /// Calls add(i) for those of `elements` that are first + i with i < count; @return first + count.
  template <class Add>
  static std::size_t add_run(std::span<const std::size_t> elements, std::size_t first,
                             std::size_t count, const Add& add) {
    auto next = std::lower_bound(elements.begin(), elements.end(), first);
    for (; next != elements.end() && *next < first + count; ++next) add(*next - first);
    return first + count;
  }

  std::size_t add_of_block(std::span<const std::size_t> elements, std::size_t first,
                           ElementType type) {
    const ElementBlock& from = from_.blocks[type];
    ElementBlock& to = piece_.blocks[type];
    return add_run(elements, first, from.size(), [&](std::size_t i) {
      for (const std::int32_t v : from.element(type, i)) to.nodes.push_back(renumbered(v));
      to.regions.push_back(from.regions[i]);
      if (!is_cell(type)) to.patches.push_back(from.patches[i]);
    });
  }

  void add_marks(std::span<const std::size_t> cells) {
    for (const CellMark mark : all_cell_marks) {
      const std::vector<std::int32_t>& from = from_.marks[mark];
      if (from.empty()) continue;
      TF_CHECK(std::ssize(from) == cells_of(from_));
      for (const std::size_t cell : cells) piece_.marks[mark].push_back(from[cell]);
    }
  }

  template <class Element>
  Element renumbered(Element element) {
    for (std::int32_t& v : element) v = renumbered(v);
    return element;
  }
  std::int32_t renumbered(std::int32_t v) {
    std::int32_t& number = new_number_[at(v)];
    if (number < 0) {
      number = static_cast<std::int32_t>(old_number_.size());
      old_number_.push_back(v);
      piece_.nodes.push_back(from_.nodes[at(v)]);
      piece_.local2global.push_back(global_node(from_, v));
      if (!from_.feet.empty()) piece_.feet.add(from_.feet.foot[at(v)], from_.feet.depth[at(v)]);
    }
    return number;
  }

  const NumberedPart& from_;
  std::vector<std::int32_t>& new_number_;
  std::vector<std::int32_t> old_number_;
  NumberedPart piece_;
};

/// Elements by part, in their order.
std::vector<std::vector<std::size_t>> by_part(const std::vector<std::int32_t>& part_of_element,
                                              std::size_t parts) {
  std::vector<std::vector<std::size_t>> elements(parts);
  for (std::size_t i = 0; i < part_of_element.size(); ++i) {
    elements.at(at(part_of_element[i])).push_back(i);
  }
  return elements;
}

template <class T>
void append_numbers(ScratchFile& file, const std::vector<T>& values) {
  file.append(values.data(), values.size() * sizeof(T));
}

template <class T>
void read_numbers(const ScratchFile& file, std::int64_t& place, std::size_t count,
                  std::vector<T>& values) {
  values.resize(count);
  file.read(place, values.data(), count * sizeof(T));
  place += static_cast<std::int64_t>(count * sizeof(T));
}

/// The values in another order.
template <class T>
void reorder(std::vector<T>& values, const std::vector<std::size_t>& order) {
  TF_CHECK(order.size() == values.size());
  std::vector<T> reordered;
  reordered.reserve(values.size());
  for (const std::size_t i : order) reordered.push_back(values[i]);
  values = std::move(reordered);
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Those of a piece, whose node v is `local[v]` in the whole.
void append_elements(const NumberedPart& piece, const std::vector<std::int32_t>& local,
                     NumberedPart& whole) {
  for (Tet tet : piece.tets) {
    for (std::int32_t& v : tet) v = local[at(v)];
    whole.tets.push_back(tet);
  }
  for (Triangle face : piece.faces) {
    for (std::int32_t& v : face) v = local[at(v)];
    whole.faces.push_back(face);
  }
  append(whole.region_of_tet, piece.region_of_tet);
  append(whole.region_of_face, piece.region_of_face);
  append(whole.patch_of_face, piece.patch_of_face);
  for_each_block(piece.blocks, [&](ElementType type, const ElementBlock& from) {
    ElementBlock& to = whole.blocks[type];
    for (const std::int32_t v : from.nodes) to.nodes.push_back(local[at(v)]);
    append(to.regions, from.regions);
    append(to.patches, from.patches);
  });
}

/// Those of a piece, whose node v is `local[v]` in the whole.
void add_feet(const NodeFeet& feet, const std::vector<std::int32_t>& local, NumberedPart& whole) {
  if (feet.empty()) return;
  whole.feet.foot.resize(whole.nodes.size(), no_foot);
  whole.feet.depth.resize(whole.nodes.size(), no_foot);
  for (std::size_t v = 0; v < local.size(); ++v) {
    if (feet.foot[v] == no_foot) continue;
    whole.feet.foot[at(local[v])] = feet.foot[v];
    whole.feet.depth[at(local[v])] = feet.depth[v];
  }
}

/// The marks of the cells of pieces, put in the order that the cells get in the whole: by type,
/// then by region, then as they came.
class MarksOfPieces {
 public:
  void add(const NumberedPart& piece) {
    const std::vector<std::int32_t> regions = regions_of_cells(piece);
    for_each_cell(piece, [&](std::int32_t cell, ElementType type, std::span<const std::int32_t>) {
      places_.emplace_back(type, regions[at(cell)]);
    });
    for (const CellMark mark : all_cell_marks) {
      append(marks_[mark], piece.marks[mark]);
      bool& has = has_.at(static_cast<std::size_t>(mark));
      has = has || !piece.marks[mark].empty();
      marks_[mark].resize(places_.size(), 0);
    }
  }

  CellMarks in_order() {
    for (const CellMark mark : all_cell_marks) {
      if (!has_.at(static_cast<std::size_t>(mark))) marks_[mark].clear();
    }
    std::vector<std::size_t> order(places_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t a, std::size_t b) { return places_[a] < places_[b]; });
    return reordered_marks(marks_, order);
  }

 private:
  std::vector<std::pair<ElementType, std::int32_t>> places_;  // type and region of each cell
  CellMarks marks_;
  std::array<bool, all_cell_marks.size()> has_{};
};

std::vector<std::size_t> order_of(const std::vector<std::int32_t>& regions) {
  std::vector<std::size_t> order(regions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return regions[a] < regions[b]; });
  return order;
}

/// Cells of a type by regions; one region is said once.
void settle_regions(NumberedPart& part) {
  const std::vector<std::int32_t> regions = regions_of_cells(part);
  if (regions.empty()) return;
  const auto [least, most] = std::minmax_element(regions.begin(), regions.end());
  if (*least == *most) {
    part.region = *least;
    part.region_of_tet.clear();
    part.region_of_face.clear();
    return;
  }
  const std::vector<std::size_t> tets = order_of(part.region_of_tet);
  reorder(part.tets, tets);
  reorder(part.region_of_tet, tets);
  for (const ElementType type : cell_block_types) {
    ElementBlock& cells = part.blocks[type];
    cells = reordered(type, cells, order_of(cells.regions));
  }
}

}  // namespace

void PartPieces::add(const NumberedPart& subdomain, const std::vector<std::int32_t>& part_of_cell) {
  TF_CHECK(std::ssize(part_of_cell) == cells_of(subdomain));
  std::vector<std::int32_t> part_of_face;
  for (const std::int32_t cell : cells_of_boundary(subdomain)) {
    part_of_face.push_back(part_of_cell[at(cell)]);
  }
  const auto cells = by_part(part_of_cell, pieces_.size());
  const auto faces = by_part(part_of_face, pieces_.size());
  std::vector<std::int32_t> new_number(subdomain.nodes.size(), -1);
  for (std::size_t part = 0; part < pieces_.size(); ++part) {
    if (cells[part].empty()) continue;
    PieceOfPart piece(subdomain, new_number);
    piece.add_cells(cells[part]);
    piece.add_faces(faces[part]);
    lay_down(piece.take(), part);
  }
}

void PartPieces::lay_down(const NumberedPart& piece, std::size_t part) {
  Piece& entry = pieces_[part].emplace_back();
  entry = {file_.size(), piece.nodes.size(),    piece.tets.size(), piece.faces.size(), {},
           {},           piece.feet.foot.size()};
  append_numbers(file_, piece.nodes);
  append_numbers(file_, piece.local2global);
  append_numbers(file_, piece.tets);
  append_numbers(file_, piece.region_of_tet);
  append_numbers(file_, piece.faces);
  append_numbers(file_, piece.patch_of_face);
  append_numbers(file_, piece.region_of_face);
  for_each_block(piece.blocks, [&](ElementType type, const ElementBlock& block) {
    entry.others[type] = block.size();
    append_numbers(file_, block.nodes);
    append_numbers(file_, block.regions);
    append_numbers(file_, block.patches);
  });
  for (const CellMark mark : all_cell_marks) {
    entry.marks.at(static_cast<std::size_t>(mark)) = piece.marks[mark].size();
    append_numbers(file_, piece.marks[mark]);
  }
  append_numbers(file_, piece.feet.foot);
  append_numbers(file_, piece.feet.depth);
}

NumberedPart PartPieces::read(const Piece& piece) const {
  NumberedPart part;
  std::int64_t place = piece.place;
  read_numbers(file_, place, piece.nodes, part.nodes);
  read_numbers(file_, place, piece.nodes, part.local2global);
  read_numbers(file_, place, piece.tets, part.tets);
  read_numbers(file_, place, piece.tets, part.region_of_tet);
  read_numbers(file_, place, piece.faces, part.faces);
  read_numbers(file_, place, piece.faces, part.patch_of_face);
  read_numbers(file_, place, piece.faces, part.region_of_face);
  for_each_block(part.blocks, [&](ElementType type, ElementBlock& block) {
    const std::size_t count = piece.others[type];
    read_numbers(file_, place, count * nodes_of(type), block.nodes);
    read_numbers(file_, place, count, block.regions);
    read_numbers(file_, place, is_cell(type) ? 0 : count, block.patches);
  });
  for (const CellMark mark : all_cell_marks) {
    const std::size_t count = piece.marks.at(static_cast<std::size_t>(mark));
    read_numbers(file_, place, count, part.marks[mark]);
  }
  read_numbers(file_, place, piece.feet, part.feet.foot);
  read_numbers(file_, place, piece.feet, part.feet.depth);
  return part;
}

/// The numbers of the nodes of part i in the whole mesh, ascending.
std::vector<std::int64_t> PartPieces::numbers_of(std::size_t i) const {
  std::vector<std::int64_t> numbers;
  for (const Piece& piece : pieces_.at(i)) {
    std::vector<std::int64_t> here;
    std::int64_t place = piece.place + static_cast<std::int64_t>(piece.nodes * sizeof(Vec3));
    read_numbers(file_, place, piece.nodes, here);
    append(numbers, here);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

NumberedPart PartPieces::part(std::size_t i) const {
  NumberedPart whole;
  whole.number = static_cast<std::int32_t>(i);
  whole.local2global = numbers_of(i);
  const std::vector<std::int64_t>& numbers = whole.local2global;
  whole.nodes.resize(numbers.size());
  const bool has_marks = std::ranges::any_of(
      pieces_.at(i), [](const Piece& piece) { return piece.marks != CountsOfMarks{}; });
  MarksOfPieces marks;
  for (const Piece& entry : pieces_.at(i)) {
    const NumberedPart piece = read(entry);
    std::vector<std::int32_t> local;
    local.reserve(piece.nodes.size());
    for (std::size_t v = 0; v < piece.nodes.size(); ++v) {
      const auto found = std::lower_bound(numbers.begin(), numbers.end(), piece.local2global[v]);
      local.push_back(static_cast<std::int32_t>(found - numbers.begin()));
      whole.nodes[at(local.back())] = piece.nodes[v];
    }
    append_elements(piece, local, whole);
    add_feet(piece.feet, local, whole);
    if (has_marks) marks.add(piece);
  }
  settle_regions(whole);
  whole.marks = marks.in_order();
  return whole;
}

}  // namespace tetfarm
