#include "mesh/inspect/write_defects_vtp.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <filesystem>
#include <limits>

#include "base/error.h"
#include "base/file_system.h"
#include "mesh/inspect/surface_check.h"
#include "tests/mesh/inspect/check_support.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

class WriteDefectsVtp : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "tetfarm_vtp_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string written(const SurfaceMesh& mesh) {
    const auto path = folder_ / "defects.vtp";
    write_defects_vtp(mesh, check_surface(mesh).report.defects, path.string());
    return read_file(path);
  }

  std::filesystem::path folder_;
};

TEST_F(WriteDefectsVtp, gives_each_triangle_its_defect_and_number) {
  SurfaceMesh mesh = shapes::tetrahedron();
  mesh.triangles.push_back(mesh.triangles[2]);
  const std::string text = written(mesh);
  EXPECT_THAT(text, HasSubstr("NumberOfPoints=\"6\""));
  EXPECT_THAT(text, HasSubstr("NumberOfPolys=\"2\""));
  EXPECT_THAT(text, HasSubstr("<!-- defect 0: duplicate triangle -->"));
  EXPECT_THAT(text, HasSubstr("Name=\"defect\" format=\"ascii\">\n0\n0\n</DataArray>"));
  EXPECT_THAT(text, HasSubstr("Name=\"triangle\" format=\"ascii\">\n2\n4\n</DataArray>"));
}

TEST_F(WriteDefectsVtp, is_well_formed_with_every_kind_of_defect) {
  SurfaceMesh mesh = joined(shapes::unit_cube(), shapes::box({0.5, 0.5, 0.5}, {2, 2, 2}, 1));
  mesh.vertices[0].x = std::numeric_limits<double>::quiet_NaN();
  mesh.triangles[3][0] = 99;
  mesh.triangles.push_back(mesh.triangles[20]);
  mesh.triangles.push_back({3, 3, 4});
  written(mesh);
  const std::string command =
      "python3 -c \"import sys, xml.etree.ElementTree as e; r = e.parse(sys.argv[1]).getroot(); "
      "p = r.find('PolyData/Piece'); n = int(p.get('NumberOfPolys')); "
      "a = {d.get('Name'): d.text.split() for d in p.iter('DataArray')}; "
      "assert n > 3 and len(a['defect']) == len(a['triangle']) == len(a['offsets']) == n; "
      "assert len(a['connectivity']) == 3 * n and len(a['Points']) == 9 * n; "
      "[float(x) for x in a['Points']]; assert 'nan' not in a['Points']\" '" +
      (folder_ / "defects.vtp").string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
}

TEST_F(WriteDefectsVtp, writes_an_empty_piece_when_nothing_is_wrong) {
  EXPECT_THAT(written(shapes::unit_cube()), HasSubstr("NumberOfPolys=\"0\""));
}

TEST_F(WriteDefectsVtp, fails_where_there_is_no_folder) {
  EXPECT_THROW(write_defects_vtp({}, {}, (folder_ / "none" / "x.vtp").string()), IoError);
}

}  // namespace
}  // namespace tetfarm
