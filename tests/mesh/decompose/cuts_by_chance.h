/// Shapes, spacings and options of cuts by chance from a seed: what is in the way of a cut only now
/// and then comes up among them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "mesh/decompose/planar_cut.h"
#include "tests/support/chance.h"
#include "tests/support/shapes.h"

namespace tetfarm {

enum class ShapeToCut : std::uint8_t { rough_ball, bar, plate_in_box, hollow_ball, stairs, wedges };

inline SurfaceMesh shape_by_chance(ShapeToCut kind, shapes::Chance& chance) {
  // One number at a time: compilers differ in the order of arguments.
  const int n = chance.pick(2, 6);
  const double a = chance.between(0.1, 0.4);
  const double b = chance.between(0.02, 0.2);
  const double c = chance.between(0.5, 0.95);
  SurfaceMesh mesh;
  switch (kind) {
    case ShapeToCut::rough_ball:
      mesh = shapes::sphere({0, 0, 0}, 1, 1 + n / 4);
      for (Vec3& p : mesh.vertices) p *= chance.between(c, 1.1);
      return mesh;
    case ShapeToCut::bar:
      return shapes::box({0, 0, 0}, {1 + 5 * a, 1, c}, n);
    case ShapeToCut::plate_in_box:
      return shapes::between(shapes::box({0, 0, 0}, {1, 1, 1}, n + 2),
                             shapes::box({a, a, c - 0.3}, {1 - a, 1 - a, c - 0.3 + b}, n / 2));
    case ShapeToCut::hollow_ball:
      return shapes::between(shapes::sphere({0, 0, 0}, 1, 1 + n / 4),
                             shapes::sphere({a - 0.25, b, 0.1}, c - 0.4, n % 3));
    case ShapeToCut::stairs:
    case ShapeToCut::wedges:
      mesh = shapes::box({0, 0, 0}, {2, 1, 1}, n);
      for (Vec3& p : mesh.vertices) {
        const double slope = kind == ShapeToCut::wedges ? 1 + p.y : 1;
        if (p.z > 0.6 && p.x > 0.9) p.z += c * slope;
        if (kind == ShapeToCut::wedges) p.x += 0.3 * p.z;
      }
      return mesh;
  }
  return mesh;
}

/// Everything that a cut is made from.
struct CutByChance {
  CutByChance(ShapeToCut kind, std::uint64_t seed) {
    shapes::Chance chance(10 * seed + static_cast<std::uint64_t>(kind));
    surface = shape_by_chance(kind, chance);
    const double background = chance.between(0.1, 0.3);
    const double fine = chance.between(0.04, 0.1);
    SpacingOptions spacings;
    spacings.growth = 0.4;
    spacings.background = seed % 3 == 0 ? 0 : background;
    spacings.inherit_surface = seed % 3 != 1;
    if (seed % 2 == 1) spacings.sources = {{{{{0.4, 0.4, 0.4}, fine, 0.1, 0.5}}}};
    spacing.emplace(seed % 4 == 3 ? SpacingField(background)
                                  : make_spacing_field(surface, spacings));
    const std::array<CutPlanes, 4> planes = {CutPlanes::automatic, CutPlanes::automatic,
                                             CutPlanes::lattice, CutPlanes::axis};
    options.planes = planes[seed % 4];
    options.left_share = seed % 5 == 4 ? 0.3 : 0.5;
  }

  SurfaceMesh surface;
  std::optional<SpacingField> spacing;
  CutOptions options;
};

}  // namespace tetfarm
