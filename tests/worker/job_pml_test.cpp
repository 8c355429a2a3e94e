#include "worker/job_pml.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/inspect/outer_boundary.h"
#include "mesh/layers/layer_plan.h"
#include "tests/support/error_text.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

JobFile pml_job(const std::string& typed, const std::string& outer = "none") {
  JobFile job;
  job.outer_kind = outer;
  job.pml = parse_pml_option(typed);
  return job;
}

/// A ball, patch "surface", in a box of side 4, patch "outer_box", in 12 n² triangles.
SurfaceMesh ball_in_outer_box() {
  OuterBoundary outer;
  outer.kind = OuterBoundary::Kind::box;
  outer.factor = 2;
  outer.spacing = 0.5;
  return add_outer_boundary(shapes::sphere({0, 0, 0}, 1, 2), outer, 0.3);
}

std::string pml_refusal(const JobFile& job) {
  return error_text_of<UsageError>([&] { pml_patches_of(job, ball_in_outer_box()); });
}

TEST(JobPml, is_as_high_as_the_median_edge_where_no_height_is_given) {
  const PmlBlock block = pml_block_of(pml_job("outer", "box"), ball_in_outer_box());
  EXPECT_THAT(block.figures.patches, ElementsAre("outer_box"));
  EXPECT_EQ(block.figures.layers, 10);
  EXPECT_NEAR(block.figures.height, 0.5, 0.05);
  EXPECT_NEAR(block.figures.thickness, 10 * block.figures.height, 1e-12);
  EXPECT_EQ(block.figures.tets, 30 * block.figures.triangles);
  EXPECT_EQ(block.figures.prisms, 0);
  EXPECT_TRUE(block.request.in_tets);
}

TEST(JobPml, moves_the_boundary_by_all_of_its_layers) {
  const SurfaceMesh surface = ball_in_outer_box();
  const PmlBlock block =
      pml_block_of(pml_job("outer_*:layers=4,height=0.25,elements=prisms", "box"), surface);
  const Vec3 grown = bounding_box(block.surface.vertices).size();
  const Vec3 was = bounding_box(surface.vertices).size();
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(grown[axis], was[axis] + 2, 1e-12);
  EXPECT_EQ(block.figures.prisms, 4 * block.figures.triangles);
  EXPECT_EQ(block.figures.tets, 0);
}

TEST(JobPml, on_the_inside_leaves_the_boundary_and_ends_by_all_of_its_layers_within) {
  const SurfaceMesh surface = ball_in_outer_box();
  const PmlBlock block =
      pml_block_of(pml_job("outer:layers=2,height=0.25,side=inside", "box"), surface);
  EXPECT_EQ(block.surface.vertices, surface.vertices);
  Box3 inner;
  for (const LayerLine& line : plan_layers(surface, {&block.request, 1}).lines) {
    inner.add(point_of(line, line.stop));
  }
  const Box3 outer = bounding_box(surface.vertices);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(inner.low[axis], outer.low[axis] + 0.5, 1e-12);
    EXPECT_NEAR(inner.high[axis], outer.high[axis] - 0.5, 1e-12);
  }
}

TEST(JobPml, on_the_inside_is_refused_where_something_is_in_its_way) {
  const SurfaceMesh surface = ball_in_outer_box();
  const PmlBlock block =
      pml_block_of(pml_job("outer:layers=5,height=0.25,side=inside", "box"), surface);
  EXPECT_THAT(error_text_of<UsageError>([&] {
                plan_layers(surface, {&block.request, 1});
              }),
              HasSubstr("fewer or lower layers"));
}

TEST(JobPml, goes_round_the_outer_boundary_of_the_job_by_names_that_begin_with_outer_alone) {
  EXPECT_THAT(pml_patches_of(pml_job("outer", "box"), ball_in_outer_box()), ElementsAre(1));
  EXPECT_THAT(pml_patches_of(pml_job("outer_box", "box"), ball_in_outer_box()), ElementsAre(1));
  EXPECT_THAT(pml_patches_of(pml_job("*", "box"), ball_in_outer_box()), ElementsAre(0));
}

TEST(JobPml, refuses_names_that_match_no_patch_as_they_were_typed) {
  EXPECT_EQ(pml_refusal(pml_job("outer_bxo", "box")),
            "--pml 'outer_bxo': \"outer_bxo\" matches none of the patches \"surface\", "
            "\"outer_box\"; did you mean \"outer_box\"?");
  JobFile job = pml_job("far", "box");
  job.pml->typed.clear();
  EXPECT_THAT(pml_refusal(job), testing::StartsWith("[[pml]] patches: \"far\" matches none"));
}

TEST(JobPml, refuses_a_patch_that_is_to_have_boundary_layers_as_well) {
  JobFile job = pml_job("outer_box", "box");
  job.layers = {parse_layers_option("outer_box:first=0.01,count=3")};
  EXPECT_THAT(pml_refusal(job), HasSubstr("\"outer_box\" is to have boundary layers as well"));
}

TEST(JobPml, refuses_the_wall_of_a_hole) {
  EXPECT_THAT(error_text_of<UsageError>(
                  [] { pml_block_of(pml_job("surface", "box"), ball_in_outer_box()); }),
              HasSubstr("bounds a hole in the domain"));
}

TEST(JobPml, in_blocks_says_what_there_will_be) {
  const PmlBlock block = pml_blocks_of(pml_job("outer:layers=4,height=0.25,corners=block", "box"),
                                       ball_in_outer_box());
  const std::int64_t n = 8;  // edges along one of the box
  EXPECT_EQ(block.figures.triangles, 12 * (n + 8) * (n + 8));
  EXPECT_EQ(block.figures.tets, 3 * 4 * 12 * n * n + 6 * 16 * 12 * n + 6 * 64 * 8);
  EXPECT_EQ(block.figures.thickness, 1);
}

TEST(JobPml, in_blocks_is_refused_where_its_patch_is_no_side_of_the_box) {
  JobFile job = pml_job("surface:corners=block", "box");
  EXPECT_THAT(error_text_of<UsageError>([&] { pml_blocks_of(job, ball_in_outer_box()); }),
              HasSubstr("take corners = \"mitre\""));
}

TEST(JobPml, names_a_plane_of_symmetry_only_where_it_is_meant) {
  JobFile job = pml_job("*", "box");
  job.symmetry.emplace();
  SurfaceMesh surface = ball_in_outer_box();
  surface.patch_names.emplace_back("symmetry");
  EXPECT_THAT(pml_patches_of(job, surface), ElementsAre(0));
  job.pml->patches = {"outer"};
  EXPECT_THAT(pml_patches_of(job, surface), ElementsAre(1));
  job.pml->patches = {"symmetry"};
  EXPECT_THAT(pml_patches_of(job, surface), ElementsAre(2));
}

}  // namespace
}  // namespace tetfarm
