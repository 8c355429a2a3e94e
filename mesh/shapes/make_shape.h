/// The shapes by name, as `tetfarm shape` makes them: closed surfaces at any spacing, for tests,
/// trials and benchmarks.
///
/// Only + - * / and sqrt make the coordinates: the same bits on every machine.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/core/surface_mesh.h"

namespace tetfarm {

/// "sphere-in-sphere", "sphere-in-box", "corner-reflector", "duct", "s-duct", "trihedral", "wing".
std::vector<std::string> shape_names();

struct ShapeOptions {
  double spacing = 0.1;  ///< edge length; of "wing": on the wing
  double growth = 0.2;   ///< of "wing": of the edge length per unit of length
};

/// A closed surface whose normals point out of the domain, with named patches.
/// @throws UsageError for an unknown name or a number that makes no sense.
SurfaceMesh make_shape(std::string_view name, const ShapeOptions& options = {});

}  // namespace tetfarm
