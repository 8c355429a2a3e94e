/// The cells between the lines of a fan: several lines of one foot that go round a sharp edge or
/// corner, each next to its own faces.
///
/// Source: thesis 4.4 has one line at a node; Garimella and Shephard, "Boundary layer mesh
/// generation for viscous flow simulations", IJNME 49 (2000), open edges and corners by what they
/// call blends. In the first layer the piece between two pairs of lines is a prism that lies on an
/// edge of the wall; it is opened by a node in its middle, so that it has quads towards the prisms
/// beside it. A fan ends where the next node has one line: its last lines are early, so that sides
/// there are divided into triangles in every layer. From the second layer on what is between lines
/// is a triangle like those of the wall.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/core/elements.h"
#include "mesh/core/vec3.h"
#include "mesh/layers/layer_plan.h"

namespace tetfarm {

/// Those of a piece: two from one foot, two to the other.
using PieceLines = std::array<const LayerLine*, 4>;

/// Nodes of the first layer of a piece: the first points of its lines by their numbers from 0 to 3,
/// its feet, and the node in its middle.
inline constexpr std::uint8_t fan_foot_from = 4;
inline constexpr std::uint8_t fan_foot_to = 5;
inline constexpr std::uint8_t fan_centre = 6;
inline constexpr std::size_t fan_nodes = 7;

/// As many nodes count as the type has, in the order of elements.h.
struct FanCell {
  ElementType type = ElementType::tet;
  std::array<std::uint8_t, 5> nodes{};
};

/// The cells of the first layer; none where no line has one. @pre lines of one foot have all layers
/// or none; of two different lines `to` one foot both are early or neither, and a single one is not
/// early while those `from` are.
std::vector<FanCell> base_cells(const PieceLines& lines);

/// Whether there is a node in the middle of the piece.
bool has_centre(const PieceLines& lines);

/// Where the nodes are; those that no cell of the piece has are anywhere.
std::array<Vec3, fan_nodes> base_points(const PieceLines& lines);

/// The triangles above the first layer, turned like those of the wall, by numbers of the piece's
/// lines: layers from the second on stand on them, or they are the top. Those whose corners are
/// one point, as lines of a foot without layers are, are not among them.
std::vector<std::array<std::uint8_t, 3>> open_triangles(const PieceLines& lines);

/// The two lines at an end of a piece (0: from, 1: to), of a plan or of a chunk by the numbers that
/// `piece` has: to the left and to the right, seen from their foot along the edge.
inline std::array<std::int32_t, 2> lines_at_end(const std::array<std::int32_t, 4>& piece,
                                                std::size_t end) {
  if (end == 0) return {piece[0], piece[1]};
  return {piece[3], piece[2]};
}

/// from, from, to, to.
inline std::array<std::int32_t, 4> numbers_of(const FanPiece& piece) {
  return {piece.from[0], piece.from[1], piece.to[0], piece.to[1]};
}

/// The same of a plan, by its lines. Cost: O(1).
PieceLines lines_of(const LayerPlan& plan, const FanPiece& piece);
std::vector<Triangle> open_triangles(const LayerPlan& plan, const FanPiece& piece);

}  // namespace tetfarm
