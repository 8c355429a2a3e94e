#include "mesh/library/mesh_surface.h"

#include <set>
#include <utility>

#include "base/error.h"
#include "mesh/core/subdomain_regions.h"
#include "mesh/core/validate.h"
#include "mesh/inspect/defect_text.h"
#include "mesh/library/append_mesh.h"
#include "mesh/library/leaf_mesh.h"

namespace tetfarm {
namespace {

SurfaceMesh meshable(const SurfaceMesh& surface, const MeshSurfaceOptions& options) {
  RegionRules rules = options.regions;
  rules.is_outside_meshed = options.outer.kind != OuterBoundary::Kind::none;
  const CheckedSurface checked = check_surface(surface, rules);
  const std::vector<SurfaceDefect>& defects = checked.report.defects;
  if (defects.empty()) {
    OuterBoundary outer = options.outer;
    outer.default_spacing = options.spacing.background;
    return add_outer_boundary(checked.surface, outer, options.spacing.growth);
  }
  std::set<std::int64_t> triangles;
  for (const SurfaceDefect& defect : defects) {
    triangles.insert(defect.triangles.begin(), defect.triangles.end());
  }
  throw InvalidInput(defects_text(defects), "", {triangles.begin(), triangles.end()});
}

/// The root where it has one region, else its parts as the decomposition tree divides them.
void divide(Subdomain whole, std::vector<Subdomain>& leaves) {
  const std::vector<std::int32_t> regions = regions_of(whole);
  if (regions.size() == 1) {
    leaves.push_back(std::move(whole));
    return;
  }
  const RegionHalves halves = halves_of(regions);
  divide(part_of_regions(whole, halves.left, whole.path.left()), leaves);
  divide(part_of_regions(whole, halves.right, whole.path.right()), leaves);
}

/// What the library's users are told of a leaf that has no mesh.
[[noreturn]] void throw_failure(const VolumeFailure& failure) {
  if (failure.cause == VolumeFailure::Cause::same_place) {
    throw InvalidInput(failure.message, "", {failure.triangles.begin(), failure.triangles.end()});
  }
  throw RecoveryFailure(failure.message, failure.triangles);
}

/// Adds a leaf's mesh to that of all. Its boundary nodes are the surface's own.
void join(const Subdomain& leaf, const TetMesh& mesh, MeshedSurface& all) {
  std::vector<std::int32_t> leaf2all;
  for (const Origin& origin : leaf.node_origin) {
    leaf2all.push_back(static_cast<std::int32_t>(origin.index));
  }
  append_mesh(mesh, std::move(leaf2all), all.nodes, all.tets);
  all.region_of_tet.resize(all.tets.size(), leaf.region);
}

}  // namespace

MeshedSurface mesh_surface(const SurfaceMesh& surface, const MeshSurfaceOptions& options) {
  MeshedSurface all;
  all.surface = meshable(surface, options);
  const SpacingField spacing = make_spacing_field(all.surface, options.spacing);
  CutOptions cutting;
  cutting.progress = options.volume.progress;
  const LeafMeshers meshers = leaf_meshers(spacing, options.volume, std::move(cutting));
  std::vector<Subdomain> leaves;
  divide(root_subdomain(all.surface), leaves);
  all.nodes = all.surface.vertices;
  for (const Subdomain& leaf : leaves) {
    const VolumeOutcome outcome = leaf_mesh(leaf, meshers);
    if (!outcome.mesh) throw_failure(outcome.failure);
    const std::vector<std::string> complaints = validate(*outcome.mesh, leaf.triangles);
    if (!complaints.empty()) {
      throw Error(ExitCode::failed, "the mesh is not valid: " + complaints.front());
    }
    join(leaf, *outcome.mesh, all);
  }
  return all;
}

}  // namespace tetfarm
