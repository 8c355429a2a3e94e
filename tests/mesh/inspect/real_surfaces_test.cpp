// The verdicts on the small real surfaces, as in the data's MANIFEST.csv.
#include "tests/mesh/inspect/real_surfaces.h"

#include <gmock/gmock.h>

#include "tests/mesh/inspect/check_support.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(RealSurfaces, that_are_sound_pass_without_a_remark) {
  struct Sound {
    const char* file;
    std::size_t shells;
  };
  for (const Sound& sound : {Sound{"cube_sphere/cube_sphere.stl", 1},
                             {"nasa_almond_quarter/NasaAlmondQuarterWavelengthv2.stl", 1},
                             {"nasa_almond_tenth/NasaAlmondTenthWavelengthv2.stl", 1},
                             {"nasa_almond_in_box/nasa_almond_in_box.stl", 2},
                             {"flange/flange.stl", 1},
                             {"netgen_plane/netgen_plane.stl", 1}}) {
    const SurfaceMesh mesh = read(sound.file);
    const CheckedSurface checked = check_surface(mesh);
    EXPECT_THAT(kinds(checked.report), IsEmpty()) << sound.file;
    EXPECT_THAT(checked.report.remarks, IsEmpty()) << sound.file;
    EXPECT_EQ(checked.report.shells.size(), sound.shells) << sound.file;
    EXPECT_EQ(checked.surface.triangles, mesh.triangles) << sound.file;
    EXPECT_NEAR(checked.report.volume, enclosed_volume(mesh.vertices, mesh.triangles),
                1e-9 * checked.report.volume);
  }
}

TEST_F(RealSurfaces, of_shells_that_pierce_each_other_are_refused) {
  const CheckedSurface checked =
      check_surface(read("bad_airplane_4shells/bad_airplane_4shells.stl"));
  ASSERT_THAT(kinds(checked.report), ElementsAre("self-intersection"));
  EXPECT_THAT(checked.report.defects[0].message, HasSubstr("16 pairs"));
  EXPECT_EQ(checked.report.shells.size(), 4U);
}

TEST_F(RealSurfaces, with_a_torn_seam_are_refused_as_open) {
  const CheckedSurface checked = check_surface(read("bad_open_object/bad_open_object.stl"));
  ASSERT_FALSE(checked.report.defects.empty());
  EXPECT_EQ(checked.report.defects[0].kind, "open edge");
  EXPECT_THAT(checked.report.defects[0].message, HasSubstr("8 open edges"));
  EXPECT_THAT(checked.report.defects[0].message, HasSubstr("joining these may close the surface"));
}

TEST_F(RealSurfaces, of_several_materials_are_told_apart) {
  const SurfaceMesh mesh = read("gmsh_piece_4vol/gmsh_piece_4vol.stl");
  const CheckedSurface checked = check_surface(mesh);
  ASSERT_THAT(kinds(checked.report), IsEmpty());
  ASSERT_EQ(checked.report.regions.size(), 4U);
  const auto interfaces = std::ranges::count_if(
      checked.surface.sides, [](const Sides& sides) { return sides[0] > 0 && sides[1] > 0; });
  EXPECT_EQ(interfaces, 240);
  EXPECT_NEAR(checked.report.volume, 0.98255, 1e-5);
}

TEST_F(RealSurfaces, of_a_body_get_an_outer_boundary_of_either_shape) {
  const SurfaceMesh almond = read("nasa_almond_quarter/NasaAlmondQuarterWavelengthv2.stl");
  for (const auto kind : {OuterBoundary::Kind::box, OuterBoundary::Kind::sphere}) {
    const CheckedSurface checked =
        check_surface(add_outer_boundary(check_surface(almond).surface, {kind, 3, 0}, 0.3));
    EXPECT_THAT(kinds(checked.report), IsEmpty());
    EXPECT_THAT(checked.report.remarks, IsEmpty());
    ASSERT_EQ(checked.report.shells.size(), 2U);
    EXPECT_EQ(checked.report.shells[0].depth, 1);
  }
}

}  // namespace
}  // namespace tetfarm
