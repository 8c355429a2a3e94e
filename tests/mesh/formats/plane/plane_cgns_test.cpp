#include "mesh/formats/plane/plane_cgns.h"

#include <gmock/gmock.h>

#include "base/file_system.h"
#include "mesh/formats/hdf5/hdf5_file.h"
#include "mesh/formats/plane/plane_files.h"
#include "tests/base/temp_folder.h"
#include "tests/mesh/formats/plane/square_ring.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;

class PlaneCgns : public testing::Test {
 protected:
  Hdf5Input written(const PlaneMesh& mesh, const std::string& name = "a.cgns") const {
    const std::filesystem::path file = folder_.path() / name;
    write_plane_mesh(mesh, file);
    return Hdf5Input(file.string());
  }
  template <class Number>
  static std::vector<Number> data(const Hdf5Input& file, const std::string& node) {
    return file.list<Number>("Base/Zone1/" + node + "/ data");
  }

  const TempFolder folder_;
};

TEST_F(PlaneCgns, has_points_triangles_and_their_regions) {
  const Hdf5Input file = written(square_ring());
  EXPECT_THAT(file.list<std::int32_t>("Base/ data"), ElementsAre(2, 2));
  EXPECT_THAT(data<double>(file, "GridCoordinates/CoordinateX"),
              ElementsAre(0, 3, 3, 0, 1, 2, 2, 1));
  EXPECT_THAT(data<double>(file, "GridCoordinates/CoordinateY"),
              ElementsAre(0, 0, 3, 3, 1, 1, 2, 2));
  EXPECT_FALSE(file.has("Base/Zone1/GridCoordinates/CoordinateZ"));
  EXPECT_THAT(data<std::int32_t>(file, "GridElements"), ElementsAre(5, 0)) << "TRI_3";
  EXPECT_THAT(data<std::int64_t>(file, "GridElements/ElementRange"), ElementsAre(1, 8));
  const auto nodes = data<std::int64_t>(file, "GridElements/ElementConnectivity");
  ASSERT_EQ(nodes.size(), 24U);
  EXPECT_THAT(std::vector(nodes.begin(), nodes.begin() + 3), ElementsAre(1, 2, 6));
  EXPECT_THAT(data<std::int32_t>(file, "CellData/Region"), ElementsAre(1, 1, 1, 1, 2, 2, 2, 2));
}

TEST_F(PlaneCgns, has_a_section_of_lines_and_a_condition_for_each_patch_of_the_border) {
  const Hdf5Input file = written(square_ring());
  EXPECT_THAT(data<std::int32_t>(file, "inlet"), ElementsAre(3, 0)) << "BAR_2";
  EXPECT_THAT(data<std::int64_t>(file, "inlet/ElementRange"), ElementsAre(9, 9));
  EXPECT_THAT(data<std::int64_t>(file, "inlet/ElementConnectivity"), ElementsAre(1, 2));
  EXPECT_THAT(data<std::int64_t>(file, "patch_5/ElementRange"), ElementsAre(10, 12));
  EXPECT_THAT(data<std::int64_t>(file, "the_body/ElementRange"), ElementsAre(13, 16));
  EXPECT_TRUE(file.has("Base/Zone1/ZoneBC/the_body/PointRange"));
  EXPECT_TRUE(file.has("Base/the_body"));
  EXPECT_FALSE(file.has("Base/Zone1/patch_11")) << "an edge inside";
}

TEST_F(PlaneCgns, names_no_patch_as_a_node_of_its_own) {
  PlaneMesh mesh = square_ring();
  mesh.patch_names[3] = "GridElements";
  const Hdf5Input file = written(mesh);
  EXPECT_THAT(data<std::int64_t>(file, "GridElements/ElementRange"), ElementsAre(1, 8));
  EXPECT_TRUE(file.has("Base/Zone1/patch_5"));
}

TEST_F(PlaneCgns, is_the_same_to_the_byte_each_time) {
  written(square_ring(), "a.cgns");
  written(square_ring(), "b.cgns");
  EXPECT_EQ(read_file(folder_.path() / "a.cgns"), read_file(folder_.path() / "b.cgns"));
}

}  // namespace
}  // namespace tetfarm
