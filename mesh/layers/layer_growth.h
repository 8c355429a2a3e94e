/// Grows a chunk of layers: the prisms, pyramids and tets above its triangles of the wall.
///
/// Source: thesis 4.4, figs. 89 to 97. There layers advance one after the other; here each line's
/// points are known by themselves, so the cells above a triangle are made bottom to top, without a
/// look at others.
#pragma once

#include <string>
#include <vector>

#include "mesh/core/cell_marks.h"
#include "mesh/core/element_block.h"
#include "mesh/core/node_feet.h"
#include "mesh/core/subdomain.h"
#include "mesh/core/tet_mesh.h"
#include "mesh/layers/layer_chunks.h"

namespace tetfarm {

/// Where the foot of a node is, in blocks of absorbing layers beyond an edge of their inner side.
struct FarFoot {
  std::int32_t node = 0;
  Origin foot;

  friend bool operator==(const FarFoot&, const FarFoot&) = default;
};

/// All nodes are vertices of `subdomain`, with their origins: feet are of the surface, tops of
/// top_of_layers, those between of the chunk that owns their line; of lines in planes the last ones
/// are of the surface. Its triangles are those of the wall, then those of sides.
struct GrownLayers {
  Subdomain subdomain;
  TetMesh mesh;
  ElementBlocks blocks;  ///< pyramids, prisms and quads of sides, by the numbers of the nodes
  CellMarks marks;       ///< of each cell its layer, or its depth in a PML and its axes
  /// Of all nodes, by the numbers here. In the middle of a fan it is the foot that the fan is from.
  NodeFeet feet;
  /// Nodes whose foot need not be one of the nodes here: no_foot among `feet`, with their depth.
  std::vector<FarFoot> far_feet;
};

/// Cells come triangle by triangle, each from the wall up. Cost: O(cells).
GrownLayers grow(const LayerChunk& chunk);

/// What is wrong with the cells, a line each, 20 at most: exactly positive has to be each tet of
/// every division of a cell into tets. Empty when all is well. Cost: O(cells).
std::vector<std::string> validate(const GrownLayers& layers);

}  // namespace tetfarm
