/// Which layers are to grow from which patches, in the terms of the mesh: what a job's [[layers]]
/// come to.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/core/vec3.h"
#include "mesh/layers/height_law.h"

namespace tetfarm {

/// What gives way where there is no room for all layers; the first height never does but by
/// `scale`.
enum class RoomRule : std::uint8_t {
  ratio,  ///< the growth, then the number of layers
  stop,   ///< the number of layers
  scale,  ///< all heights alike
};

/// So many layers are the most that a line has.
inline constexpr int most_layers = 1000;

struct LayerRequest {
  std::vector<std::int32_t> patches;  ///< of the surface, ascending
  HeightLaw law;
  /// Layers that are wanted; 0: until one is as high as `isotropic_share` of the edges there.
  int count = 0;
  RoomRule room = RoomRule::ratio;
  int step = 1;  ///< by so many layers the lines at the ends of an edge differ at most
  /// Of layers that have to be whole, such as absorbing ones: for each vertex of the surface the
  /// way that its line goes for each unit of height, and no other. Empty: lines go where there is
  /// room, as far as there is.
  std::vector<Vec3> ways;
  bool in_tets = false;  ///< each prism and pyramid is divided into tets; so are those it meets
  /// Of the angle between faces above which convex edges have several lines at a foot; -1: none.
  double fan_cosine = -1;
};

/// The last of the layers is as high as this share of the edges at its foot, where a job does not
/// say how many there shall be.
inline constexpr double isotropic_share = 0.8;

}  // namespace tetfarm
