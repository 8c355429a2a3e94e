// What the formats of solvers say of patches whose types are known.
#include <gmock/gmock.h>

#include "mesh/formats/hdf5/hdf5_file.h"
#include "mesh/formats/patch_boxes.h"
#include "mesh/formats/registry/open_mesh.h"
#include "mesh/formats/ugrid/mapbc.h"
#include "tests/mesh/formats/read_back.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// The grid, whose patch `low_x` lies in a plane of constant x, and `elsewhere` in five planes.
class TypedGrid : public GridSource {
 public:
  TypedGrid(PatchType low_x, PatchType elsewhere)
      : GridSource(cut_grid(2)), types_{low_x, elsewhere} {}
  std::vector<PatchType> patch_types() const override { return types_; }

 private:
  std::vector<PatchType> types_;
};

const TypedGrid symmetry_and_wall(PatchType::symmetry, PatchType::wall);
const TypedGrid no_types(PatchType::unspecified, PatchType::unspecified);

TEST(PatchTypesOfFiles, are_kept_by_vtkhdf_and_not_told_where_there_are_none) {
  const TempFolder folder;
  const fs::path file = export_as(symmetry_and_wall, folder, "", "a.vtkhdf");
  EXPECT_THAT(open_mesh(file, folder.path())->patch_types(),
              ElementsAre(PatchType::symmetry, PatchType::wall));
  const fs::path plain = export_as(GridSource(cut_grid(2)), folder, "", "b.vtkhdf");
  EXPECT_EQ(read_file(export_as(no_types, folder, "", "c.vtkhdf")), read_file(plain));
}

TEST(PatchTypesOfFiles, are_types_of_openfoam_patches_in_a_case_that_its_programs_open) {
  const TempFolder folder;
  const fs::path here = export_as(symmetry_and_wall, folder, "openfoam", "case");
  const std::string boundary = read_file(here / "constant/polyMesh/boundary");
  EXPECT_THAT(boundary, HasSubstr("low_x\n    {\n        type            symmetry;"));
  EXPECT_THAT(boundary, HasSubstr("elsewhere\n    {\n        type            wall;"));
  for (const char* name : {"controlDict", "fvSchemes", "fvSolution"}) {
    EXPECT_THAT(read_file(here / "system" / name), HasSubstr("object      " + std::string(name)));
  }
  EXPECT_TRUE(fs::exists(here / "case.foam"));
  EXPECT_FALSE(fs::exists(here / "system/decomposeParDict"));
}

TEST(PatchTypesOfFiles, leave_the_dictionaries_of_a_case_that_is_there_alone) {
  const TempFolder folder;
  fs::create_directories(folder.path() / "case/system");
  write_file_atomically(folder.path() / "case/system/controlDict", "mine");
  const fs::path here = export_as(no_types, folder, "openfoam", "case");
  EXPECT_EQ(read_file(here / "system/controlDict"), "mine");
  EXPECT_TRUE(fs::exists(here / "system/fvSchemes"));
}

TEST(PatchTypesOfFiles, are_on_every_processor_of_a_decomposed_case) {
  const TempFolder folder;
  const fs::path here = export_as(symmetry_and_wall, folder, "openfoam-decomposed", "case");
  for (const char* processor : {"processor0", "processor1", "processor2"}) {
    const std::string boundary = read_file(here / processor / "constant/polyMesh/boundary");
    EXPECT_THAT(boundary, HasSubstr("type            wall;"));
    EXPECT_THAT(boundary, HasSubstr("type            symmetry;"));
    EXPECT_THAT(boundary, HasSubstr("type            processor;"));
  }
  EXPECT_THAT(read_file(here / "system/decomposeParDict"), HasSubstr("numberOfSubdomains 3;"));
}

TEST(PatchTypesOfFiles, are_codes_in_a_mapbc_and_read_back_from_it) {
  const TempFolder folder;
  const fs::path file = export_as(symmetry_and_wall, folder, "", "a.b8.ugrid");
  EXPECT_EQ(read_file(folder.path() / "a.mapbc"), "2\n1 6661 low x\n2 4000 elsewhere\n");
  EXPECT_THAT(open_mesh(file, folder.path())->patch_types(),
              ElementsAre(PatchType::symmetry, PatchType::wall));
  export_as(TypedGrid(PatchType::farfield, PatchType::symmetry), folder, "", "b.b8.ugrid");
  EXPECT_EQ(read_file(folder.path() / "b.mapbc"), "2\n1 5000 low x\n2 3000 elsewhere\n")
      << "no plane";
}

TEST(PatchTypesOfFiles, are_boundary_conditions_of_cgns_and_of_its_families) {
  const TempFolder folder;
  const Hdf5Input file(export_as(symmetry_and_wall, folder, "", "a.cgns").string());
  const auto text = [&](const std::string& node) {
    const auto bytes = file.list<std::uint8_t>(node + "/ data");
    return std::string(bytes.begin(), bytes.end());
  };
  EXPECT_EQ(text("Base/Zone1/ZoneBC/low_x"), "BCSymmetryPlane");
  EXPECT_EQ(text("Base/low_x/FamBC"), "BCSymmetryPlane");
  EXPECT_EQ(text("Base/Zone1/ZoneBC/elsewhere"), "BCWallViscous");
  const Hdf5Input plain(export_as(no_types, folder, "", "b.cgns").string());
  EXPECT_FALSE(plain.has("Base/low_x/FamBC"));
}

TEST(PatchTypesOfFiles, are_markers_of_a_configuration_for_su2) {
  const TempFolder folder;
  export_as(TypedGrid(PatchType::inflow, PatchType::wall), folder, "", "a.su2");
  const std::string text = read_file(folder.path() / "a.cfg");
  EXPECT_THAT(text, HasSubstr("\nMESH_FILENAME= a.su2\nMESH_FORMAT= SU2\n"));
  EXPECT_THAT(text, HasSubstr("\nMARKER_HEATFLUX= ( elsewhere, 0.0 )\n"));
  EXPECT_THAT(text, HasSubstr("\n% set temperature, pressure and direction: MARKER_INLET= ( low_x, "
                              "288.15, 101325.0, 1.0, 0.0, 0.0 )\n"));
  EXPECT_THAT(text, Not(HasSubstr("MARKER_SYM")));
}

TEST(PatchTypesOfFiles, make_no_configuration_for_su2_of_nothing_nor_in_place_of_one) {
  const TempFolder folder;
  export_as(no_types, folder, "", "a.su2");
  EXPECT_FALSE(fs::exists(folder.path() / "a.cfg"));
  write_file_atomically(folder.path() / "b.cfg", "mine");
  export_as(symmetry_and_wall, folder, "", "b.su2");
  EXPECT_EQ(read_file(folder.path() / "b.cfg"), "mine");
}

TEST(Mapbc, has_a_code_for_each_plane_of_symmetry_and_3000_for_what_it_cannot_say) {
  Box3 box;
  box.add(Vec3{0, 1, 2});
  box.add(Vec3{5, 1, 4});
  EXPECT_EQ(mapbc_code(PatchType::symmetry, box), 6662);
  box.add(Vec3{5, 1 + 1e-9, 4});
  EXPECT_EQ(mapbc_code(PatchType::symmetry, box), 6662) << "rounding";
  box.add(Vec3{5, 1.1, 4});
  EXPECT_EQ(mapbc_code(PatchType::symmetry, box), 3000);
  EXPECT_EQ(mapbc_code(PatchType::symmetry, Box3()), 3000);
  EXPECT_EQ(mapbc_code(PatchType::pec, box), 3000);
  EXPECT_EQ(mapbc_code(PatchType::unspecified, box), 3000);
  EXPECT_EQ(mapbc_code(PatchType::inflow, box), 7011);
}

TEST(Mapbc, of_another_program_is_read_as_far_as_it_is_known) {
  const TempFolder folder;
  write_file_atomically(folder.path() / "a.mapbc",
                        "3\n1 4000 the wall\n2 6663 mirror\nnonsense\n3 5051 outlet\n");
  const Mapbc mapbc = read_mapbc(folder.path() / "a.mapbc");
  EXPECT_THAT(mapbc.names, ElementsAre("the wall", "mirror", "outlet"));
  EXPECT_THAT(mapbc.types,
              ElementsAre(PatchType::wall, PatchType::symmetry, PatchType::unspecified));
  EXPECT_TRUE(read_mapbc(folder.path() / "none.mapbc").names.empty());
}

TEST(PatchBoxes, are_those_of_the_surface_whatever_the_parts_are) {
  const CutGrid grid = cut_grid(3);
  const GridSource source(grid);
  const std::vector<Box3> boxes = patch_boxes(source, outline_of(source));
  const std::vector<Box3> of_surface = patch_boxes(grid.surface);
  ASSERT_EQ(boxes.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(boxes[i].low, of_surface[i].low);
    EXPECT_EQ(boxes[i].high, of_surface[i].high);
  }
  EXPECT_EQ(constant_axis(boxes[0]), 0);
  EXPECT_FALSE(constant_axis(boxes[1]));
}

}  // namespace
}  // namespace tetfarm
