#include "mesh/layers/layer_chunks.h"

#include <algorithm>
#include <utility>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/geometry/hilbert_order.h"

namespace tetfarm {
namespace {

constexpr std::int64_t tets_in_prism = 3;
constexpr std::int64_t tets_in_pyramid = 2;

/// A triangle of the wall with cells above it, or a piece of a fan with cells.
struct Layered {
  std::int32_t number = 0;  // of the triangle in the surface, or of the piece in the plan
  bool is_fan = false;
  std::array<std::int32_t, 3> lines{};
  std::int64_t cells = 0;
};

/// What there is, along a Hilbert curve.
class LayeredPlaces {
 public:
  LayeredPlaces(const LayerPlan& plan, const SurfaceMesh& surface) : plan_(plan) {
    for (const std::int32_t t : plan.wall) add_triangle(t, lines_of(plan, surface, t));
    for (std::size_t i = 0; i < plan.fans.size(); ++i) add_fan(static_cast<std::int32_t>(i));
  }

  std::vector<Layered> in_order() const {
    std::vector<Layered> in_order;
    in_order.reserve(found_.size());
    for (const std::int32_t i : hilbert_order(centroids_)) in_order.push_back(found_[at(i)]);
    return in_order;
  }

 private:
  void add_triangle(std::int32_t t, const std::array<std::int32_t, 3>& lines) {
    std::array<int, 3> stops{};
    Vec3 sum;
    bool in_tets = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const LayerLine& line = plan_.lines[at(lines[k])];
      stops[k] = line.stop;
      sum += line.at;
      in_tets = in_tets && line.in_tets;
    }
    if (layers_above(stops) == 0) return;
    found_.push_back({t, false, lines, layers_above(stops) * (in_tets ? tets_in_prism : 1)});
    centroids_.push_back(sum / 3.0);
  }

  void add_fan(std::int32_t number) {
    const FanPiece& piece = plan_.fans[at(number)];
    const PieceLines lines = lines_of(plan_, piece);
    auto cells = std::ssize(base_cells(lines));
    if (cells == 0) return;
    for (const Triangle& t : open_triangles(plan_, piece)) {
      cells += std::max({plan_.lines[at(t[0])].stop, plan_.lines[at(t[1])].stop,
                         plan_.lines[at(t[2])].stop}) -
               1;
    }
    const bool in_tets = std::all_of(lines.begin(), lines.end(),
                                     [](const LayerLine* line) { return line->in_tets; });
    if (in_tets) cells *= tets_in_prism;
    found_.push_back({number, true, {}, cells});
    centroids_.push_back((lines[0]->at + lines[2]->at) / 2.0);
  }

  const LayerPlan& plan_;
  std::vector<Layered> found_;
  std::vector<Vec3> centroids_;
};

/// The chunk of each triangle: as even as triangles allow, and none empty.
std::vector<std::size_t> chunk_of_each(const std::vector<Layered>& triangles,
                                       std::int64_t most_cells) {
  std::int64_t all = 0;
  for (const Layered& triangle : triangles) all += triangle.cells;
  const std::int64_t chunks = std::min((all + most_cells - 1) / most_cells, std::ssize(triangles));
  std::vector<std::size_t> chunk_of;
  std::int64_t before = 0;
  std::int64_t last = -1;
  std::size_t number = 0;
  for (const Layered& triangle : triangles) {
    const std::int64_t here = before * chunks / all;
    if (here != last && last >= 0) ++number;
    last = here;
    chunk_of.push_back(number);
    before += triangle.cells;
  }
  return chunk_of;
}

/// A balanced tree: the leaves from left to right, and what is above them.
struct ChunkTree {
  std::vector<TreePath> leaves;
  std::vector<TreePath> inner;
};

void add_branch(TreePath here, std::size_t leaves, ChunkTree& tree) {
  if (leaves == 1) {
    tree.leaves.push_back(here);
    return;
  }
  tree.inner.push_back(here);
  add_branch(here.left(), leaves - leaves / 2, tree);
  add_branch(here.right(), leaves / 2, tree);
}

ChunkTree chunk_tree(std::size_t chunks) {
  ChunkTree tree;
  TF_CHECK(chunks > 0);
  add_branch(layers_path, chunks, tree);
  return tree;
}

/// The number of each line's top among those of the lines whose tops are no vertices of the
/// surface.
std::vector<std::uint32_t> top_numbers(const LayerPlan& plan) {
  std::vector<std::uint32_t> numbers;
  std::uint32_t next = 0;
  for (const LayerLine& line : plan.lines) {
    numbers.push_back(next);
    if (has_top(line)) ++next;
  }
  return numbers;
}

/// How many points of the line are neither of the surface nor of the top: those from
/// first_inner_level on.
int inner_points(const LayerLine& line) {
  return std::max(0, line.stop - std::max(line.vertices, 1) - (first_inner_level(line) - 1));
}

/// Round the points at which absorbing layers end, inside.
std::array<Vec3, 2> box_within_pml(const LayerPlan& plan) {
  Box3 box;
  for (const LayerLine& line : plan.lines) {
    if (line.of_pml && line.end.depth == 0) box.add(point_of(line, line.stop));
  }
  return {box.low, box.high};
}

/// Fills chunks one after the other, in tree order.
class ChunkFiller {
 public:
  explicit ChunkFiller(const LayerPlan& plan)
      : plan_(plan),
        within_pml_(box_within_pml(plan)),
        tops_(top_numbers(plan)),
        owned_(plan.lines.size()),
        local_(plan.lines.size(), -1) {}

  /// The next chunk is begun.
  void begin(LayerChunk& chunk) {
    if (chunk_ != nullptr) {
      for (const std::int32_t line : lines_) local_[at(line)] = -1;
    }
    lines_.clear();
    next_node_ = 0;
    chunk_ = &chunk;
  }

  /// Tells the lines of a chunk that meet others where these are. @pre all chunks are filled.
  /// @param lines those of the chunk, as lines() had them.
  void add_ends(const std::vector<std::int32_t>& lines, LayerChunk& chunk) const {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const LineEnd& end = plan_.lines[at(lines[i])].end;
      ChunkLine& line = chunk.lines[i];
      if (end.line >= 0) line.end = origin_of(end.line, end.level);
      if (end.inner_vertex >= 0) line.inner = {0, static_cast<std::uint32_t>(end.inner_vertex)};
      if (end.inner_line >= 0) {
        line.inner = origin_of(end.inner_line, plan_.lines[at(end.inner_line)].stop);
      }
    }
  }

  /// Of the plan, those of the chunk that was begun last, in its order.
  const std::vector<std::int32_t>& lines() const { return lines_; }

  void add(const Layered& layered) {
    if (layered.is_fan) {
      add_fan(plan_.fans[at(layered.number)]);
    } else {
      add_triangle(layered);
    }
  }

 private:
  void add_fan(const FanPiece& piece) {
    ChunkFan& fan = chunk_->fans.emplace_back();
    fan.ends = piece.ends;
    fan.lines = numbers_of(piece);
    for (std::int32_t& line : fan.lines) line = local_line(line);
  }

  void add_triangle(const Layered& triangle) {
    Triangle local{};
    for (std::size_t k = 0; k < 3; ++k) local[k] = local_line(triangle.lines[k]);
    chunk_->triangles.push_back(local);
    chunk_->surface_triangles.push_back(static_cast<std::uint32_t>(triangle.number));
    add_sides(triangle.number, local);
  }

  struct Owned {
    std::uint64_t by = 0;
    std::uint32_t first_node = 0;
  };

  void add_sides(std::int32_t triangle, const Triangle& local) {
    auto side = std::lower_bound(
        plan_.sides.begin(), plan_.sides.end(), triangle,
        [](const LayerSide& a, std::int32_t number) { return a.triangle < number; });
    for (; side != plan_.sides.end() && side->triangle == triangle; ++side) {
      chunk_->sides.push_back(
          {{local[at(side->corner)], local[at((side->corner + 1) % 3)]}, side->patch, side->last});
    }
  }

  std::int32_t local_line(std::int32_t line) {
    std::int32_t& local = local_[at(line)];
    if (local >= 0) return local;
    local = static_cast<std::int32_t>(chunk_->lines.size());
    lines_.push_back(line);
    ChunkLine& added = chunk_->lines.emplace_back();
    added.line = plan_.lines[at(line)];
    added.line.wanted = 0;
    added.line.first_wanted = 0;
    added.line.reason = StopReason::complete;
    added.line.because_of = -1;
    if (added.line.of_pml) chunk_->within_pml = within_pml_;
    Owned& owned = owned_[at(line)];
    if (owned.by == 0) {
      owned = {chunk_->path.heap, next_node_};
      next_node_ += static_cast<std::uint32_t>(inner_points(added.line));
    }
    added.owner = owned.by;
    added.first_node = owned.first_node;
    added.line.end.line = added.line.end.inner_line = added.line.end.inner_vertex = -1;
    added.line.end.level = 0;
    added.top = has_top(plan_.lines[at(line)]) ? tops_[at(line)] : 0;
    return local;
  }

  /// Of a point that no other line is asked for.
  Origin origin_of(std::int32_t number, int level) const {
    const LayerLine& line = plan_.lines[at(number)];
    const std::int32_t vertex = vertex_at(line, level);
    if (vertex >= 0) return {0, static_cast<std::uint32_t>(vertex)};
    if (level == line.stop) {
      TF_CHECK(has_top(line));
      return {top_of_layers, tops_[at(number)]};
    }
    const Owned& owned = owned_[at(number)];
    TF_CHECK(owned.by > 0);
    return {owned.by,
            owned.first_node + static_cast<std::uint32_t>(level - first_inner_level(line))};
  }

  const LayerPlan& plan_;
  std::array<Vec3, 2> within_pml_;
  std::vector<std::uint32_t> tops_;
  std::vector<Owned> owned_;
  std::vector<std::int32_t> local_;  // of each line of the plan, in the chunk
  std::vector<std::int32_t> lines_;  // those of the chunk
  LayerChunk* chunk_ = nullptr;
  std::uint32_t next_node_ = 0;
};

}  // namespace

std::vector<LayerChunk> chunks_of(const LayerPlan& plan, const SurfaceMesh& surface,
                                  std::int64_t most_cells) {
  TF_CHECK(most_cells > 0);
  const std::vector<Layered> triangles = LayeredPlaces(plan, surface).in_order();
  if (triangles.empty()) return {};
  const std::vector<std::size_t> chunk_of = chunk_of_each(triangles, most_cells);
  const ChunkTree tree = chunk_tree(chunk_of.back() + 1);
  std::vector<LayerChunk> chunks(tree.leaves.size());
  ChunkFiller filler(plan);
  const bool meet = std::any_of(plan.lines.begin(), plan.lines.end(),
                                [](const LayerLine& line) { return line.end != LineEnd(); });
  std::vector<std::vector<std::int32_t>> lines_of_chunks;  // where they meet
  for (std::size_t i = 0, t = 0; i < chunks.size(); ++i) {
    chunks[i].path = tree.leaves[i];
    filler.begin(chunks[i]);
    for (; t < triangles.size() && chunk_of[t] == i; ++t) filler.add(triangles[t]);
    if (meet) lines_of_chunks.push_back(filler.lines());
  }
  for (std::size_t i = 0; i < lines_of_chunks.size(); ++i) {
    filler.add_ends(lines_of_chunks[i], chunks[i]);
  }
  return chunks;
}

LayerColumn column_of(const LayerChunk& chunk, const Triangle& triangle) {
  LayerColumn column;
  for (std::size_t k = 0; k < 3; ++k) {
    const LayerLine& line = chunk.lines[at(triangle[k])].line;
    column.stops[k] = line.stop;
    column.early[k] = line.early;
  }
  return column;
}

PieceLines lines_of(const LayerChunk& chunk, const ChunkFan& fan) {
  PieceLines lines{};
  for (std::size_t k = 0; k < lines.size(); ++k) lines[k] = &chunk.lines[at(fan.lines[k])].line;
  return lines;
}

bool is_of_pml(const LayerChunk& chunk, const Triangle& triangle) {
  return std::all_of(triangle.begin(), triangle.end(),
                     [&chunk](std::int32_t line) { return chunk.lines[at(line)].line.of_pml; });
}

bool are_in_tets(const LayerChunk& chunk, std::span<const std::int32_t> lines) {
  return std::all_of(lines.begin(), lines.end(),
                     [&chunk](std::int32_t line) { return chunk.lines[at(line)].line.in_tets; });
}

LineSide side_of(const LayerChunk& chunk, const ChunkSide& side) {
  // The triangle of the wall runs from the first line to the second, its neighbour in the plane
  // back.
  return {chunk.lines[at(side.lines[1])].line, chunk.lines[at(side.lines[0])].line};
}

LineSide side_above(const LayerChunk& chunk, const ChunkFan& fan, std::size_t end) {
  const auto [left, right] = lines_at_end(fan.lines, end);
  return {chunk.lines[at(left)].line, chunk.lines[at(right)].line, 1};
}

namespace {

void count_cells(ElementType type, std::int64_t number, ChunkCounts& counts) {
  counts.prisms += type == ElementType::prism ? number : 0;
  counts.pyramids += type == ElementType::pyramid ? number : 0;
  counts.tets += type == ElementType::tet ? number : 0;
}

/// So many cells of a type, which are divided where they are in tets.
void count_cells_or_tets(ElementType type, std::int64_t number, bool in_tets, ChunkCounts& counts) {
  if (in_tets && type == ElementType::prism) {
    count_cells(ElementType::tet, number * tets_in_prism, counts);
  } else if (in_tets && type == ElementType::pyramid) {
    count_cells(ElementType::tet, number * tets_in_pyramid, counts);
  } else {
    count_cells(type, number, counts);
  }
}

/// Those above a triangle without the first `below` layers.
void count_column(const LayerColumn& column, int below, bool in_tets, ChunkCounts& counts) {
  if (column.early[0] != column.early[1] || column.early[1] != column.early[2]) {
    for (int layer = below + 1; layer <= layers_above(column.stops); ++layer) {
      for (const LayerCell& cell : cells_of_layer(column, layer)) {
        count_cells_or_tets(cell.type, 1, in_tets, counts);
      }
    }
    return;
  }
  // As many lines grow in a layer as have a stop that is not lower.
  std::array<int, 3> stops = column.stops;
  std::sort(stops.begin(), stops.end());
  for (int& stop : stops) stop = std::max(stop, below);
  count_cells_or_tets(ElementType::prism, stops[0] - below, in_tets, counts);
  count_cells_or_tets(ElementType::pyramid, stops[1] - stops[0], in_tets, counts);
  count_cells_or_tets(ElementType::tet, stops[2] - stops[1], in_tets, counts);
}

void count_side(const LineSide& side, ChunkCounts& counts) {
  counts.quads += quads_of(side);
  counts.triangles += std::ssize(triangles_of(side));
}

void count_fan(const LayerChunk& chunk, const ChunkFan& fan, ChunkCounts& counts) {
  const PieceLines lines = lines_of(chunk, fan);
  const bool in_tets = are_in_tets(chunk, fan.lines);
  for (const FanCell& cell : base_cells(lines)) {
    count_cells_or_tets(cell.type, 1, in_tets, counts);
  }
  counts.nodes += has_centre(lines) ? 1 : 0;
  for (std::size_t end = 0; end < fan.ends.size(); ++end) {
    if (fan.ends.at(end).patch < 0) continue;
    ++counts.triangles;
    count_side(side_above(chunk, fan, end), counts);
  }
  for (const auto& [i, j, k] : open_triangles(lines)) {
    count_column(column_of(chunk, {fan.lines[i], fan.lines[j], fan.lines[k]}), 1, in_tets, counts);
  }
}

}  // namespace

std::int64_t nodes_of_lines(const LayerChunk& chunk) {
  std::int64_t nodes = 0;
  for (const ChunkLine& line : chunk.lines) {
    if (line.owner == chunk.path.heap) nodes += inner_points(line.line);
  }
  return nodes;
}

ChunkCounts counts_of(const LayerChunk& chunk) {
  ChunkCounts counts;
  counts.nodes = nodes_of_lines(chunk);
  counts.triangles = std::ssize(chunk.surface_triangles);
  for (const ChunkSide& side : chunk.sides) count_side(side_of(chunk, side), counts);
  for (const Triangle& triangle : chunk.triangles) {
    count_column(column_of(chunk, triangle), 0, are_in_tets(chunk, triangle), counts);
  }
  for (const ChunkFan& fan : chunk.fans) count_fan(chunk, fan, counts);
  return counts;
}

std::string layer_table(const std::vector<LayerChunk>& chunks, std::int64_t top_nodes) {
  const auto cut = [](TreePath path, std::int64_t nodes) {
    return "cut " + std::to_string(path.heap) + ' ' + std::to_string(nodes) + '\n';
  };
  std::string table = cut(TreePath{}, top_nodes);
  for (const TreePath path : chunk_tree(chunks.size()).inner) table += cut(path, 0);
  for (const LayerChunk& chunk : chunks) {
    const ChunkCounts counts = counts_of(chunk);
    table += "leaf " + std::to_string(chunk.path.heap);
    for (const std::int64_t count :
         {counts.nodes, counts.tets, counts.triangles, counts.pyramids, counts.prisms}) {
      table += ' ' + std::to_string(count);
    }
    if (counts.quads > 0) table += ' ' + std::to_string(counts.quads);
    table += '\n';
  }
  return table;
}

}  // namespace tetfarm
