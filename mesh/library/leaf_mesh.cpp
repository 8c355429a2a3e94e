#include "mesh/library/leaf_mesh.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/check.h"
#include "mesh/library/append_mesh.h"

namespace tetfarm {
namespace {

/// The nodes of the whole by origin, sorted, to find those of a half.
struct NodeOfOrigin {
  Origin origin;
  std::int32_t node = 0;
};

std::vector<NodeOfOrigin> sorted_origins(const Subdomain& whole) {
  std::vector<NodeOfOrigin> nodes;
  for (std::size_t v = 0; v < whole.vertices.size(); ++v) {
    nodes.push_back({whole.node_origin[v], static_cast<std::int32_t>(v)});
  }
  std::sort(nodes.begin(), nodes.end(),
            [](const NodeOfOrigin& a, const NodeOfOrigin& b) { return a.origin < b.origin; });
  return nodes;
}

/// Builds the joined mesh: the whole's nodes, then the cut's in their order, then inner ones.
class Joining {
 public:
  Joining(const Subdomain& whole, const Subdomain& left, const Subdomain& right)
      : cut_(whole.path.heap), whole_(sorted_origins(whole)) {
    mesh_.nodes = whole.vertices;
    mesh_.boundary_nodes = static_cast<std::int32_t>(whole.vertices.size());
    place_cut_nodes(left);
    place_cut_nodes(right);
  }

  void add(const Subdomain& half, const TetMesh& half_mesh) {
    std::vector<std::int32_t> half2whole;
    for (const Origin& origin : half.node_origin) half2whole.push_back(node_of(origin));
    append_mesh(half_mesh, std::move(half2whole), mesh_.nodes, mesh_.tets);
  }

  TetMesh result() && { return std::move(mesh_); }

 private:
  void place_cut_nodes(const Subdomain& half) {
    const auto first = static_cast<std::size_t>(mesh_.boundary_nodes);
    for (std::size_t v = 0; v < half.vertices.size(); ++v) {
      const Origin origin = half.node_origin[v];
      if (origin.owner != cut_) continue;
      mesh_.nodes.resize(std::max(mesh_.nodes.size(), first + origin.index + 1));
      mesh_.nodes[first + origin.index] = half.vertices[v];
    }
  }

  std::int32_t node_of(const Origin& origin) const {
    if (origin.owner == cut_) {
      return mesh_.boundary_nodes + static_cast<std::int32_t>(origin.index);
    }
    const auto found = std::lower_bound(
        whole_.begin(), whole_.end(), origin,
        [](const NodeOfOrigin& node, const Origin& wanted) { return node.origin < wanted; });
    TF_CHECK(found != whole_.end() && found->origin == origin);
    return found->node;
  }

  std::uint64_t cut_;
  std::vector<NodeOfOrigin> whole_;
  TetMesh mesh_;
};

std::optional<TetMesh> mesh_of_halves(const Subdomain& leaf, const LeafMeshers& meshers) {
  const CutOutcome outcome = meshers.cut(leaf);
  if (!outcome.cut) return std::nullopt;
  const VolumeOutcome left = meshers.mesh(outcome.cut->left);
  if (!left.mesh) return std::nullopt;
  const VolumeOutcome right = meshers.mesh(outcome.cut->right);
  if (!right.mesh) return std::nullopt;
  return join_halves(leaf, outcome.cut->left, *left.mesh, outcome.cut->right, *right.mesh);
}

/// Whether a half of a leaf that did not recover as a whole does.
bool boundary_recovers(const Subdomain& half, const SpacingField& spacing) {
  return mesh_volume(half, spacing, {.fill = false, .cosmetics = false}).mesh.has_value();
}

}  // namespace

LeafMeshers leaf_meshers(const SpacingField& spacing, const VolumeMeshOptions& meshing,
                         CutOptions cutting) {
  cutting.accept = [&spacing](const Subdomain& left, const Subdomain& right) {
    return boundary_recovers(left, spacing) && boundary_recovers(right, spacing);
  };
  return {.mesh = [meshing,
                   &spacing](const Subdomain& part) { return mesh_volume(part, spacing, meshing); },
          .cut = [cutting = std::move(cutting),
                  &spacing](const Subdomain& part) { return planar_cut(part, spacing, cutting); }};
}

TetMesh join_halves(const Subdomain& whole, const Subdomain& left, const TetMesh& left_mesh,
                    const Subdomain& right, const TetMesh& right_mesh) {
  Joining joining(whole, left, right);
  joining.add(left, left_mesh);
  joining.add(right, right_mesh);
  return std::move(joining).result();
}

VolumeOutcome leaf_mesh(const Subdomain& leaf, const LeafMeshers& meshers) {
  VolumeOutcome outcome = meshers.mesh(leaf);
  if (!outcome.mesh && outcome.failure.cause == VolumeFailure::Cause::not_recovered) {
    outcome.mesh = mesh_of_halves(leaf, meshers);
  }
  return outcome;
}

}  // namespace tetfarm
