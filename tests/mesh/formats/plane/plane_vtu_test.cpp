#include "mesh/formats/plane/plane_vtu.h"

#include <gmock/gmock.h>

#include "base/file_system.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

/// One triangle with an edge, and a field of each kind.
class PlaneVtu : public ::testing::Test {
 protected:
  PlaneVtu() {
    mesh_.points = {{0, 0}, {1, 0}, {0.25, 1.5}};
    mesh_.triangles = {{0, 1, 2}};
    mesh_.regions = {4};
    mesh_.edges = {{2, 0}};
    mesh_.patches = {7};
  }
  std::string written(const NodeFields& fields) const {
    const TempFolder folder;
    write_plane_vtu(mesh_, fields, folder.path() / "a.vtu");
    return read_file(folder.path() / "a.vtu");
  }
  static std::string array(const std::string& type, const std::string& name, int components,
                           const std::string& numbers) {
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           std::to_string(components) + "\" format=\"ascii\">\n" + numbers + "</DataArray>\n";
  }

  PlaneMesh mesh_;
};

TEST_F(PlaneVtu, has_triangles_and_behind_them_lines) {
  const std::string text = written({});
  EXPECT_THAT(text, HasSubstr("NumberOfPoints=\"3\" NumberOfCells=\"2\""));
  EXPECT_THAT(text, HasSubstr(array("Float64", "Points", 3, "0 0 0\n1 0 0\n0.25 1.5 0\n")));
  EXPECT_THAT(text, HasSubstr("format=\"ascii\">\n0 1 2\n2 0\n</DataArray>"));
  EXPECT_THAT(text, HasSubstr(array("Int64", "offsets", 1, "3\n5\n")));
  EXPECT_THAT(text, HasSubstr(array("UInt8", "types", 1, "5\n3\n")));
  EXPECT_THAT(text, HasSubstr(array("Int32", "region", 1, "4\n-1\n")));
  EXPECT_THAT(text, HasSubstr(array("Int32", "patch", 1, "-1\n7\n")));
}

TEST_F(PlaneVtu, has_the_fields_at_the_points) {
  NodeFields fields;
  fields.scalars = {{1, 2, 3}, {0.1, 4, 5}};
  fields.vectors = {{{1, 2}, {3, 4}, {5, 6}}};
  fields.metrics = {{{1, 0.5, 2}, {3, 0, 4}, {5, 0, 6}}};
  const std::string text = written(fields);
  EXPECT_THAT(text, HasSubstr(array("Float64", "number_1", 1, "1\n2\n3\n")));
  EXPECT_THAT(text, HasSubstr(array("Float64", "number_2", 1, "0.1\n4\n5\n")));
  EXPECT_THAT(text, HasSubstr(array("Float64", "vector_1", 3, "1 2 0\n3 4 0\n5 6 0\n")));
  EXPECT_THAT(text, HasSubstr(array("Float64", "metric_1", 6,
                                    "1 2 1 0.5 0 0\n3 4 1 0 0 0\n5 6 1 0 0 0\n")));
}

}  // namespace
}  // namespace tetfarm
