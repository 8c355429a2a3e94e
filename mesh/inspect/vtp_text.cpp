#include "mesh/inspect/vtp_text.h"

#include <charconv>

#include "base/check.h"

namespace tetfarm {
namespace {

std::string data_array(const std::string& attributes, const std::string& values) {
  return "<DataArray " + attributes + " format=\"ascii\">\n" + values + "</DataArray>\n";
}

}  // namespace

std::string shortest_text(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  return {buffer, end};
}

std::string vtp_text(const VtpTriangles& triangles) {
  TF_CHECK(!triangles.arrays.empty());
  std::string arrays;
  for (const VtpArray& array : triangles.arrays) {
    arrays += data_array("type=\"" + array.type + "\" Name=\"" + array.name + '"', array.values);
  }
  std::string offsets;
  for (std::size_t t = 1; t <= triangles.triangles; ++t) offsets += std::to_string(3 * t) + "\n";
  return "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n" +
         triangles.legend + "<PolyData>\n<Piece NumberOfPoints=\"" +
         std::to_string(triangles.points) +
         "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
         std::to_string(triangles.triangles) + "\">\n<CellData Scalars=\"" +
         triangles.arrays.front().name + "\">\n" + arrays + "</CellData>\n<Points>\n" +
         data_array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"",
                    triangles.coordinates) +
         "</Points>\n<Polys>\n" +
         data_array("type=\"Int64\" Name=\"connectivity\"", triangles.corners) +
         data_array("type=\"Int64\" Name=\"offsets\"", offsets) +
         "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace tetfarm
