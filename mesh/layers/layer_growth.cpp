#include "mesh/layers/layer_growth.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/complaints.h"
#include "mesh/layers/layer_cells.h"
#include "mesh/layers/prism_division.h"

namespace tetfarm {
namespace {

Origin origin_of(const ChunkLine& line, int level) {
  const std::int32_t vertex = vertex_at(line.line, level);
  if (vertex >= 0) return {0, static_cast<std::uint32_t>(vertex)};
  if (level == line.line.stop && line.end) return *line.end;
  if (level == line.line.stop) return {top_of_layers, line.top};
  const auto above = static_cast<std::uint32_t>(level - first_inner_level(line.line));
  return {line.owner, line.first_node + above};
}

/// The numbers of a line's nodes: those of level 1 and up follow each other, but for the last.
struct LineNodes {
  std::int32_t foot = 0;
  std::int32_t first = 0;
  int stop = 0;
  std::int32_t last = 0;

  std::int32_t at_level(int level) const {
    if (level == 0) return foot;
    return level == stop ? last : first + level - 1;
  }
};

/// How a node stands to the foot of its line.
struct OnLine {
  std::int32_t foot = 0;  ///< node
  std::int32_t depth = 0;
};

/// Absorbing layers are counted from the inside, where their lines end, or from where that is
/// nearest.
OnLine on_line(const LayerLine& line, const LineNodes& nodes, int level) {
  if (line.end.depth > 0) return {no_foot, std::max(line.end.depth, line.stop - level)};
  if (line.of_pml) return {nodes.at_level(line.stop), line.stop - level};
  return {nodes.foot, level};
}

void add_node(const Vec3& place, const Origin& origin, const OnLine& on, GrownLayers& layers) {
  layers.mesh.nodes.push_back(place);
  layers.subdomain.node_origin.push_back(origin);
  layers.feet.add(on.foot, on.depth);
}

/// Whether lines of the chunk may end on others.
bool lines_may_meet(const LayerChunk& chunk) {
  return std::any_of(chunk.lines.begin(), chunk.lines.end(),
                     [](const ChunkLine& l) { return l.end || l.line.end != LineEnd(); });
}

/// The nodes of lines that may end on others, each once. Ends come after all other nodes, as any of
/// these may be one.
class MeetingNodes {
 public:
  MeetingNodes(const LayerChunk& chunk, GrownLayers& layers) : chunk_(chunk), layers_(layers) {}

  std::vector<LineNodes> add_all() {
    for (const ChunkLine& line : chunk_.lines) add_but_end(line);
    for (std::size_t i = 0; i < chunk_.lines.size(); ++i) nodes_[i].last = add_end(i);
    for (std::size_t i = 0; i < chunk_.lines.size(); ++i) add_feet(i);
    return std::move(nodes_);
  }

 private:
  void add_but_end(const ChunkLine& line) {
    const std::vector<Vec3> points = points_of(line.line);
    const std::int32_t foot = known_or_added(points[0], origin_of(line, 0));  // a fan's is known
    const auto first = static_cast<std::int32_t>(layers_.mesh.nodes.size());
    nodes_.push_back({foot, first, line.line.stop, foot});
    for (int level = 1; level < line.line.stop; ++level)
      add(points[at(level)], origin_of(line, level));
  }

  std::int32_t add_end(std::size_t i) {
    const ChunkLine& line = chunk_.lines[i];
    const int stop = line.line.stop;
    if (stop == 0) return nodes_[i].foot;
    return known_or_added(point_of(line.line, stop), origin_of(line, stop));
  }

  std::int32_t known_or_added(const Vec3& place, const Origin& origin) {
    const auto known = by_origin_.find(origin);
    return known != by_origin_.end() ? known->second : add(place, origin);
  }

  std::int32_t add(const Vec3& place, const Origin& origin) {
    const auto number = static_cast<std::int32_t>(layers_.mesh.nodes.size());
    TF_CHECK(by_origin_.emplace(origin, number).second);
    add_node(place, origin, {no_foot, no_foot}, layers_);
    return number;
  }

  /// A node of several lines is nearest to the same node of the inner side by each of them.
  void add_feet(std::size_t i) {
    const ChunkLine& line = chunk_.lines[i];
    for (int level = 0; level <= line.line.stop; ++level) {
      const std::int32_t node = nodes_[i].at_level(level);
      const OnLine on = on_line(line.line, nodes_[i], level);
      if (layers_.feet.depth[at(node)] != no_foot) continue;
      layers_.feet.foot[at(node)] = on.foot;
      layers_.feet.depth[at(node)] = on.depth;
      if (line.inner) layers_.far_feet.push_back({node, *line.inner});
    }
  }

  const LayerChunk& chunk_;
  GrownLayers& layers_;
  std::vector<LineNodes> nodes_;
  std::map<Origin, std::int32_t> by_origin_;
};

/// Adds the nodes of all lines: a foot, which several may have, with the first of them.
std::vector<LineNodes> add_nodes(const LayerChunk& chunk, GrownLayers& layers) {
  if (lines_may_meet(chunk)) return MeetingNodes(chunk, layers).add_all();
  std::vector<LineNodes> nodes;
  std::map<std::int32_t, std::int32_t> shared;  // node of each foot that fans have
  for (const ChunkFan& fan : chunk.fans) {
    for (const std::int32_t line : fan.lines) shared.emplace(chunk.lines[at(line)].line.foot, -1);
  }
  for (const ChunkLine& line : chunk.lines) {
    auto next = static_cast<std::int32_t>(layers.mesh.nodes.size());
    const auto foot = shared.find(line.line.foot);
    const bool is_there = foot != shared.end() && foot->second >= 0;
    if (foot != shared.end() && !is_there) foot->second = next;
    const std::int32_t first = is_there ? next : next + 1;
    const int stop = line.line.stop;
    nodes.push_back({is_there ? foot->second : next, first, stop, first + stop - 1});
    int level = 0;
    for (const Vec3& point : points_of(line.line)) {
      if (level > 0 || !is_there) {
        add_node(point, origin_of(line, level), on_line(line.line, nodes.back(), level), layers);
      }
      ++level;
    }
  }
  return nodes;
}

/// Adds those in the middle of pieces of fans; of each piece its own, or -1.
std::vector<std::int32_t> add_centres(const LayerChunk& chunk,
                                      const std::vector<LineNodes>& line_nodes,
                                      GrownLayers& layers) {
  std::vector<std::int32_t> centres;
  auto next = static_cast<std::uint32_t>(nodes_of_lines(chunk));
  for (const ChunkFan& fan : chunk.fans) {
    const PieceLines lines = lines_of(chunk, fan);
    centres.push_back(-1);
    if (!has_centre(lines)) continue;
    centres.back() = static_cast<std::int32_t>(layers.mesh.nodes.size());
    add_node(base_points(lines)[fan_centre], {chunk.path.heap, next++},
             {line_nodes[at(fan.lines[0])].foot, 1}, layers);
  }
  return centres;
}

void add_cell(ElementType type, std::span<const std::int32_t> nodes, std::int32_t region,
              GrownLayers& layers) {
  if (type == ElementType::tet) {
    Tet& tet = layers.mesh.tets.emplace_back();
    TF_CHECK(nodes.size() == tet.size());
    std::copy(nodes.begin(), nodes.end(), tet.begin());
    return;
  }
  ElementBlock& block = layers.blocks[type];
  block.nodes.insert(block.nodes.end(), nodes.begin(), nodes.end());
  block.regions.push_back(region);
}

/// The tets that a cell is divided into, by its nodes.
template <class Tets>
void add_tets(const Tets& tets, std::span<const std::int32_t> nodes, GrownLayers& layers) {
  for (const auto& tet : tets) {
    layers.mesh.tets.push_back({nodes[tet[0]], nodes[tet[1]], nodes[tet[2]], nodes[tet[3]]});
  }
}

void check_cell(const std::vector<Vec3>& points, ElementType type,
                std::span<const std::int32_t> nodes, Complaints& complaints) {
  if (complaints.full()) return;
  std::array<Vec3, 6> places;
  for (std::size_t k = 0; k < nodes.size(); ++k) places[k] = points[at(nodes[k])];
  if (is_positive(type, places)) return;
  complaints.add("the " + std::string(element(type).name) + " near " +
                 text_of(points[at(nodes.front())]) + " is flat or turned");
}

/// The marks of cells that come in any order of types.
class Marking {
 public:
  void add(ElementType type, CellMark mark, int value) {
    for (const CellMark each : all_cell_marks) marks_[type][each].push_back(0);
    set(type, mark, value);
  }
  /// Another mark of the cell of that type that was added last.
  void set(ElementType type, CellMark mark, int value) {
    marks_[type][mark].back() = value;
    is_known_[static_cast<std::size_t>(mark)] = true;
  }
  /// Tets first, then the cells of the blocks.
  CellMarks in_order() const {
    CellMarks marks;
    for (const CellMark mark : all_cell_marks) {
      if (!is_known_[static_cast<std::size_t>(mark)]) continue;
      marks[mark] = marks_[ElementType::tet][mark];
      for (const ElementType type : cell_block_types) {
        const std::vector<std::int32_t>& of_type = marks_[type][mark];
        marks[mark].insert(marks[mark].end(), of_type.begin(), of_type.end());
      }
    }
    return marks;
  }

 private:
  ByType<CellMarks> marks_;
  std::array<bool, all_cell_marks.size()> is_known_{};
};

/// Along which the middle of the nodes lies outside of the box (CellMark::pml_axes).
std::int32_t axes_outside(const std::array<Vec3, 2>& box, const std::vector<Vec3>& points,
                          std::span<const std::int32_t> nodes) {
  Vec3 sum;
  for (const std::int32_t node : nodes) sum += points[at(node)];
  const Vec3 middle = sum / static_cast<double>(nodes.size());
  std::int32_t axes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_outside = middle[axis] < box[0][axis] || middle[axis] > box[1][axis];
    axes |= is_outside ? 1 << axis : 0;
  }
  return axes;
}

/// The cell that was added last, which is of that layer, counted from the wall or from the inside.
struct MarkedCell {
  ElementType type;
  bool is_absorbing;
  int number;
};

void mark_cell(const MarkedCell& cell, std::span<const std::int32_t> nodes, const LayerChunk& chunk,
               const std::vector<Vec3>& points, Marking& marking) {
  marking.add(cell.type, cell.is_absorbing ? CellMark::pml_depth : CellMark::layer, cell.number);
  if (!cell.is_absorbing || !chunk.within_pml) return;
  marking.set(cell.type, CellMark::pml_axes, axes_outside(*chunk.within_pml, points, nodes));
}

LineOrder order_of(const LayerChunk& chunk, std::int32_t line) {
  return order_of(chunk.lines[at(line)].line, chunk.lines[at(line)].top);
}

/// Numbers in the order of three lines, which all have layers.
std::array<std::int32_t, 3> ranks_of(const LayerChunk& chunk, const Triangle& lines) {
  std::array<LineOrder, 3> order;
  for (std::size_t k = 0; k < 3; ++k) order[k] = order_of(chunk, lines[k]);
  std::array<std::int32_t, 3> ranks{};
  for (std::size_t k = 0; k < 3; ++k) {
    ranks[k] = static_cast<std::int32_t>(std::count_if(
        order.begin(), order.end(), [&](const LineOrder& other) { return other < order[k]; }));
  }
  return ranks;
}

/// The tets of a cell above a triangle. @param lines of each of its nodes.
void add_in_tets(const LayerChunk& chunk, ElementType type, std::span<const std::int32_t> lines,
                 std::span<const std::int32_t> nodes, GrownLayers& layers) {
  if (type == ElementType::prism) {
    add_tets(tets_of_prism(ranks_of(chunk, {lines[0], lines[1], lines[2]})), nodes, layers);
  } else if (type == ElementType::pyramid) {
    // The base is between the lines of its first corner and its last, which are the lower ones.
    const bool is_first = order_of(chunk, lines[0]) < order_of(chunk, lines[3]);
    add_tets(tets_of_pyramid(is_first ? 0 : 3), nodes, layers);
  } else {
    add_cell(type, nodes, layers.subdomain.region, layers);
  }
}

/// Of a cell of absorbing layers, counted from the wall. Where it is beyond an edge of the inner
/// side, the largest along any axis.
int depth_of(const LayerChunk& chunk, const Triangle& lines, int layer) {
  int depth = chunk.lines[at(lines[0])].line.stop - layer + 1;
  for (const std::int32_t line : lines)
    depth = std::max(depth, chunk.lines[at(line)].line.end.depth);
  return depth;
}

/// One layer above a triangle of the wall.
void add_layer(const LayerChunk& chunk, const Triangle& lines,
               const std::vector<LineNodes>& line_nodes, const LayerCell& cell, GrownLayers& layers,
               Marking& marking) {
  const bool is_absorbing = is_of_pml(chunk, lines);
  const int number = is_absorbing ? depth_of(chunk, lines, cell.layer) : cell.layer;
  std::array<std::int32_t, std::tuple_size_v<decltype(cell.nodes)>> lines_of_nodes{};
  std::array<std::int32_t, std::tuple_size_v<decltype(cell.nodes)>> all_nodes{};
  const std::size_t count = nodes_of(cell.type);
  for (std::size_t k = 0; k < count; ++k) {
    lines_of_nodes[k] = lines[at(cell.nodes[k].corner)];
    all_nodes[k] = line_nodes[at(lines_of_nodes[k])].at_level(cell.nodes[k].level);
  }
  const auto nodes = std::span(all_nodes.data(), count);
  if (are_in_tets(chunk, lines)) {
    const std::size_t before = layers.mesh.tets.size();
    add_in_tets(chunk, cell.type, lines_of_nodes, nodes, layers);
    for (const Tet& tet : std::span(layers.mesh.tets).subspan(before)) {
      mark_cell({ElementType::tet, is_absorbing, number}, tet, chunk, layers.mesh.nodes, marking);
    }
    return;
  }
  add_cell(cell.type, nodes, layers.subdomain.region, layers);
  mark_cell({cell.type, is_absorbing, number}, nodes, chunk, layers.mesh.nodes, marking);
}

/// The first layer of a piece of a fan.
void add_base(const LayerChunk& chunk, const ChunkFan& fan,
              const std::vector<LineNodes>& line_nodes, std::int32_t centre, GrownLayers& layers,
              Marking& marking) {
  std::array<std::int32_t, fan_nodes> numbers{};
  for (std::size_t k = 0; k < fan.lines.size(); ++k) {
    const int level = std::min(chunk.lines[at(fan.lines[k])].line.stop, 1);
    numbers[k] = line_nodes[at(fan.lines[k])].at_level(level);
  }
  numbers[fan_foot_from] = line_nodes[at(fan.lines[0])].foot;
  numbers[fan_foot_to] = line_nodes[at(fan.lines[2])].foot;
  numbers[fan_centre] = centre;
  const auto foot_of = [&](std::uint8_t node) {
    return chunk.lines[at(fan.lines[node == fan_foot_from ? 0 : 2])].line.foot;
  };
  for (const FanCell& cell : base_cells(lines_of(chunk, fan))) {
    std::array<std::int32_t, std::tuple_size_v<decltype(cell.nodes)>> all_nodes{};
    std::transform(cell.nodes.begin(), cell.nodes.end(), all_nodes.begin(),
                   [&numbers](std::uint8_t n) { return numbers[n]; });
    const auto nodes = std::span(all_nodes.data(), nodes_of(cell.type));
    if (cell.type != ElementType::pyramid || !are_in_tets(chunk, fan.lines)) {
      add_cell(cell.type, nodes, layers.subdomain.region, layers);
      marking.add(cell.type, CellMark::layer, 1);
      continue;
    }
    // The first corners of its base are the feet.
    const auto tets = tets_of_pyramid(foot_of(cell.nodes[0]) < foot_of(cell.nodes[1]) ? 0 : 1);
    add_tets(tets, nodes, layers);
    for (std::size_t i = 0; i < tets.size(); ++i) marking.add(ElementType::tet, CellMark::layer, 1);
  }
}

/// The boundary beside the layers, between two lines: normals out of the domain, as the plane has
/// them. @param first the number in the surface of its first triangle.
void add_side(const LineSide& side, const std::array<LineNodes, 2>& line_nodes, std::int32_t patch,
              std::int32_t first, GrownLayers& layers) {
  const auto& [from, to] = line_nodes;
  ElementBlock& block = layers.blocks[ElementType::quad];
  for (int low = side.first_level; low < side.first_level + quads_of(side); ++low) {
    block.nodes.insert(block.nodes.end(), {from.at_level(low), to.at_level(low),
                                           to.at_level(low + 1), from.at_level(low + 1)});
    block.regions.push_back(layers.subdomain.region);
    block.patches.push_back(patch);
  }
  auto number = static_cast<std::uint32_t>(first);
  for (const SideTriangle& triangle : triangles_of(side)) {
    Triangle nodes{};
    std::transform(triangle.begin(), triangle.end(), nodes.begin(), [&](const SideNode& node) {
      return line_nodes.at(at(node.end)).at_level(node.level);
    });
    layers.subdomain.triangles.push_back(nodes);
    layers.subdomain.triangle_origin.push_back({0, number++});
  }
}

void add_ends(const LayerChunk& chunk, const ChunkFan& fan,
              const std::vector<LineNodes>& line_nodes, GrownLayers& layers) {
  for (std::size_t end = 0; end < fan.ends.size(); ++end) {
    const auto [patch, triangle] = fan.ends.at(end);
    if (patch < 0) continue;
    const auto [left, right] = lines_at_end(fan.lines, end);
    const LineNodes& to_left = line_nodes[at(left)];
    const LineNodes& to_right = line_nodes[at(right)];
    layers.subdomain.triangles.push_back({to_left.foot, to_right.at_level(1), to_left.at_level(1)});
    layers.subdomain.triangle_origin.push_back({0, static_cast<std::uint32_t>(triangle)});
    add_side(side_above(chunk, fan, end), {to_left, to_right}, patch, triangle + 1, layers);
  }
}

}  // namespace

GrownLayers grow(const LayerChunk& chunk) {
  GrownLayers layers;
  Marking marking;
  TF_CHECK(chunk.triangles.size() == chunk.surface_triangles.size());
  layers.subdomain.path = chunk.path;
  const std::vector<LineNodes> line_nodes = add_nodes(chunk, layers);
  const std::vector<std::int32_t> centres = add_centres(chunk, line_nodes, layers);
  layers.mesh.boundary_nodes = static_cast<std::int32_t>(layers.mesh.nodes.size());
  layers.subdomain.vertices = layers.mesh.nodes;
  const auto add_column = [&](const Triangle& lines, int from) {
    const LayerColumn column = column_of(chunk, lines);
    for (int layer = from; layer <= layers_above(column.stops); ++layer) {
      for (const LayerCell& cell : cells_of_layer(column, layer)) {
        add_layer(chunk, lines, line_nodes, cell, layers, marking);
      }
    }
  };
  for (std::size_t t = 0; t < chunk.triangles.size(); ++t) {
    Triangle feet = chunk.triangles[t];
    for (std::int32_t& line : feet) line = line_nodes[at(line)].foot;
    layers.subdomain.triangles.push_back(feet);
    layers.subdomain.triangle_origin.push_back({0, chunk.surface_triangles[t]});
    add_column(chunk.triangles[t], 1);
  }
  for (std::size_t i = 0; i < chunk.fans.size(); ++i) {
    const ChunkFan& fan = chunk.fans[i];
    add_base(chunk, fan, line_nodes, centres[i], layers, marking);
    for (const auto& [a, b, c] : open_triangles(lines_of(chunk, fan))) {
      add_column({fan.lines[a], fan.lines[b], fan.lines[c]}, 2);
    }
  }
  for (const ChunkSide& side : chunk.sides) {
    add_side(side_of(chunk, side), {line_nodes[at(side.lines[1])], line_nodes[at(side.lines[0])]},
             side.patch, side.last, layers);
  }
  for (const ChunkFan& fan : chunk.fans) add_ends(chunk, fan, line_nodes, layers);
  layers.marks = marking.in_order();
  return layers;
}

std::vector<std::string> validate(const GrownLayers& layers) {
  Complaints complaints;
  const std::vector<Vec3>& points = layers.mesh.nodes;
  for (const Tet& tet : layers.mesh.tets) {
    check_cell(points, ElementType::tet, tet, complaints);
  }
  for_each_block_cell(layers.blocks,
                      [&](ElementType type, std::span<const std::int32_t> nodes, std::int32_t) {
                        check_cell(points, type, nodes, complaints);
                      });
  return complaints.take();
}

}  // namespace tetfarm
