#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/check.h"
#include "base/error.h"
#include "mesh/healing/heal_surface.h"
#include "mesh/inspect/surface_check.h"
#include "mesh/remeshing/remesh.h"
#include "tests/fuzz/fuzz_targets.h"

namespace tetfarm::fuzz {
namespace {

constexpr std::size_t most_vertices = 48;
constexpr std::size_t most_triangles = 128;

/// A byte after the other; zeros behind the end.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  bool empty() const { return bytes_.empty(); }
  std::uint8_t next() {
    if (bytes_.empty()) return 0;
    const auto byte = static_cast<std::uint8_t>(bytes_.front());
    bytes_.remove_prefix(1);
    return byte;
  }

 private:
  std::string_view bytes_;
};

/// Multiples of 1/8, so that much is in one plane, on one line or in one place; the fourth byte
/// may move it by a little, as rounding does.
Vec3 vertex_from(Bytes& bytes) {
  const auto coordinate = [&bytes] { return static_cast<std::int8_t>(bytes.next()) / 8.0; };
  Vec3 p;
  for (double* x : {&p.x, &p.y, &p.z}) *x = coordinate();
  const std::uint8_t moved = bytes.next();
  constexpr int least_power = -52;
  if ((moved & 3U) != 0) {
    double& x = (moved & 3U) == 1 ? p.x : (moved & 3U) == 2 ? p.y : p.z;
    x += std::ldexp(1.0, least_power + (moved >> 2U));
  }
  return p;
}

SurfaceMesh surface_from(Bytes& bytes) {
  SurfaceMesh surface;
  const std::size_t vertices = 3 + bytes.next() % (most_vertices - 2);
  for (std::size_t i = 0; i < vertices; ++i) surface.vertices.push_back(vertex_from(bytes));
  while (!bytes.empty() && surface.triangles.size() < most_triangles) {
    Triangle triangle;
    for (std::int32_t& v : triangle) v = static_cast<std::int32_t>(bytes.next() % vertices);
    surface.triangles.push_back(triangle);
  }
  return surface;
}

void check_healed(const HealedSurface& healed, const HealOptions& options) {
  if (!healed.checked.report.defects.empty()) return;
  TF_CHECK(check_surface(healed.surface).report.defects.empty());
  TF_CHECK(heal_surface(healed.surface, {}, options).acts.empty());
}

void check_remeshed(const SurfaceMesh& sound, double parts) {
  RemeshOptions options;
  options.size = norm(bounding_box(sound.vertices).size()) / parts;
  options.min_size = options.size / 4;
  options = with_defaults(options, sound);
  const SurfaceFeatures features = surface_features(sound, options.angle_deg);
  const RemeshingSpacing spacing = remeshing_spacing(sound, features, options);
  SurfaceMesh remeshed = remesh(sound, features, spacing, options).surface;
  remeshed.sides.clear();
  remeshed.region_names.clear();
  TF_CHECK(check_surface(remeshed).report.defects.empty());
}

}  // namespace

void bodies(std::string_view input) {
  Bytes bytes(input);
  const std::uint8_t choice = bytes.next();
  const SurfaceMesh surface = surface_from(bytes);
  HealOptions options;
  if ((choice & 1U) != 0) options.tolerance = 0.01;
  if ((choice & 2U) != 0) options.largest_hole = 100;
  try {
    const HealedSurface healed = heal_surface(surface, {}, options);
    check_healed(healed, options);
    const bool is_sound = healed.checked.report.defects.empty();
    if (is_sound && (choice & 4U) != 0) check_remeshed(healed.checked.surface, 1 + choice / 64);
  } catch (const Error&) {
  }
}

}  // namespace tetfarm::fuzz
