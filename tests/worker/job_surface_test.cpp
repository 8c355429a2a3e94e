#include "worker/job_surface.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

constexpr const char* thin_tet_off =
    "OFF\n4 4 0\n0 0 0\n0.1 0 0\n0 3 0\n0 0 1e300\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

JobFile scaled_job(double scale) {
  JobFile job;
  job.scale = scale;
  return job;
}

TEST(SurfaceOfAJob, has_the_coordinates_of_its_file_times_the_scale) {
  const SurfaceMesh plain = read_surface_of_job(JobFile(), thin_tet_off, "a.off");
  EXPECT_EQ(plain.vertices[1], (Vec3{0.1, 0, 0}));
  const SurfaceMesh surface = read_surface_of_job(scaled_job(0.001), thin_tet_off, "a.off");
  EXPECT_EQ(surface.vertices[1].x, 0.1 * 0.001);
  EXPECT_EQ(surface.vertices[2].y, 3 * 0.001);
  EXPECT_EQ(surface.triangles, plain.triangles);
}

TEST(SurfaceOfAJob, that_the_scale_takes_out_of_range_is_refused) {
  EXPECT_THAT(error_text_of<InvalidInput>(
                  [] { read_surface_of_job(scaled_job(1e10), thin_tet_off, "a.off"); }),
              HasSubstr("a.off: the scale takes a coordinate out of range"));
}

TEST(SurfaceOfAJob, says_in_what_its_lengths_are) {
  EXPECT_EQ(lengths_text(JobFile()), "");
  EXPECT_EQ(unit_behind(JobFile()), "");
  EXPECT_EQ(lengths_text(scaled_job(0.001)), "0.001 times those of the surface's file");
  EXPECT_EQ(unit_behind(scaled_job(0.001)), "");
  JobFile in_inches = scaled_job(0.0254);
  in_inches.unit = "in";
  EXPECT_EQ(lengths_text(in_inches), "m, of a surface in in");
  EXPECT_EQ(unit_behind(in_inches), " m");
}

}  // namespace
}  // namespace tetfarm
