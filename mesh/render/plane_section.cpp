#include "mesh/render/plane_section.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;  // lower node first

Edge edge_of(std::int32_t a, std::int32_t b) { return {std::min(a, b), std::max(a, b)}; }

/// What crosses a face: from an edge where its boundary comes up through the plane to the next one
/// where it goes down again.
struct Crossing {
  Edge from;
  Edge to;
};

class PlaneSection {
 public:
  PlaneSection(const NumberedPart& part, const Vec3& normal, double at) : part_(part) {
    for (const Vec3& p : part.nodes) above_.push_back(dot(normal, p) - at);
  }

  void add_cell(ElementType type, std::span<const std::int32_t> nodes) {
    const std::int64_t cell = cells_++;
    if (!is_cut(nodes)) return;
    std::vector<Crossing> crossings;
    for_each_face_of(type, nodes, [&](ElementType, std::span<const std::int32_t> face) {
      add_crossings(face, crossings);
    });
    while (!crossings.empty()) add_polygon(cell, crossings);
  }

  std::vector<CellSection> take() { return std::move(sections_); }

 private:
  bool is_above(std::int32_t node) const { return above_[at(node)] >= 0; }

  bool is_cut(std::span<const std::int32_t> nodes) const {
    return std::any_of(nodes.begin(), nodes.end(),
                       [&](std::int32_t node) { return is_above(node) != is_above(nodes[0]); });
  }

  void add_crossings(std::span<const std::int32_t> face, std::vector<Crossing>& crossings) const {
    const std::size_t n = face.size();
    for (std::size_t up = 0; up < n; ++up) {
      if (is_above(face[up]) || !is_above(face[(up + 1) % n])) continue;
      std::size_t down = (up + 1) % n;
      while (is_above(face[(down + 1) % n])) down = (down + 1) % n;
      crossings.push_back(
          {edge_of(face[up], face[(up + 1) % n]), edge_of(face[down], face[(down + 1) % n])});
    }
  }

  /// Follows the crossings round, and takes them away. Faces of a cell are seen from outside, so
  /// that where one ends the next begins.
  void add_polygon(std::int64_t cell, std::vector<Crossing>& crossings) {
    CellSection section{cell, {}};
    const Edge first = crossings.back().from;
    Edge next = first;
    do {
      const auto found =
          std::find_if(crossings.begin(), crossings.end(),
                       [&](const Crossing& crossing) { return crossing.from == next; });
      TF_CHECK(found != crossings.end());
      section.corners.push_back(point_on(next));
      next = found->to;
      crossings.erase(found);
    } while (next != first);
    sections_.push_back(std::move(section));
  }

  Vec3 point_on(const Edge& edge) const {
    const double a = above_[at(edge.first)];
    const double b = above_[at(edge.second)];
    const Vec3 p = part_.nodes[at(edge.first)];
    return p + a / (a - b) * (part_.nodes[at(edge.second)] - p);
  }

  const NumberedPart& part_;
  std::vector<double> above_;  // of each node
  std::int64_t cells_ = 0;
  std::vector<CellSection> sections_;
};

}  // namespace

std::vector<CellSection> plane_section(const NumberedPart& part, const Vec3& normal, double at) {
  PlaneSection section(part, normal, at);
  for (const Tet& tet : part.tets) section.add_cell(ElementType::tet, tet);
  for_each_block_cell(part.blocks, [&](ElementType type, std::span<const std::int32_t> nodes,
                                       std::int32_t) { section.add_cell(type, nodes); });
  return section.take();
}

}  // namespace tetfarm
