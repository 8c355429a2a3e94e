/// Divides the layers into chunks that are grown one by one, by anybody: each is a leaf of the
/// tree, and has all that it is made of.
///
/// Source: none in the thesis, whose layers are one process's. With layers the root of the tree is
/// divided without a plane: left of it is what the layers leave of the domain, right of it are the
/// layers, and their top is the inter-domain mesh between the two. Chunks are the leaves of a
/// balanced tree there, in the order of a Hilbert curve over the wall. A node within the layers
/// belongs to the first chunk in tree order that has cells at its line.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/core/subdomain.h"
#include "mesh/layers/layer_cells.h"
#include "mesh/layers/layer_fan.h"
#include "mesh/layers/layer_plan.h"
#include "mesh/layers/side_triangles.h"

namespace tetfarm {

/// Where the tree of a domain with layers has what.
inline constexpr TreePath unlayered_path = {2};
inline constexpr TreePath layers_path = {3};

/// A chunk has about so many cells at most, however large the wall and however many the layers.
inline constexpr std::int64_t cells_of_chunk = 200'000;

/// A line as a chunk has it: `line` without what it was asked for.
struct ChunkLine {
  LayerLine line;
  std::uint64_t owner = 0;       ///< the chunk that made its nodes between foot and top
  std::uint32_t first_node = 0;  ///< the number among the owner's of its first node there
  std::uint32_t top = 0;         ///< the number of its last node among those of the top, but where
                                 ///< that is a vertex of the surface (LayerLine::vertices)
  /// Of its last node where another line has it (LineEnd::line); its owner may be a chunk that
  /// comes later.
  std::optional<Origin> end = {};
  /// Of the node that is meant by LineEnd::inner_line or inner_vertex, which have no meaning here.
  std::optional<Origin> inner = {};

  friend bool operator==(const ChunkLine&, const ChunkLine&) = default;
};

/// The level of the node with the number first_node.
inline int first_inner_level(const LayerLine& line) { return line.low_vertex >= 0 ? 2 : 1; }

/// A LayerSide as a chunk has it: from line to line as its triangle of the wall has them.
struct ChunkSide {
  std::array<std::int32_t, 2> lines{};
  std::int32_t patch = 0;
  std::int32_t last = -1;

  friend bool operator==(const ChunkSide&, const ChunkSide&) = default;
};

/// A FanPiece as a chunk has it.
struct ChunkFan {
  std::array<std::int32_t, 4> lines{};  ///< as base_cells takes them
  std::array<FanEnd, 2> ends;

  friend bool operator==(const ChunkFan&, const ChunkFan&) = default;
};

/// A prism all of whose lines are in_tets is three tets, such a pyramid two, and a quad beside
/// layers two triangles of the surface.
/// Invariants: 1. `triangles` and `surface_triangles` have equal lengths; 2. a triangle has three
/// different lines, one of them with layers; 3. every line is one of a triangle or of a fan; 4. a
/// fan has cells, and its lines are as base_cells takes them.
struct LayerChunk {
  TreePath path;
  std::vector<ChunkLine> lines;
  std::vector<Triangle> triangles;               ///< of the wall, by their lines
  std::vector<std::uint32_t> surface_triangles;  ///< their numbers in the surface
  std::vector<ChunkSide> sides;
  std::vector<ChunkFan> fans;  ///< their nodes in the middle come after those of all lines
  /// Lowest and highest corner of the box round the inner side of all absorbing layers there are,
  /// where the chunk has some of them.
  std::optional<std::array<Vec3, 2>> within_pml;

  friend bool operator==(const LayerChunk&, const LayerChunk&) = default;
};

/// What a chunk adds to the mesh; nodes are those that it owns.
struct ChunkCounts {
  std::int64_t nodes = 0;
  std::int64_t tets = 0;
  std::int64_t pyramids = 0;
  std::int64_t prisms = 0;
  std::int64_t quads = 0;      ///< sides in planes
  std::int64_t triangles = 0;  ///< of the surface: of the wall, and those of sides

  std::int64_t cells() const { return tets + pyramids + prisms; }
  friend bool operator==(const ChunkCounts&, const ChunkCounts&) = default;
};

/// In tree order; none where nothing grows. How many they are depends on the cells alone.
/// @pre `plan` is of `surface`; most_cells > 0. Cost: O(n log n) for n wall triangles.
std::vector<LayerChunk> chunks_of(const LayerPlan& plan, const SurfaceMesh& surface,
                                  std::int64_t most_cells = cells_of_chunk);

/// The layers above a triangle.
LayerColumn column_of(const LayerChunk& chunk, const Triangle& triangle);

/// As layer_fan.h has them.
PieceLines lines_of(const LayerChunk& chunk, const ChunkFan& fan);

/// Whether the cells above the triangle are of absorbing layers. Those are whole: the lines of a
/// triangle have all the same number of them.
bool is_of_pml(const LayerChunk& chunk, const Triangle& triangle);

/// Whether the cells between the lines are divided into tets. Cost: O(lines).
bool are_in_tets(const LayerChunk& chunk, std::span<const std::int32_t> lines);

/// What lies beside the layers at a side, and above the triangle at an end of a fan that is in a
/// plane (0: from, 1: to).
LineSide side_of(const LayerChunk& chunk, const ChunkSide& side);
LineSide side_above(const LayerChunk& chunk, const ChunkFan& fan, std::size_t end);

/// Of the nodes that the chunk owns those of its lines; those in the middle of fans follow.
std::int64_t nodes_of_lines(const LayerChunk& chunk);

/// Cost: O(triangles).
ChunkCounts counts_of(const LayerChunk& chunk);

/// The lines of the numbering's table that tell of the layers (number_globally): of the root, and
/// of all from layers_path on. @pre `chunks` are those of chunks_of, and some.
std::string layer_table(const std::vector<LayerChunk>& chunks, std::int64_t top_nodes);

}  // namespace tetfarm
