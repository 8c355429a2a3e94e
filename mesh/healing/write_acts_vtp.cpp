#include "mesh/healing/write_acts_vtp.h"

#include <utility>

#include "base/file_system.h"
#include "mesh/healing/heal_surface.h"
#include "mesh/inspect/vtp_text.h"

namespace tetfarm {
namespace {

std::string legend_of_kinds() {
  std::string text;
  for (std::size_t k = 0; k < heal_kinds; ++k) {
    text += "<!-- kind " + std::to_string(k) + ": " + name_of(static_cast<HealKind>(k)) + " -->\n";
  }
  return text;
}

void add_corners(const TrianglePoints& points, VtpTriangles& text) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& p = points[i];
    text.coordinates +=
        shortest_text(p.x) + " " + shortest_text(p.y) + " " + shortest_text(p.z) + "\n";
    text.corners += std::to_string(text.points++) + (i < 2 ? " " : "\n");
  }
  ++text.triangles;
}

}  // namespace

void write_acts_vtp(const std::vector<HealAct>& acts, const std::string& path) {
  VtpTriangles text;
  text.legend = legend_of_kinds();
  VtpArray kind{"Int64", "kind", {}};
  VtpArray number{"Int64", "act", {}};
  for (std::size_t a = 0; a < acts.size(); ++a) {
    for (const TrianglePoints& points : acts[a].triangles) {
      add_corners(points, text);
      kind.values += std::to_string(static_cast<int>(acts[a].kind)) + "\n";
      number.values += std::to_string(a) + "\n";
    }
  }
  text.arrays = {std::move(kind), std::move(number)};
  write_file_atomically(path, vtp_text(text));
}

}  // namespace tetfarm
