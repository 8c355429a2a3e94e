/// Raises the smallest heights of the mesh by moving nodes, once its angles are as wanted.
///
/// Source: thesis 4.3.4.1.3 (table 1) judges cosmetics across cuts by the smallest height, to which
/// an explicit solver's time step is proportional. The measure of all other cosmetics looks at
/// shapes only: a tet of good angles between nodes that lie too near to each other is good to it.
/// Heights are counted in spacings, so that fine and coarse places are treated alike.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

#include "mesh/cosmetics/cavity.h"

namespace tetfarm::cosmetics {

struct HeightOptions {
  /// Tets whose smallest height is below this many spacings, or below this length, are worked on.
  double wanted_spacings = 0;
  double wanted_length = 0;
  /// No quality falls below this, or below the smallest that was round the node.
  double floor = 0;
  /// After so many tets that cannot be raised nothing more is tried: all others are higher than
  /// they, and the smallest height of the mesh is what it is.
  std::int64_t most_stuck = std::numeric_limits<std::int64_t>::max();
  /// The lowest tets that no node can raise by itself are tried by moving neighbours together and
  /// by reconnection, until so many of them could not be raised by that either. 0: none is.
  std::int64_t most_joint_failures = 0;
  /// Before such a tet counts as a failure, height is bought with angle where the smallest quality
  /// round a node is below this: a share of the height for at most a third of it of the smallest
  /// angle. 0: none is.
  double traded_quality = 0;
  /// Target edge length at a point; asked for only where spacings are wanted.
  std::function<double(const Vec3&)> spacing;
  /// Whether a tet is known to be high enough as long as no tet of its nodes has changed; may be
  /// empty.
  std::function<bool(std::int32_t)> is_high_at_first;

  bool wants_any() const { return wanted_spacings > 0 || wanted_length > 0; }
};

/// The square of the smallest height of a tet; 0 for a flat or inverted one. Cost: 60 flops.
double smallest_height2(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Lowest tets first; nodes move only where the lowest tet round them becomes higher, the square of
/// its height by 3 % at least. The number of changes. Deterministic. Cost: 20 flops and a spacing a
/// tet, some 30 µs for each low one, and up to 5 ms for each that neighbours are moved for.
std::int64_t improve_altitudes(WorkMesh& work, const HeightOptions& options);

}  // namespace tetfarm::cosmetics
