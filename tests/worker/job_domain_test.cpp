#include "worker/job_domain.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/decompose/planar_cut.h"
#include "tests/support/error_text.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

TEST(JobDomain, has_the_outer_boundary_that_the_job_asks_for) {
  JobFile job;
  job.outer_factor = 7;
  job.outer_spacing = 0.5;
  job.spacing_default = 0.25;
  using Kind = OuterBoundary::Kind;
  for (const auto& [word, kind] : std::initializer_list<std::pair<const char*, Kind>>{
           {"none", Kind::none}, {"box", Kind::box}, {"sphere", Kind::sphere}}) {
    job.outer_kind = word;
    const OuterBoundary outer = outer_boundary_of(job);
    EXPECT_EQ(outer.kind, kind) << word;
    EXPECT_EQ(outer.factor, 7);
    EXPECT_EQ(outer.spacing, 0.5);
    EXPECT_EQ(outer.default_spacing, 0.25);
    EXPECT_FALSE(outer.is_sketch);
  }
  job.outer_kind = "cube";
  EXPECT_EQ(error_text_of<UsageError>([&] { outer_boundary_of(job); }),
            "[domain] outer: unknown outer boundary \"cube\"");
}

TEST(JobDomain, has_the_spacing_that_the_job_asks_for) {
  JobFile job;
  job.spacing_default = 0.25;
  job.growth = 0.75;
  job.inherit_surface = false;
  job.sources = {{{{{1, 2, 3}, 0.125, 4, 5}}},
                 {{{{6, 7, 8}, 0.5, 9, 10}, {{11, 12, 13}, 0.625, 14, 15}}}};
  const SpacingOptions options = spacing_options_of(job);
  EXPECT_EQ(options.background, 0.25);
  EXPECT_EQ(options.growth, 0.75);
  EXPECT_FALSE(options.inherit_surface);
  ASSERT_EQ(options.sources.size(), 2U);
  ASSERT_EQ(options.sources[0].corners.size(), 1U);
  ASSERT_EQ(options.sources[1].corners.size(), 2U);
  const SourceCorner& last = options.sources[1].corners[1];
  EXPECT_EQ(last.at, (Vec3{11, 12, 13}));
  EXPECT_EQ(last.spacing, 0.625);
  EXPECT_EQ(last.inner_radius, 14);
  EXPECT_EQ(last.outer_radius, 15);
  EXPECT_EQ(options.sources[0].corners[0].spacing, 0.125);
  EXPECT_TRUE(spacing_options_of(JobFile{}).inherit_surface);
  job.sources_file = "/data/wing.sou";
  EXPECT_EQ(error_text_of<UsageError>([&] { spacing_options_of(job); }),
            "/data/wing.sou: the sources of this file must be in the job itself when it is "
            "submitted");
}

TEST(JobDomain, is_what_lies_in_the_surface_or_between_it_and_the_outer_boundary) {
  JobFile job;
  job.spacing_default = 0.25;
  const SurfaceMesh cube = shapes::unit_cube();
  const JobDomain inside = domain_of_job(job, cube);
  EXPECT_EQ(inside.surface.triangles.size(), 12U);
  EXPECT_EQ(inside.root.triangles.size(), 12U);
  EXPECT_EQ(inside.root.path.heap, 1U);
  EXPECT_EQ(inside.elements, estimated_elements(inside.root, inside.spacing));
  EXPECT_EQ(inside.spacing.at({0.5, 0.5, 0.5}), 0.25);
  job.outer_kind = "box";
  job.outer_factor = 2;
  const JobDomain outside = domain_of_job(job, cube);
  EXPECT_NEAR(domain_volume(outside.surface), 7, 1e-12) << "a box of edge 2 round it";
  EXPECT_EQ(outside.root.triangles.size(), outside.surface.triangles.size());
  EXPECT_EQ(outside.elements, estimated_elements(outside.root, outside.spacing));
  EXPECT_NE(outside.elements, inside.elements);
}

TEST(JobDomain, of_a_job_that_is_too_large_is_refused_with_a_size_that_would_do) {
  JobFile job;
  job.spacing_default = 0.01;
  job.max_elements = 10'000;
  EXPECT_THAT(error_text_of<UsageError>([&] { domain_of_job(job, shapes::unit_cube()); }),
              testing::MatchesRegex(
                  "spacing: the job would have about [0-9.]+ M elements, more than the 10.0 k that "
                  "it may have .*; `--size 0\\.[0-9]+` would give about [0-9.]+ k"));
}

TEST(JobDomain, with_layers_is_refused_where_triangles_lie_within_it_or_bound_other_regions) {
  JobFile job;
  job.spacing_default = 0.25;
  job.layers.resize(1);
  job.layers[0].patches = {"*"};
  job.layers[0].first_height = 0.01;
  job.layers[0].count = 2;
  SurfaceMesh cube = shapes::unit_cube();
  cube.sides.assign(cube.triangles.size(), Sides{1, 0});
  cube.sides[7] = {1, 1};
  EXPECT_THAT(error_text_of<UsageError>([&] { domain_of_job(job, cube); }),
              testing::MatchesRegex(".*layers.*: layers grow in a surface that bounds one region, "
                                    "and triangle 7 at .* lies within the domain, .*"));
  cube.sides[7] = {1, 2};
  EXPECT_THAT(error_text_of<UsageError>([&] { domain_of_job(job, cube); }),
              testing::HasSubstr("and this one bounds 2, as triangle 7 at "));
}

TEST(JobDomain, limits_tell_what_a_coarser_job_comes_to_and_leave_the_job_as_it_is) {
  JobFile job;
  job.spacing_default = 0.05;
  const SurfaceMesh cube = shapes::unit_cube();
  const JobLimits limits = limits_of_job(job, cube, 1.5, 77);
  EXPECT_EQ(limits.volume, 1.5);
  EXPECT_EQ(limits.free_bytes, 77);
  JobFile coarse;
  coarse.spacing_default = 0.2;
  EXPECT_EQ(limits.elements_with(0.2), domain_of_job(coarse, cube).elements);
  EXPECT_GT(limits.elements_with(0.1), 5 * limits.elements_with(0.2));
  EXPECT_EQ(job.spacing_default, 0.05);
}

}  // namespace
}  // namespace tetfarm
