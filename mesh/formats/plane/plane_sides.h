/// The sides of the triangles of a plane mesh, and the patches that those of its border are on:
/// what formats need that list faces, or a marker for each patch.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/planar/plane_mesh.h"

namespace tetfarm {

/// Of two triangles, from `a` to `b` with the first of them, by number, on its left.
struct InnerSide {
  std::int32_t a = 0, b = 0;
  std::int32_t triangle = 0, neighbour = 0;  ///< triangle < neighbour
};

/// Of one triangle, which is on its left.
struct OuterSide {
  std::int32_t a = 0, b = 0;
  std::int32_t triangle = 0;
  std::int32_t patch = 0;  ///< the number that the mesh gives this edge; 0 without one
};

/// Inner sides by triangle and neighbour, those of the border by patch, triangle and place in it.
struct PlaneSides {
  std::vector<InnerSide> inner;
  std::vector<OuterSide> border;
};
/// @throws InvalidInput when more than two triangles have a side. Cost: O(n log n).
PlaneSides sides_of(const PlaneMesh& mesh);

struct PlanePatch {
  std::int32_t number = 0;
  std::string name;  ///< plain (plain_names.h), and no two have the same
};
/// The patches of the border, by number. One that the mesh does not name is "patch_NUMBER".
std::vector<PlanePatch> border_patches(const PlaneMesh& mesh, const PlaneSides& sides);

/// The name that the mesh gives the patch, or "patch_NUMBER".
std::string patch_name_of(const PlaneMesh& mesh, std::int32_t number);

/// Whether all sides of a patch bound holes of the domain, and none its outer border: of each of
/// border_patches(). What a flow goes round, rather than where it comes in.
std::vector<bool> bound_holes(const PlaneMesh& mesh, const PlaneSides& sides,
                              const std::vector<PlanePatch>& patches);

}  // namespace tetfarm
