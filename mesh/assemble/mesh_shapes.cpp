#include "mesh/assemble/mesh_shapes.h"

#include <algorithm>

#include "base/array_index.h"
#include "base/check.h"
#include "mesh/assemble/congruent_tets.h"
#include "mesh/core/tet_layers.h"

namespace tetfarm {
std::vector<bool> tets_near_cuts(std::span<const Tet> tets, const std::vector<bool>& is_on_cut) {
  std::vector<bool> result(tets.size(), false);
  if (std::find(is_on_cut.begin(), is_on_cut.end(), true) == is_on_cut.end()) return result;
  const TetBlocks blocks(tets, is_on_cut.size());
  TetLayers layers(blocks);
  for (std::size_t v = 0; v < is_on_cut.size(); ++v) {
    if (is_on_cut[v]) layers.reach(static_cast<std::int32_t>(v));
  }
  for (int layer = 0; layer < layers_near_cuts; ++layer) {
    const std::vector<std::uint32_t> found = layers.next();
    for (const std::uint32_t t : found) result[t] = true;
    layers.reach_nodes_of(found);
  }
  return result;
}

void add_shapes(std::span<const Vec3> nodes, std::span<const Tet> tets, std::int32_t region,
                const std::vector<bool>& is_on_cut, MeshShapes& shapes) {
  const std::vector<bool> is_near = tets_near_cuts(tets, is_on_cut);
  TF_CHECK(region >= 1 && is_on_cut.size() == nodes.size());
  shapes.regions.resize(std::max(shapes.regions.size(), at(region)));
  RegionShapes& here = shapes.regions[at(region - 1)];
  double volume = 0;
  CongruentTets congruent;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    const auto node = [&](std::size_t i) -> const Vec3& { return nodes[at(tets[t][i])]; };
    const TetShape shape = congruent.shape(node(0), node(1), node(2), node(3));
    volume += tet_volume(node(0), node(1), node(2), node(3));
    shapes.all.add(shape);
    here.shapes.add(shape);
    (is_near[t] ? shapes.near_cuts : shapes.away_from_cuts).add(shape);
  }
  here.volume += volume;
}

void add_shapes(const MeshShapes& subdomain, MeshShapes& all) {
  all.all.add(subdomain.all);
  all.near_cuts.add(subdomain.near_cuts);
  all.away_from_cuts.add(subdomain.away_from_cuts);
  all.regions.resize(std::max(all.regions.size(), subdomain.regions.size()));
  for (std::size_t i = 0; i < subdomain.regions.size(); ++i) {
    all.regions[i].volume += subdomain.regions[i].volume;
    all.regions[i].shapes.add(subdomain.regions[i].shapes);
  }
}

}  // namespace tetfarm
