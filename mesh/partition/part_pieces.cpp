#include "mesh/partition/part_pieces.h"

#include <algorithm>
#include <numeric>

#include "base/array_index.h"
#include "base/check.h"
#include "base/error.h"
#include "mesh/formats/node_records.h"

namespace tetfarm {
namespace {

/// Of each boundary triangle the tet that has it, on the side that its normal points away from.
std::vector<std::int32_t> tets_of_boundary(const NumberedPart& part) {
  std::vector<std::pair<Triangle, std::size_t>> wanted;
  std::vector<bool> is_on_boundary(part.nodes.size(), false);
  for (std::size_t f = 0; f < part.faces.size(); ++f) {
    Triangle face = part.faces[f];
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    wanted.emplace_back(face, f);
    for (const std::int32_t v : face) is_on_boundary[at(v)] = true;
  }
  std::sort(wanted.begin(), wanted.end());
  std::vector<std::int32_t> tet_of_face(part.faces.size(), -1);
  for (std::size_t t = 0; t < part.tets.size(); ++t) {
    for (const auto& corners : tet_face_nodes) {
      Triangle face;
      for (std::size_t k = 0; k < 3; ++k) face[k] = part.tets[t][at(corners[k])];
      if (!is_on_boundary[at(face[0])] || !is_on_boundary[at(face[1])] ||
          !is_on_boundary[at(face[2])]) {
        continue;
      }
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      const auto found =
          std::lower_bound(wanted.begin(), wanted.end(), std::pair(face, std::size_t{0}));
      if (found != wanted.end() && found->first == face) {
        tet_of_face[found->second] = static_cast<std::int32_t>(t);
      }
    }
  }
  if (std::count(tet_of_face.begin(), tet_of_face.end(), -1) > 0) {
    throw InvalidInput("a boundary triangle is not an outer face of a tet",
                       "sub-domain " + std::to_string(part.number));
  }
  return tet_of_face;
}

/// The elements of one part, with their nodes numbered anew as they are met.
class PieceOfPart {
 public:
  PieceOfPart(const NumberedPart& from, std::vector<std::int32_t>& new_number)
      : from_(from), new_number_(new_number) {}

  void add_tet(std::size_t t) {
    piece_.region_of_tet.push_back(from_.region_of(t));
    piece_.tets.push_back(renumbered(from_.tets[t]));
  }
  void add_face(std::size_t f) {
    piece_.region_of_face.push_back(from_.region_of_boundary(f));
    piece_.faces.push_back(renumbered(from_.faces[f]));
    piece_.patch_of_face.push_back(from_.patch_of_face[f]);
  }
  /// The numbers are forgotten, for the next piece.
  NumberedPart take() {
    for (const std::int32_t v : old_number_) new_number_[at(v)] = -1;
    return std::move(piece_);
  }

 private:
  template <class Element>
  Element renumbered(Element element) {
    for (std::int32_t& v : element) {
      std::int32_t& number = new_number_[at(v)];
      if (number < 0) {
        number = static_cast<std::int32_t>(old_number_.size());
        old_number_.push_back(v);
        piece_.nodes.push_back(from_.nodes[at(v)]);
        piece_.local2global.push_back(global_node(from_, v));
      }
      v = number;
    }
    return element;
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

std::vector<std::size_t> order_of(const std::vector<std::int32_t>& regions) {
  std::vector<std::size_t> order(regions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return regions[a] < regions[b]; });
  return order;
}

/// Tets by regions; one region is said once.
void settle_regions(NumberedPart& part) {
  if (part.region_of_tet.empty()) return;
  const auto [least, most] =
      std::minmax_element(part.region_of_tet.begin(), part.region_of_tet.end());
  if (*least == *most) {
    part.region = *least;
    part.region_of_tet.clear();
    part.region_of_face.clear();
    return;
  }
  const std::vector<std::size_t> tets = order_of(part.region_of_tet);
  reorder(part.tets, tets);
  reorder(part.region_of_tet, tets);
}

}  // namespace

void PartPieces::add(const NumberedPart& subdomain, const std::vector<std::int32_t>& part_of_tet) {
  TF_CHECK(part_of_tet.size() == subdomain.tets.size());
  std::vector<std::int32_t> part_of_face;
  for (const std::int32_t tet : tets_of_boundary(subdomain)) {
    part_of_face.push_back(part_of_tet[at(tet)]);
  }
  const auto tets = by_part(part_of_tet, pieces_.size());
  const auto faces = by_part(part_of_face, pieces_.size());
  std::vector<std::int32_t> new_number(subdomain.nodes.size(), -1);
  for (std::size_t part = 0; part < pieces_.size(); ++part) {
    if (tets[part].empty()) continue;
    PieceOfPart piece(subdomain, new_number);
    for (const std::size_t t : tets[part]) piece.add_tet(t);
    for (const std::size_t f : faces[part]) piece.add_face(f);
    lay_down(piece.take(), part);
  }
}

void PartPieces::lay_down(const NumberedPart& piece, std::size_t part) {
  pieces_[part].push_back(
      {file_.size(), piece.nodes.size(), piece.tets.size(), piece.faces.size()});
  append_numbers(file_, piece.nodes);
  append_numbers(file_, piece.local2global);
  append_numbers(file_, piece.tets);
  append_numbers(file_, piece.region_of_tet);
  append_numbers(file_, piece.faces);
  append_numbers(file_, piece.patch_of_face);
  append_numbers(file_, piece.region_of_face);
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
  return part;
}

NumberedPart PartPieces::part(std::size_t i) const {
  NumberedPart whole;
  whole.number = static_cast<std::int32_t>(i);
  std::vector<std::int64_t> numbers;
  for (const Piece& piece : pieces_.at(i)) {
    std::vector<std::int64_t> here;
    std::int64_t place = piece.place + static_cast<std::int64_t>(piece.nodes * sizeof(Vec3));
    read_numbers(file_, place, piece.nodes, here);
    numbers.insert(numbers.end(), here.begin(), here.end());
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  whole.nodes.resize(numbers.size());
  for (const Piece& entry : pieces_.at(i)) {
    const NumberedPart piece = read(entry);
    std::vector<std::int32_t> local;
    local.reserve(piece.nodes.size());
    for (std::size_t v = 0; v < piece.nodes.size(); ++v) {
      const auto found = std::lower_bound(numbers.begin(), numbers.end(), piece.local2global[v]);
      local.push_back(static_cast<std::int32_t>(found - numbers.begin()));
      whole.nodes[at(local.back())] = piece.nodes[v];
    }
    for (Tet tet : piece.tets) {
      for (std::int32_t& v : tet) v = local[at(v)];
      whole.tets.push_back(tet);
    }
    for (Triangle face : piece.faces) {
      for (std::int32_t& v : face) v = local[at(v)];
      whole.faces.push_back(face);
    }
    const auto append = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(whole.region_of_tet, piece.region_of_tet);
    append(whole.region_of_face, piece.region_of_face);
    append(whole.patch_of_face, piece.patch_of_face);
  }
  whole.local2global = std::move(numbers);
  settle_regions(whole);
  return whole;
}

}  // namespace tetfarm
