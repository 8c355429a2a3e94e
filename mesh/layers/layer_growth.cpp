#include "mesh/layers/layer_growth.h"

#include <algorithm>
#include <array>
#include <span>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/core/complaints.h"
#include "mesh/layers/layer_cells.h"

namespace tetfarm {
namespace {

Origin origin_of(const ChunkLine& line, int level) {
  if (level == 0) return {0, static_cast<std::uint32_t>(line.line.foot)};
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

void check_cell(const std::vector<Vec3>& points, ElementType type,
                std::span<const std::int32_t> nodes, Complaints& complaints) {
  if (complaints.full()) return;
  std::array<Vec3, 6> places;
  for (std::size_t k = 0; k < nodes.size(); ++k) places[k] = points[at(nodes[k])];
  if (is_positive(type, places)) return;
  complaints.add("the " + std::string(element(type).name) + " near " +
                 text_of(points[at(nodes.front())]) + " is flat or turned");
}

/// Marks are told of tets first, then of the blocks' cells.
std::vector<std::int32_t> in_order_of_cells(const ByType<std::vector<std::int32_t>>& of_type) {
  std::vector<std::int32_t> marks = of_type[ElementType::tet];
  for (const ElementType type : cell_block_types) {
    marks.insert(marks.end(), of_type[type].begin(), of_type[type].end());
  }
  return marks;
}

}  // namespace

GrownLayers grow(const LayerChunk& chunk) {
  GrownLayers layers;
  ByType<std::vector<std::int32_t>> layer_of_cells;
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
      const LayerCell cell = layer_cell(stops, layer);
      std::array<std::int32_t, std::tuple_size_v<decltype(cell.nodes)>> nodes{};
      std::transform(cell.nodes.begin(), cell.nodes.end(), nodes.begin(),
                     [&feet](const CellNode& n) { return feet[at(n.corner)] + n.level; });
      add_cell(cell.type, std::span(nodes.data(), nodes_of(cell.type)), layers.subdomain.region,
               layers);
      layer_of_cells[cell.type].push_back(layer);
    }
  }
  layers.marks[CellMark::layer] = in_order_of_cells(layer_of_cells);
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
