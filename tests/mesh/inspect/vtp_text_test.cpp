#include "mesh/inspect/vtp_text.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

TEST(VtpText, has_points_triangles_and_their_numbers_in_this_order) {
  VtpTriangles triangles;
  triangles.legend = "<!-- what it is -->\n";
  triangles.points = 3;
  triangles.coordinates = "0 0 0\n1 0 0\n0 1 0\n";
  triangles.triangles = 1;
  triangles.corners = "0 1 2\n";
  triangles.arrays = {{"Int64", "layers", "7\n"}, {"Float64", "height", "0.5\n"}};
  EXPECT_EQ(vtp_text(triangles),
            "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
            "header_type=\"UInt64\">\n<!-- what it is -->\n<PolyData>\n"
            "<Piece NumberOfPoints=\"3\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
            "NumberOfStrips=\"0\" NumberOfPolys=\"1\">\n<CellData Scalars=\"layers\">\n"
            "<DataArray type=\"Int64\" Name=\"layers\" format=\"ascii\">\n7\n</DataArray>\n"
            "<DataArray type=\"Float64\" Name=\"height\" format=\"ascii\">\n0.5\n</DataArray>\n"
            "</CellData>\n<Points>\n<DataArray type=\"Float64\" Name=\"Points\" "
            "NumberOfComponents=\"3\" format=\"ascii\">\n0 0 0\n1 0 0\n0 1 0\n</DataArray>\n"
            "</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" "
            "format=\"ascii\">\n0 1 2\n</DataArray>\n<DataArray type=\"Int64\" "
            "Name=\"offsets\" format=\"ascii\">\n3\n</DataArray>\n</Polys>\n</Piece>\n"
            "</PolyData>\n</VTKFile>\n");
}

TEST(VtpText, numbers_are_the_shortest_that_read_back) {
  EXPECT_EQ(shortest_text(0.1), "0.1");
  EXPECT_EQ(shortest_text(1e300), "1e+300");
  EXPECT_EQ(shortest_text(2), "2");
}

}  // namespace
}  // namespace tetfarm
