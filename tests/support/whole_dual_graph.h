/// The graph of all tets of a mesh, in memory at once: what a mesh in parts is compared with.
#pragma once

#include "mesh/formats/cell_faces.h"
#include "mesh/formats/mesh_source.h"
#include "mesh/formats/node_records.h"
#include "mesh/partition/dual_graph.h"

namespace tetfarm::test {

/// Tets part after part.
inline WeightedGraph whole_dual_graph(const MeshSource& source) {
  NumberedPart whole;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const NumberedPart part = source.part(i);
    for (Tet tet : part.tets) {
      for (std::int32_t& v : tet) v = static_cast<std::int32_t>(global_node(part, v));
      whole.tets.push_back(tet);
    }
  }
  return dual_graph(cell_faces(whole), whole.tets.size());
}

}  // namespace tetfarm::test
