// The verdicts on the large real surfaces, as in the data's MANIFEST.csv.
#include "tests/mesh/inspect/real_surfaces.h"

#include <gmock/gmock.h>

#include "mesh/core/validate.h"
#include "tests/mesh/inspect/check_support.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(RealSurfaces, that_are_large_and_sound_pass_without_a_remark) {
  struct Sound {
    const char* file;
    std::size_t shells;
  };
  for (const Sound& sound : {Sound{"pipe/pipe.stl", 1},
                             {"onera_m6_sharp_te/onera_m6_sharp_te.stl", 1},
                             {"onera_m6_sharp_te/onera_m6_sharp_te.msh.gz", 1},
                             {"cessna210/cessna210.stl", 1},
                             {"prime_open_duct/prime_open_duct.msh.gz", 1},
                             {"d150_aircraft/d150_aircraft.stl", 2},
                             {"dtc_hull/dtc_hull.off.gz", 1}}) {
    const CheckedSurface checked = check_surface(read(sound.file));
    EXPECT_THAT(kinds(checked.report), IsEmpty()) << sound.file;
    EXPECT_THAT(checked.report.remarks, IsEmpty()) << sound.file;
    EXPECT_EQ(checked.report.shells.size(), sound.shells) << sound.file;
  }
}

TEST_F(RealSurfaces, as_found_facing_inward_are_turned) {
  const CheckedSurface checked = check_surface(read("cessna210/cessna.msh"));
  EXPECT_THAT(kinds(checked.report), IsEmpty());
  EXPECT_THAT(checked.report.remarks, ElementsAre(HasSubstr("was oriented inward")));
  EXPECT_GT(enclosed_volume(checked.surface.vertices, checked.surface.triangles), 0);
}

TEST_F(RealSurfaces, with_a_third_of_their_triangles_flipped_are_repaired) {
  const SurfaceMesh good = read("onera_m6_sharp_te/onera_m6_sharp_te.stl");
  std::mt19937 random(1);
  SurfaceMesh mesh = good;
  for (Triangle& t : mesh.triangles) {
    if (below(random, 3) == 0) std::swap(t[1], t[2]);
  }
  EXPECT_THAT(unmatched_edges(mesh.triangles), testing::Not(IsEmpty()));
  EXPECT_EQ(check_surface(mesh).surface.triangles, good.triangles);
}

TEST_F(RealSurfaces, of_a_body_of_two_shells_become_two_holes_in_an_outer_boundary) {
  const SurfaceMesh body = check_surface(read("d150_aircraft/d150_aircraft.stl")).surface;
  const CheckedSurface checked =
      check_surface(add_outer_boundary(body, {OuterBoundary::Kind::sphere, 5, 0}, 0.3));
  EXPECT_THAT(kinds(checked.report), IsEmpty());
  EXPECT_THAT(checked.report.remarks, IsEmpty());
  std::vector<int> depths;
  for (const Shell& shell : checked.report.shells) depths.push_back(shell.depth);
  EXPECT_THAT(depths, ElementsAre(1, 1, 0));
}

}  // namespace
}  // namespace tetfarm
