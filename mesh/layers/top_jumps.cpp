#include "mesh/layers/top_jumps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/array_index.h"

namespace tetfarm {
namespace {

constexpr std::uint64_t no_key = std::numeric_limits<std::uint64_t>::max();

/// Of each node that has an origin its key, no_key for those of cuts.
std::vector<std::uint64_t> keys_of(std::span<const Origin> origins) {
  std::vector<std::uint64_t> keys(origins.size(), no_key);
  for (std::size_t i = 0; i < origins.size(); ++i) {
    if (!is_of_cut(origins[i])) keys[i] = top_key(origins[i]);
  }
  return keys;
}

/// nullptr: no prism ends there.
const TopHeight* find(std::array<std::uint64_t, 3> nodes, std::span<const TopHeight> heights) {
  std::sort(nodes.begin(), nodes.end());
  const auto found =
      std::lower_bound(heights.begin(), heights.end(), nodes,
                       [](const TopHeight& height, const auto& key) { return height.nodes < key; });
  return found != heights.end() && found->nodes == nodes ? &*found : nullptr;
}

double height_over(const Vec3& apex, const Vec3& a, const Vec3& b, const Vec3& c) {
  return std::abs(dot(apex - a, normalized(cross(b - a, c - a))));
}

}  // namespace

std::vector<std::uint64_t> firsts_of_top(std::span<const Origin> origins) {
  std::vector<std::uint64_t> firsts;
  for (const Origin& origin : origins) {
    if (origin.owner == top_of_layers) firsts.push_back(top_key(origin));
  }
  std::sort(firsts.begin(), firsts.end());
  return firsts;
}

std::vector<double> top_jumps(const TetMesh& mesh, std::span<const Origin> origins,
                              std::span<const TopHeight> heights) {
  const std::vector<std::uint64_t> keys = keys_of(origins);
  const auto key_of = [&keys](std::int32_t node) {
    return at(node) < keys.size() ? keys[at(node)] : no_key;
  };
  std::vector<double> jumps;
  for (const Tet& tet : mesh.tets) {
    std::array<std::uint64_t, 4> of{};
    std::transform(tet.begin(), tet.end(), of.begin(), key_of);
    if (std::count(of.begin(), of.end(), no_key) > 1) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::array<std::size_t, 3> face = {(k + 1) % 4, (k + 2) % 4, (k + 3) % 4};
      const TopHeight* const below = find({of[face[0]], of[face[1]], of[face[2]]}, heights);
      if (below == nullptr) continue;
      const double height = height_over(mesh.nodes[at(tet[k])], mesh.nodes[at(tet[face[0]])],
                                        mesh.nodes[at(tet[face[1]])], mesh.nodes[at(tet[face[2]])]);
      jumps.push_back(height / below->height);
    }
  }
  return jumps;
}

}  // namespace tetfarm
