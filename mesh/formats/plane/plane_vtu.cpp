#include "mesh/formats/plane/plane_vtu.h"

#include <string>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "base/file_system.h"
#include "mesh/formats/plane/text_lines.h"

namespace tetfarm {
namespace {

constexpr int vtk_line = 3;
constexpr int vtk_triangle = 5;
constexpr std::int32_t none = -1;

/// An array of as many numbers a line as it has components; `put` appends those of a line.
template <class List, class Put>
void write_array(TextLines& lines, std::string_view type, const std::string& name, int components,
                 const List& list, const Put& put) {
  lines.words("<DataArray type=\"").words(type).words("\" Name=\"").words(name);
  lines.words("\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"ascii\">\n");
  for (const auto& value : list) {
    put(value);
    lines.end();
  }
  lines.words("</DataArray>\n");
}

void write_points(TextLines& lines, const PlaneMesh& mesh) {
  lines.words("<Points>\n");
  write_array(lines, "Float64", "Points", 3, mesh.points,
              [&](const Vec2& p) { lines.number(p.x).number(p.y).number(0); });
  lines.words("</Points>\n");
}

void write_cells(TextLines& lines, const PlaneMesh& mesh) {
  std::vector<std::size_t> ends;
  std::vector<int> types;
  for (std::size_t t = 1; t <= mesh.triangles.size(); ++t) {
    ends.push_back(3 * t);
    types.push_back(vtk_triangle);
  }
  for (std::size_t k = 1; k <= mesh.edges.size(); ++k) {
    ends.push_back(3 * mesh.triangles.size() + 2 * k);
    types.push_back(vtk_line);
  }
  lines.words("<Cells>\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">\n");
  const auto put_nodes = [&](const auto& cells) {
    for (const auto& cell : cells) {
      for (const std::int32_t v : cell) lines.number(v);
      lines.end();
    }
  };
  put_nodes(mesh.triangles);
  put_nodes(mesh.edges);
  lines.words("</DataArray>\n");
  const auto put = [&](auto value) { lines.number(value); };
  write_array(lines, "Int64", "offsets", 1, ends, put);
  write_array(lines, "UInt8", "types", 1, types, put);
  lines.words("</Cells>\n");
}

void write_cell_data(TextLines& lines, const PlaneMesh& mesh) {
  std::vector<std::int32_t> regions = mesh.regions;
  regions.resize(mesh.triangles.size() + mesh.edges.size(), none);
  std::vector<std::int32_t> patches(mesh.triangles.size(), none);
  patches.insert(patches.end(), mesh.patches.begin(), mesh.patches.end());
  lines.words("<CellData>\n");
  const auto put = [&](std::int32_t value) { lines.number(value); };
  write_array(lines, "Int32", "region", 1, regions, put);
  write_array(lines, "Int32", "patch", 1, patches, put);
  lines.words("</CellData>\n");
}

void write_point_data(TextLines& lines, const NodeFields& fields) {
  const auto name = [](const char* kind, std::size_t k) {
    return kind + ("_" + std::to_string(k + 1));
  };
  lines.words("<PointData>\n");
  for (std::size_t k = 0; k < fields.scalars.size(); ++k) {
    write_array(lines, "Float64", name("number", k), 1, fields.scalars[k],
                [&](double value) { lines.number(value); });
  }
  for (std::size_t k = 0; k < fields.vectors.size(); ++k) {
    write_array(lines, "Float64", name("vector", k), 3, fields.vectors[k],
                [&](const Vec2& v) { lines.number(v.x).number(v.y).number(0); });
  }
  for (std::size_t k = 0; k < fields.metrics.size(); ++k) {
    write_array(lines, "Float64", name("metric", k), 6, fields.metrics[k], [&](const Metric2& m) {
      lines.number(m.xx).number(m.yy).number(1).number(m.xy).number(0).number(0);
    });
  }
  lines.words("</PointData>\n");
}

void check_fields(const PlaneMesh& mesh, const NodeFields& fields) {
  const auto check = [&](const auto& lists) {
    for (const auto& list : lists) TF_CHECK(list.size() == mesh.points.size());
  };
  check(fields.scalars);
  check(fields.vectors);
  check(fields.metrics);
}

}  // namespace

void write_plane_vtu(const PlaneMesh& mesh, const NodeFields& fields,
                     const std::filesystem::path& path) {
  TF_CHECK(mesh.patches.size() == mesh.edges.size());
  TF_CHECK(mesh.regions.size() == mesh.triangles.size());
  check_fields(mesh, fields);
  TextLines lines(60 * mesh.points.size() + 50 * mesh.triangles.size() + 1000);
  lines.words(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"");
  lines.words(std::to_string(mesh.points.size()) + "\" NumberOfCells=\"" +
              std::to_string(mesh.triangles.size() + mesh.edges.size()) + "\">\n");
  write_points(lines, mesh);
  write_cells(lines, mesh);
  write_cell_data(lines, mesh);
  write_point_data(lines, fields);
  lines.words("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
  write_file_atomically(path, lines.text());
}

}  // namespace tetfarm
