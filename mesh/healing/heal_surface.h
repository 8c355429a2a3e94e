/// Mends surfaces that the check refuses, where the damage is small, and removes triangles of next
/// to no height.
///
/// Source: M. Attene, M. Campen and L. Kobbelt, "Polygon mesh repairing: an application
/// perspective" (2013): local repairs, which leave all that is sound as it is, in an order in which
/// none undoes another. The steps: vertex_welding, equal_triangles, flat_triangles, open_seams,
/// hole_filling, crossing_replacement, body_union; then, of what is sound, nearly_flat_triangles.
/// Lengths in the unit of the input.
#pragma once

#include <vector>

#include "mesh/healing/heal_act.h"
#include "mesh/inspect/surface_check.h"

namespace tetfarm {

struct HealOptions {
  double tolerance = 0;  ///< of cracks, short edges, low triangles; 0: a millionth of the diagonal
  double largest_hole = 0;  ///< length of the border of a hole that is filled; 0: a tenth of it
};

struct HealedSurface {
  SurfaceMesh surface;
  std::vector<HealAct> acts;  ///< in the order in which they were done
  CheckedSurface checked;     ///< of the surface; its defects are what could not be mended
};

/// A surface without defects and without nearly flat triangles is left as it is. Deterministic.
/// What crossing triangles are replaced by is no farther off than a thousandth of the diagonal.
/// @throws UsageError for a tolerance or a hole that is no length, and as check_surface does. Cost:
/// a few times that of check_surface.
HealedSurface heal_surface(const SurfaceMesh& surface, const RegionRules& rules,
                           const HealOptions& options);

/// How many acts of a kind there are, and the first few places: "2 holes filled: (0, 1, 2); (…)".
std::vector<std::string> heal_texts(const std::vector<HealAct>& acts);

/// "hole", "flat triangle": as programs are told.
const char* name_of(HealKind kind);

}  // namespace tetfarm
