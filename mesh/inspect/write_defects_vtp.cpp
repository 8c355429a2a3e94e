#include "mesh/inspect/write_defects_vtp.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "base/file_system.h"

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

std::string shortest_text(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  return {buffer, end};
}

std::string data_array(const std::string& attributes, const std::string& values) {
  return "<DataArray " + attributes + " format=\"ascii\">\n" + values + "</DataArray>\n";
}

/// Named so that it cannot hold "--" or "<", which comments and attributes may not.
std::string legend(const std::vector<SurfaceDefect>& defects) {
  std::string text;
  for (std::size_t d = 0; d < defects.size(); ++d) {
    text += "<!-- defect " + std::to_string(d) + ": " + defects[d].kind + " -->\n";
  }
  return text;
}

std::string vtp_text(const SurfaceMesh& surface, const std::vector<DefectTriangle>& cells,
                     const std::vector<SurfaceDefect>& defects) {
  std::string points;
  std::string connectivity;
  std::string offsets;
  std::string defect;
  std::string triangle;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = surface.vertices[static_cast<std::size_t>(cells[c].nodes[i])];
      points += shortest_text(p.x) + " " + shortest_text(p.y) + " " + shortest_text(p.z) + "\n";
      connectivity += std::to_string(3 * c + i) + (i < 2 ? " " : "\n");
    }
    offsets += std::to_string(3 * c + 3) + "\n";
    defect += std::to_string(cells[c].defect) + "\n";
    triangle += std::to_string(cells[c].triangle) + "\n";
  }
  const std::string n = std::to_string(cells.size());
  return "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n" +
         legend(defects) + "<PolyData>\n<Piece NumberOfPoints=\"" +
         std::to_string(3 * cells.size()) +
         "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" + n +
         "\">\n<CellData Scalars=\"defect\">\n" +
         data_array("type=\"Int64\" Name=\"defect\"", defect) +
         data_array("type=\"Int64\" Name=\"triangle\"", triangle) + "</CellData>\n<Points>\n" +
         data_array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", points) +
         "</Points>\n<Polys>\n" + data_array("type=\"Int64\" Name=\"connectivity\"", connectivity) +
         data_array("type=\"Int64\" Name=\"offsets\"", offsets) +
         "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
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
  write_file_atomically(path, vtp_text(surface, cells, defects));
}

}  // namespace tetfarm
