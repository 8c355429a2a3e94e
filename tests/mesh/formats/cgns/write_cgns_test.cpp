#include "mesh/formats/cgns/write_cgns.h"

#include <gmock/gmock.h>

#include "mesh/formats/hdf5/hdf5_file.h"
#include "mesh/formats/registry/open_mesh.h"
#include "tests/mesh/formats/read_back.h"

namespace tetfarm {
namespace {

std::vector<std::int64_t> larges(const Hdf5Input& file, const std::string& node) {
  return file.list<std::int64_t>("Base/Zone1/" + node + "/ data");
}

TEST(WriteCgns, has_the_same_mesh) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  const Hdf5Input file(export_as(grid, folder, "", "a.cgns").string());
  const auto coordinate = [&](const char* name) {
    return file.list<double>("Base/Zone1/GridCoordinates/" + std::string(name) + "/ data");
  };
  ReadMesh mesh(1);
  const auto x = coordinate("CoordinateX");
  const auto y = coordinate("CoordinateY");
  const auto z = coordinate("CoordinateZ");
  ASSERT_EQ(x.size(), 125u);
  for (std::size_t i = 0; i < x.size(); ++i) mesh.node({x[i], y[i], z[i]});
  const auto tets = larges(file, "GridElements/ElementConnectivity");
  for (std::size_t i = 0; i < tets.size(); i += 4) {
    mesh.tet({tets[i], tets[i + 1], tets[i + 2], tets[i + 3]});
  }
  std::int64_t patch = 0;
  for (const std::string name : {"low_x", "elsewhere"}) {
    const auto faces = larges(file, name + "/ElementConnectivity");
    for (std::size_t i = 0; i < faces.size(); i += 3) {
      mesh.face({faces[i], faces[i + 1], faces[i + 2]}, patch);
    }
    ++patch;
  }
  EXPECT_EQ(content_of(mesh), content_of(grid));
  EXPECT_THAT(larges(file, "GridElements/ElementRange"), testing::ElementsAre(1, 384));
  EXPECT_THAT(larges(file, "elsewhere/ElementRange"), testing::ElementsAre(385 + 32, 576));
}

TEST(WriteCgns, tells_the_subdomain_of_each_tet) {
  const TempFolder folder;
  const GridSource grid(cut_grid(4));
  const Hdf5Input file(export_as(grid, folder, "", "a.cgns").string());
  const auto subdomains = file.list<std::int32_t>("Base/Zone1/CellData/Subdomain/ data");
  ASSERT_EQ(subdomains.size(), 384u);
  for (std::int32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(std::count(subdomains.begin(), subdomains.end(), i),
              std::ssize(grid.parts[static_cast<std::size_t>(i)].tets));
  }
}

/// The grid, with other names for its patches.
class RenamedGrid : public GridSource {
 public:
  explicit RenamedGrid(std::vector<std::string> names)
      : GridSource(cut_grid(3)), names_(std::move(names)) {}
  std::vector<std::string> patch_names() const override { return names_; }

 private:
  std::vector<std::string> names_;
};

TEST(WriteCgns, names_patches_in_no_more_than_32_characters_and_no_two_alike) {
  const TempFolder folder;
  const std::string longest(32, 'x');
  const RenamedGrid grid({longest + "_upper", longest + "_lower"});
  const Hdf5Input file(export_as(grid, folder, "", "a.cgns").string());
  EXPECT_TRUE(file.has("Base/" + longest));
  EXPECT_FALSE(file.has("Base/" + longest + "_"));
  const auto read = open_mesh(folder.path() / "a.cgns");
  ASSERT_EQ(read->patch_names().size(), 2U);
  EXPECT_NE(read->patch_names()[0], read->patch_names()[1]);
  for (const std::string& name : read->patch_names()) EXPECT_LE(name.size(), 32U) << name;
}

TEST(WriteCgns, gives_patches_no_name_that_a_node_of_the_zone_has) {
  for (const std::string name :
       {"ZoneType", "ZoneBC", "GridCoordinates", "GridElements", "CellData", "Zone1"}) {
    const TempFolder folder;
    const std::filesystem::path file =
        export_as(RenamedGrid({name, "high_x"}), folder, "", "a.cgns");
    const auto read = open_mesh(file, folder.path());
    ASSERT_EQ(read->patch_names().size(), 2U);
    EXPECT_NE(read->patch_names()[0], name);
    EXPECT_EQ(read->patch_names()[1], "high_x");
    EXPECT_EQ(outline_of(*read).boundary_triangles, outline_of(RenamedGrid({})).boundary_triangles);
  }
}

}  // namespace
}  // namespace tetfarm
