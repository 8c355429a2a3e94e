#include "tests/support/cad_surfaces.h"

#include <array>

#include "tests/support/cad_families.h"
#include "tests/support/chance.h"

namespace tetfarm::shapes {
namespace {

/// A rotation times the squared length of a quaternion of small whole numbers (Euler, Rodrigues).
class WholeRotation {
 public:
  explicit WholeRotation(Chance& chance) {
    const int a = chance.pick(1, 3), b = chance.pick(-3, 3), c = chance.pick(-3, 3),
              d = chance.pick(-3, 3);
    rows_ = {
        Vec3{double(a * a + b * b - c * c - d * d), 2.0 * (b * c - a * d), 2.0 * (b * d + a * c)},
        Vec3{2.0 * (b * c + a * d), double(a * a - b * b + c * c - d * d), 2.0 * (c * d - a * b)},
        Vec3{2.0 * (b * d - a * c), 2.0 * (c * d + a * b), double(a * a - b * b - c * c + d * d)}};
  }
  Vec3 operator()(const Vec3& p) const {
    return {dot(rows_[0], p), dot(rows_[1], p), dot(rows_[2], p)};
  }

 private:
  std::array<Vec3, 3> rows_;
};

}  // namespace

std::span<const SurfaceGenerator> cad_surface_generators() {
  static constexpr std::array<SurfaceGenerator, 12> all = {{{"capped_cylinder", capped_cylinder},
                                                            {"fan_node", fan_node},
                                                            {"thread", thread},
                                                            {"perforated_plate", perforated_plate},
                                                            {"lettering", lettering},
                                                            {"gear", gear},
                                                            {"rounded_block", rounded_block},
                                                            {"filleted_bar", filleted_bar},
                                                            {"split_extrusion", split_extrusion},
                                                            {"fine_levels", fine_levels},
                                                            {"merged_voxels", merged_voxels},
                                                            {"box_boolean", box_boolean}}};
  return all;
}

SurfaceMesh moved_exactly(SurfaceMesh surface, std::uint64_t seed) {
  Chance chance(seed);
  const WholeRotation turned(chance);
  int exponent = 0;  // of a power of two above the size
  std::frexp(norm(bounding_box(surface.vertices).size()), &exponent);
  for (Vec3& p : surface.vertices) {
    switch (seed % 6) {
      case 1:
      case 2:
        p = turned(p);
        break;
      case 3:
        p += std::ldexp(1, exponent + 20) * Vec3{1, -1, 1};
        break;
      case 4:
        p *= std::ldexp(1, seed % 12 == 4 ? -50 : 20);
        break;
      case 5:
        p.z *= std::ldexp(1, -12);
        break;
      default:
        break;
    }
  }
  return surface;
}

}  // namespace tetfarm::shapes
