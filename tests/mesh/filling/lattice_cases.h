/// Lattices that the tests of the lattice's core share.
#pragma once

#include <algorithm>

#include "mesh/core/subdomain.h"
#include "mesh/spacing/spacing_field.h"
#include "tests/support/shapes.h"

namespace tetfarm::lattice_cases {

inline Box3 box() {
  Box3 box;
  box.add(Vec3{-1, -1, -1});
  box.add(Vec3{1, 1, 1});
  return box;
}

inline SpacingField uniform() { return SpacingField(0.15); }
inline SpacingField fine() { return SpacingField(0.09); }

/// Fine at one corner of the box, coarse at the other.
inline SpacingField graded() {
  SpacingOptions options;
  options.background = 0.25;
  options.growth = 0.15;
  options.inherit_surface = false;
  options.sources = {{{{{-0.9, -0.9, -0.9}, 0.06, 0.1, 0.8}}}};
  return make_spacing_field(shapes::sphere({0, 0, 0}, 1.8, 2), options);
}

}  // namespace tetfarm::lattice_cases
