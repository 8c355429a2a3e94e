#include "mesh/formats/off/write_off.h"

#include "mesh/formats/coordinate_text.h"

namespace tetfarm {

std::string write_off(const SurfaceMesh& surface) {
  std::string text = "OFF\n" + std::to_string(surface.vertices.size()) + " " +
                     std::to_string(surface.triangles.size()) + " 0\n";
  for (const Vec3& p : surface.vertices) append_coordinates(text, p);
  for (const auto& [a, b, c] : surface.triangles) {
    text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
  return text;
}

}  // namespace tetfarm
