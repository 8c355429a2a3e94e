#include "mesh/remeshing/triangle_samples.h"

#include <cmath>

#include "mesh/remeshing/triangle_normal.h"

namespace tetfarm {

double sample_step(const SurfaceMesh& surface, double points) {
  double area = 0;
  for (const Triangle& t : surface.triangles) {
    const TrianglePoints c = triangle_points(surface.vertices, t);
    area += 0.5 * norm(doubled_area(c));
  }
  return std::sqrt(area / points);
}

}  // namespace tetfarm
