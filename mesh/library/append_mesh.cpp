#include "mesh/library/append_mesh.h"

#include "base/check.h"

namespace tetfarm {

void append_mesh(const TetMesh& part, std::vector<std::int32_t> part2all, std::vector<Vec3>& nodes,
                 std::vector<Tet>& tets) {
  TF_CHECK(part2all.size() == static_cast<std::size_t>(part.boundary_nodes));
  part2all.reserve(part.nodes.size());
  for (std::size_t v = part2all.size(); v < part.nodes.size(); ++v) {
    part2all.push_back(static_cast<std::int32_t>(nodes.size()));
    nodes.push_back(part.nodes[v]);
  }
  for (Tet tet : part.tets) {
    for (std::int32_t& v : tet) v = part2all[static_cast<std::size_t>(v)];
    tets.push_back(tet);
  }
}

}  // namespace tetfarm
