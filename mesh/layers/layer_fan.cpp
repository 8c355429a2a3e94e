#include "mesh/layers/layer_fan.h"

#include "base/array_index.h"
#include "base/check.h"

namespace tetfarm {
namespace {

using enum ElementType;

constexpr std::uint8_t a0 = 0;
constexpr std::uint8_t a1 = 1;
constexpr std::uint8_t b0 = 2;
constexpr std::uint8_t b1 = 3;
constexpr std::uint8_t a = fan_foot_from;
constexpr std::uint8_t b = fan_foot_to;
constexpr std::uint8_t c = fan_centre;

bool is_corner(const PieceLines& lines) { return lines[b0]->foot == lines[a0]->foot; }

bool goes_to_one(const PieceLines& lines) { return lines[b0] == lines[b1]; }

bool opens(const PieceLines& lines, std::uint8_t line) { return lines[line]->stop > 0; }

/// Both ends go on from the wall together.
bool is_lying_prism(const PieceLines& lines) {
  return !goes_to_one(lines) && opens(lines, a0) && opens(lines, b0) &&
         lines[a0]->early == lines[b0]->early;
}

std::vector<FanCell> cells_of_lying_prism() {
  return {{pyramid, {a, b, b0, a0, c}}, {pyramid, {b, a, a1, b1, c}}, {tet, {a, a0, a1, c}},
          {tet, {b, b1, b0, c}},        {tet, {a0, b0, b1, c}},       {tet, {a0, b1, a1, c}}};
}

/// The end with two lines goes on first, then the other.
std::vector<FanCell> cells_from_early(const PieceLines& lines) {
  std::vector<FanCell> cells = {{tet, {a, a0, a1, b}}};
  if (!opens(lines, b0)) return cells;
  if (goes_to_one(lines)) {
    cells.push_back({tet, {b, a0, a1, b0}});
  } else {
    cells.push_back({tet, {a0, b0, b1, b}});
    cells.push_back({tet, {a0, b1, a1, b}});
  }
  return cells;
}

std::vector<FanCell> cells_to_early(const PieceLines& lines) {
  std::vector<FanCell> cells = {{tet, {b, b1, b0, a}}};
  if (!opens(lines, a0)) return cells;
  cells.push_back({tet, {a0, b0, b1, a}});
  cells.push_back({tet, {a0, b1, a1, a}});
  return cells;
}

}  // namespace

std::vector<FanCell> base_cells(const PieceLines& lines) {
  TF_CHECK(lines[a0]->foot == lines[a1]->foot && lines[b0]->foot == lines[b1]->foot);
  if (is_corner(lines)) {
    if (!opens(lines, a0)) return {};
    return {{tet, {a0, b0, a1, a}}};
  }
  if (is_lying_prism(lines)) return cells_of_lying_prism();
  if (opens(lines, a0) && (!opens(lines, b0) || lines[a0]->early)) return cells_from_early(lines);
  if (goes_to_one(lines)) {
    TF_CHECK(!opens(lines, a0));
    return {};
  }
  if (!opens(lines, b0)) return {};
  return cells_to_early(lines);
}

bool has_centre(const PieceLines& lines) { return is_lying_prism(lines); }

std::array<Vec3, fan_nodes> base_points(const PieceLines& lines) {
  std::array<Vec3, fan_nodes> points;
  Vec3 sum;
  for (std::uint8_t k = 0; k < lines.size(); ++k) {
    points[k] = point_of(*lines[k], opens(lines, k) ? 1 : 0);
    sum += points[k];
  }
  points[fan_foot_from] = lines[a0]->at;
  points[fan_foot_to] = lines[b0]->at;
  points[fan_centre] = (sum + points[fan_foot_from] + points[fan_foot_to]) / 6.0;
  return points;
}

std::vector<std::array<std::uint8_t, 3>> open_triangles(const PieceLines& lines) {
  const bool from_opens = opens(lines, a0);
  const bool to_opens = opens(lines, b0);
  std::vector<std::array<std::uint8_t, 3>> triangles;
  if (goes_to_one(lines)) {
    if (from_opens) triangles.push_back({a0, b0, a1});
    return triangles;
  }
  if (to_opens) triangles.push_back({a0, b0, b1});
  if (from_opens) triangles.push_back({a0, b1, a1});
  return triangles;
}

PieceLines lines_of(const LayerPlan& plan, const FanPiece& piece) {
  return {&plan.lines[at(piece.from[0])], &plan.lines[at(piece.from[1])],
          &plan.lines[at(piece.to[0])], &plan.lines[at(piece.to[1])]};
}

std::vector<Triangle> open_triangles(const LayerPlan& plan, const FanPiece& piece) {
  const std::array<std::int32_t, 4> numbers = numbers_of(piece);
  std::vector<Triangle> triangles;
  for (const auto& [i, j, k] : open_triangles(lines_of(plan, piece))) {
    triangles.push_back({numbers[i], numbers[j], numbers[k]});
  }
  return triangles;
}

}  // namespace tetfarm
