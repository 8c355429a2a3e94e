#include "mesh/layers/layer_growth.h"

#include <algorithm>
#include <array>
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
  if (level == line.line.stop) return {top_of_layers, line.top};
  return {line.owner, line.first_node + static_cast<std::uint32_t>(level - 1)};
}

/// Adds the nodes of all lines; the number of each line's foot, which the others follow.
std::vector<std::int32_t> add_nodes(const LayerChunk& chunk, GrownLayers& layers) {
  std::vector<std::int32_t> first;
  for (const ChunkLine& line : chunk.lines) {
    first.push_back(static_cast<std::int32_t>(layers.mesh.nodes.size()));
    int level = 0;
    for (const Vec3& point : points_of(line.line)) {
      layers.mesh.nodes.push_back(point);
      layers.subdomain.node_origin.push_back(origin_of(line, level++));
    }
  }
  layers.mesh.boundary_nodes = static_cast<std::int32_t>(layers.mesh.nodes.size());
  layers.subdomain.vertices = layers.mesh.nodes;
  return first;
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

/// By the numbers of the feet, which neighbours see alike, whatever chunk they are in.
void add_divided_prism(const std::array<std::int32_t, 3>& feet, std::span<const std::int32_t> nodes,
                       GrownLayers& layers) {
  for (const auto& tet : tets_of_prism(feet)) {
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
  void add(ElementType type, CellMark mark, int value, int cells = 1) {
    for (const CellMark each : all_cell_marks) {
      std::vector<std::int32_t>& values = marks_[type][each];
      values.resize(values.size() + static_cast<std::size_t>(cells), each == mark ? value : 0);
    }
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

/// One layer above a triangle of the wall.
void add_layer(const LayerChunk& chunk, const Triangle& lines, const Triangle& feet,
               const LayerCell& cell, GrownLayers& layers, Marking& marking) {
  const bool is_absorbing = is_of_pml(chunk, lines);
  const CellMark mark = is_absorbing ? CellMark::pml_depth : CellMark::layer;
  const int number =
      is_absorbing ? chunk.lines[at(lines[0])].line.stop - cell.layer + 1 : cell.layer;
  std::array<std::int32_t, std::tuple_size_v<decltype(cell.nodes)>> nodes{};
  std::transform(cell.nodes.begin(), cell.nodes.end(), nodes.begin(),
                 [&feet](const CellNode& n) { return feet[at(n.corner)] + n.level; });
  if (cell.type == ElementType::prism && is_in_tets(chunk, lines)) {
    std::array<std::int32_t, 3> surface_feet{};
    for (std::size_t k = 0; k < 3; ++k) {
      surface_feet[k] = chunk.lines[at(lines[at(cell.nodes[k].corner)])].line.foot;
    }
    add_divided_prism(surface_feet, nodes, layers);
    marking.add(ElementType::tet, mark, number, 3);
    return;
  }
  add_cell(cell.type, std::span(nodes.data(), nodes_of(cell.type)), layers.subdomain.region,
           layers);
  marking.add(cell.type, mark, number);
}

/// The boundary beside the layers: normals out of the domain, as the plane has them.
void add_side(const LayerChunk& chunk, const ChunkSide& side,
              const std::vector<std::int32_t>& first, GrownLayers& layers) {
  // The triangle of the wall runs from the first line to the second, its neighbour in the plane
  // back.
  const std::int32_t from = side.lines[1];
  const std::int32_t to = side.lines[0];
  const auto node = [&first](std::int32_t line, int level) { return first[at(line)] + level; };
  const int from_stop = chunk.lines[at(from)].line.stop;
  const int to_stop = chunk.lines[at(to)].line.stop;
  const int quads = std::min(from_stop, to_stop);
  ElementBlock& block = layers.blocks[ElementType::quad];
  for (int level = 0; level < quads; ++level) {
    block.nodes.insert(block.nodes.end(), {node(from, level), node(to, level), node(to, level + 1),
                                           node(from, level + 1)});
    block.regions.push_back(layers.subdomain.region);
    block.patches.push_back(side.patch);
  }
  auto last = static_cast<std::uint32_t>(side.last);
  const auto add_triangle = [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    layers.subdomain.triangles.push_back({a, b, c});
    layers.subdomain.triangle_origin.push_back({0, last++});
  };
  for (int level = quads; level < from_stop; ++level) {
    add_triangle(node(from, level), node(to, quads), node(from, level + 1));
  }
  for (int level = quads; level < to_stop; ++level) {
    add_triangle(node(from, quads), node(to, level), node(to, level + 1));
  }
}

}  // namespace

GrownLayers grow(const LayerChunk& chunk) {
  GrownLayers layers;
  Marking marking;
  TF_CHECK(chunk.triangles.size() == chunk.surface_triangles.size());
  layers.subdomain.path = chunk.path;
  const std::vector<std::int32_t> first = add_nodes(chunk, layers);
  for (std::size_t t = 0; t < chunk.triangles.size(); ++t) {
    const Triangle& lines = chunk.triangles[t];
    std::array<int, 3> stops{};
    Triangle feet{};
    for (std::size_t k = 0; k < 3; ++k) {
      stops[k] = chunk.lines[at(lines[k])].line.stop;
      feet[k] = first[at(lines[k])];
    }
    layers.subdomain.triangles.push_back(feet);
    layers.subdomain.triangle_origin.push_back({0, chunk.surface_triangles[t]});
    for (int layer = 1; layer <= layers_above(stops); ++layer) {
      add_layer(chunk, lines, feet, layer_cell(stops, layer), layers, marking);
    }
  }
  for (const ChunkSide& side : chunk.sides) add_side(chunk, side, first, layers);
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
