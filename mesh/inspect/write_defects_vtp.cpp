#include "mesh/inspect/write_defects_vtp.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/file_system.h"
#include "mesh/inspect/vtp_text.h"

namespace tetfarm {
namespace {

struct DefectTriangle {
  Triangle nodes{};
  std::int64_t triangle = 0;
  std::size_t defect = 0;
};

bool can_be_drawn(const SurfaceMesh& surface, const Triangle& nodes) {
  return std::ranges::all_of(nodes, [&surface](std::int32_t v) {
    if (v < 0 || static_cast<std::size_t>(v) >= surface.vertices.size()) return false;
    const Vec3& p = surface.vertices[static_cast<std::size_t>(v)];
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

/// Named so that it cannot hold "--" or "<", which comments and attributes may not.
std::string legend(const std::vector<SurfaceDefect>& defects) {
  std::string text;
  for (std::size_t d = 0; d < defects.size(); ++d) {
    text += "<!-- defect " + std::to_string(d) + ": " + defects[d].kind + " -->\n";
  }
  return text;
}

std::string text_of_defects(const SurfaceMesh& surface, const std::vector<DefectTriangle>& cells,
                            const std::vector<SurfaceDefect>& defects) {
  VtpTriangles text;
  text.legend = legend(defects);
  text.points = 3 * cells.size();
  text.triangles = cells.size();
  VtpArray defect{"Int64", "defect", {}};
  VtpArray triangle{"Int64", "triangle", {}};
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = surface.vertices[static_cast<std::size_t>(cells[c].nodes[i])];
      text.coordinates +=
          shortest_text(p.x) + " " + shortest_text(p.y) + " " + shortest_text(p.z) + "\n";
      text.corners += std::to_string(3 * c + i) + (i < 2 ? " " : "\n");
    }
    defect.values += std::to_string(cells[c].defect) + "\n";
    triangle.values += std::to_string(cells[c].triangle) + "\n";
  }
  text.arrays = {std::move(defect), std::move(triangle)};
  return vtp_text(text);
}

}  // namespace

void write_defects_vtp(const SurfaceMesh& surface, const std::vector<SurfaceDefect>& defects,
                       const std::string& path) {
  std::vector<DefectTriangle> cells;
  for (std::size_t d = 0; d < defects.size(); ++d) {
    for (const std::int64_t t : defects[d].triangles) {
      const Triangle& nodes = surface.triangles[static_cast<std::size_t>(t)];
      if (can_be_drawn(surface, nodes)) cells.push_back({nodes, t, d});
    }
  }
  write_file_atomically(path, text_of_defects(surface, cells, defects));
}

}  // namespace tetfarm
