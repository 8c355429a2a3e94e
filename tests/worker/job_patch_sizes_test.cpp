#include "worker/job_patch_sizes.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/support/error_text.h"
#include "tests/support/shapes.h"
#include "worker/checked_input.h"
#include "worker/job_domain.h"
#include "worker/job_patch_types.h"
#include "worker/job_remeshing.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<std::string> patches_of_wing = {"wing_upper", "wing_lower", "tip"};

JobFile sized_job(const std::vector<std::string>& sizes, const std::string& outer = "none") {
  JobFile job;
  job.outer_kind = outer;
  job.outer_factor = default_outer_factor(outer);
  job.patches = patches_of_options({}, sizes);
  return job;
}

/// Of edge 1, its top (z = 1) a patch of its own.
SurfaceMesh cube_with_top() {
  SurfaceMesh cube = shapes::box({0, 0, 0}, {1, 1, 1}, 4);
  cube.patch_names = {"sides", "top"};
  cube.patch_of_triangle.clear();
  for (const Triangle& triangle : cube.triangles) {
    bool is_top = true;
    for (const std::int32_t v : triangle) {
      is_top = is_top && cube.vertices[static_cast<std::size_t>(v)].z == 1;
    }
    cube.patch_of_triangle.push_back(is_top ? 1 : 0);
  }
  return cube;
}

std::string refusal_of_sizes(const std::vector<std::string>& sizes,
                             const std::string& outer = "none") {
  return error_text_of<UsageError>(
      [&] { require_patch_sizes(sized_job(sizes, outer), patches_of_wing); });
}

TEST(PatchSizes, are_of_the_triangles_of_patches_that_have_one) {
  const SurfaceMesh cube = cube_with_top();
  const auto demands = patch_demands(sized_job({"top=0.02:0.1"}), cube, cube.patch_names);
  ASSERT_EQ(demands.size(), 32U);
  for (const TriangleDemand& demand : demands) {
    for (const Vec3& corner : demand.corners) EXPECT_EQ(corner.z, 1);
    EXPECT_EQ(demand.spacing, 0.02);
    EXPECT_EQ(demand.growth, 0.1);
  }
  JobFile by_default = sized_job({"t*=0.02"});
  by_default.growth = 0.25;
  EXPECT_EQ(patch_demands(by_default, cube, cube.patch_names).front().growth, 0.25);
  EXPECT_EQ(patch_demands(JobFile(), cube, cube.patch_names).size(), 0U);
}

TEST(PatchSizes, are_of_the_very_name_before_patterns) {
  const SurfaceMesh cube = cube_with_top();
  const auto demands = patch_demands(sized_job({"*=0.3", "top=0.02"}), cube, cube.patch_names);
  ASSERT_EQ(demands.size(), cube.triangles.size());
  for (std::size_t t = 0; t < demands.size(); ++t) {
    EXPECT_EQ(demands[t].spacing, cube.patch_of_triangle[t] == 1 ? 0.02 : 0.3);
  }
}

TEST(PatchSizes, are_refused_where_nothing_matches_or_two_patterns_disagree) {
  EXPECT_EQ(refusal_of_sizes({"wing_uper=0.1"}),
            "--patch-size 'wing_uper=0.1': \"wing_uper\" matches none of the patches "
            "\"wing_upper\", \"wing_lower\", \"tip\"; did you mean \"wing_upper\"?");
  EXPECT_THAT(
      refusal_of_sizes({"wing_*=0.1", "*_lower=0.2:0.1"}),
      HasSubstr("edges at the patch \"wing_lower\" are to be 0.2, growing by 0.1, and 0.1, growing "
                "by 0.3 by --patch-size 'wing_*=0.1'; name it by itself to say which"));
  EXPECT_EQ(refusal_of_sizes({"wing_*=0.1", "*_lower=0.1:0.3"}), "") << "they agree";
  EXPECT_EQ(refusal_of_sizes({"wing_*=0.1", "*_lower=0.2", "wing_lower=0.2"}), "");
  EXPECT_EQ(refusal_of_sizes({"tip=0.1:0.4"}),
            "--patch-size 'tip=0.1:0.4': edges may not grow by 0.4 there, which is more than the "
            "0.3 of [spacing] growth (--growth)");
  JobFile of_file = sized_job({"flap=0.1"});
  of_file.patches[0].typed_size.clear();
  EXPECT_THAT(error_text_of<UsageError>([&] { require_patch_sizes(of_file, patches_of_wing); }),
              HasSubstr("[patch.flap]: \"flap\" matches none"));
}

TEST(PatchSizes, are_not_of_what_the_job_adds) {
  EXPECT_THAT(refusal_of_sizes({"outer_box=0.1"}, "box"),
              HasSubstr("; the edges of the outer boundary are as long as [domain] spacing"));
  const SurfaceMesh cube = cube_with_top();
  JobFile job = sized_job({"*=0.05"}, "box");
  EXPECT_THAT(own_patch_names(job, cube), ElementsAre("sides", "top"));
  const JobDomain domain = domain_of_job(job, check_surface_of_job(job, cube).surface);
  const Box3 box = bounding_box(domain.surface.vertices);
  EXPECT_GT(domain.spacing.at({box.high.x, 0.5, 0.5}), 0.3);
}

TEST(PatchSizes, make_a_domain_fine_there_with_and_without_an_outer_boundary) {
  const SurfaceMesh cube = cube_with_top();
  for (const char* outer : {"none", "box"}) {
    JobFile job = sized_job({"top=0.02"}, outer);
    const CheckedSurface checked = check_surface_of_job(job, cube);
    const JobDomain fine = domain_of_job(job, checked.surface);
    EXPECT_NEAR(fine.spacing.at({0.4, 0.5, 1}), 0.02, 0.004) << outer;
    EXPECT_GT(fine.spacing.at({0.5, 0.5, 0}), 0.15) << outer;
    job.patches.clear();
    EXPECT_GT(fine.elements, 5 * domain_of_job(job, checked.surface).elements) << outer;
  }
}

TEST(PatchSizes, count_from_the_wall_where_layers_grow_on_it) {
  JobFile job = sized_job({"top=0.02"}, "box");
  job.layers = {parse_layers_option("top:first=0.01,count=3")};
  const JobDomain domain = domain_of_job(job, check_surface_of_job(job, cube_with_top()).surface);
  ASSERT_TRUE(domain.layers.has_value());
  EXPECT_GT(domain.layers->cells, 0);
  EXPECT_LT(domain.spacing.at({0.5, 0.5, 1.04}), 0.04);
}

TEST(PatchSizes, make_the_plane_of_half_a_body_fine_beside_them) {
  SurfaceMesh half = cube_with_top();
  // Open at x = 0.
  std::vector<Triangle> kept;
  std::vector<std::int32_t> patches;
  for (std::size_t t = 0; t < half.triangles.size(); ++t) {
    bool is_on_plane = true;
    for (const std::int32_t v : half.triangles[t]) {
      is_on_plane = is_on_plane && half.vertices[static_cast<std::size_t>(v)].x == 0;
    }
    if (is_on_plane) continue;
    kept.push_back(half.triangles[t]);
    patches.push_back(half.patch_of_triangle[t]);
  }
  half.triangles = kept;
  half.patch_of_triangle = patches;
  JobFile job = sized_job({"top=0.02"}, "box");
  job.symmetry = parse_symmetry("x=0");
  const CheckedSurface fine = check_surface_of_job(job, half);
  ASSERT_TRUE(fine.report.defects.empty());
  EXPECT_THAT(own_patch_names(job, fine.surface), ElementsAre("sides", "top"));
  EXPECT_NEAR(domain_of_job(job, fine.surface).spacing.at({0.5, 0.5, 1}), 0.02, 0.004);
  job.patches.clear();
  EXPECT_GT(fine.surface.triangles.size(),
            check_surface_of_job(job, half).surface.triangles.size());
}

TEST(PatchSizes, make_the_triangles_of_a_remeshed_surface_small) {
  JobFile job = sized_job({"top=0.05"});
  job.remeshing.emplace();
  job.remeshing->size = 0.25;
  const SurfaceMesh made = surface_to_mesh(job, check_surface_of_job(job, cube_with_top())).surface;
  std::array<int, 2> triangles{};
  for (const std::int32_t patch : made.patch_of_triangle) {
    ++triangles.at(static_cast<std::size_t>(patch));
  }
  EXPECT_GT(triangles[1], 600) << "of about 0.05";
  EXPECT_NEAR(domain_of_job(job, made).spacing.at({0.5, 0.5, 1}), 0.05, 0.01);
}

}  // namespace
}  // namespace tetfarm
