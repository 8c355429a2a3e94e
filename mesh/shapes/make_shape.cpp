#include "mesh/shapes/make_shape.h"

#include "base/error.h"
#include "mesh/shapes/bent_duct.h"
#include "mesh/shapes/corner_reflector.h"
#include "mesh/shapes/nested_shapes.h"
#include "mesh/shapes/s_duct.h"
#include "mesh/shapes/swept_wing.h"
#include "mesh/shapes/trihedral_cavity.h"

namespace tetfarm {

std::vector<std::string> shape_names() {
  return {"sphere-in-sphere", "sphere-in-box", "corner-reflector", "duct", "s-duct",
          "trihedral",        "wing"};
}

SurfaceMesh make_shape(std::string_view name, const ShapeOptions& options) {
  if (name == "sphere-in-sphere") return sphere_in_sphere(options.spacing);
  if (name == "sphere-in-box") return sphere_in_box(options.spacing);
  if (name == "corner-reflector") return corner_reflector(options.spacing);
  if (name == "duct") return bent_duct(options.spacing);
  if (name == "s-duct") return s_duct(options.spacing);
  if (name == "trihedral") return trihedral_cavity(options.spacing);
  if (name == "wing") return swept_wing(options.spacing, options.growth);
  throw UsageError("unknown shape", std::string(name));
}

}  // namespace tetfarm
