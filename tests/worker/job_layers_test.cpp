#include "worker/job_layers.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/inspect/outer_boundary.h"
#include "mesh/layers/flat_plate.h"
#include "tests/support/error_text.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A cube of twelve triangles, two to each of its patches; edges 1 and √2, the upper median 1.
SurfaceMesh cube_of(const std::vector<std::string>& names) {
  SurfaceMesh cube = shapes::unit_cube();
  cube.patch_names = names;
  cube.patch_of_triangle.clear();
  for (std::size_t t = 0; t < cube.triangles.size(); ++t) {
    cube.patch_of_triangle.push_back(static_cast<std::int32_t>(std::min(t / 2, names.size() - 1)));
  }
  return cube;
}

const std::vector<std::string> of_wing = {"wing_upper", "wing_lower", "tip", "wall"};

JobFile job_with(const std::vector<std::string>& typed) {
  JobFile job;
  for (const std::string& text : typed) job.layers.push_back(parse_layers_option(text));
  return job;
}

std::vector<LayerRequest> requests_of(const std::string& typed) {
  return layer_requests_of(job_with({typed}), cube_of(of_wing));
}

std::string refusal_of_layers(const JobFile& job, const SurfaceMesh& surface) {
  return error_text_of<UsageError>([&] { layer_requests_of(job, surface); });
}

/// As if they stood in a job file.
JobFile untyped(JobFile job) {
  for (JobLayers& layers : job.layers) layers.typed.clear();
  return job;
}

TEST(LayerRequests, are_the_patches_and_heights_that_the_job_asks_for) {
  const auto requests = layer_requests_of(
      job_with({"wing_*:first=1e-3,growth=1.25,growth_cap=1.5,acceleration=1.05,count=20,equal=2,"
                "room=stop",
                "tip:first=0.5"}),
      cube_of(of_wing));
  ASSERT_EQ(requests.size(), 2U);
  EXPECT_THAT(requests[0].patches, ElementsAre(0, 1));
  EXPECT_EQ(
      requests[0].law,
      (HeightLaw{.first = 1e-3, .growth = 1.25, .acceleration = 1.05, .cap = 1.5, .equal = 2}));
  EXPECT_EQ(requests[0].count, 20);
  EXPECT_EQ(requests[0].room, RoomRule::stop);
  EXPECT_THAT(requests[1].patches, ElementsAre(2));
  EXPECT_EQ(requests[1].law,
            (HeightLaw{.first = 0.5, .growth = 1.2, .acceleration = 1, .cap = 1.2, .equal = 1}));
  EXPECT_EQ(requests[1].count, 0) << "until they are isotropic";
  EXPECT_EQ(requests[1].room, RoomRule::ratio);
  EXPECT_EQ(requests_of("tip:first=0.5,room=scale").front().room, RoomRule::scale);
  EXPECT_THAT(layer_requests_of(JobFile(), cube_of(of_wing)), IsEmpty());
}

TEST(LayerRequests, have_the_first_height_of_a_flat_plate_where_the_job_says_y_plus) {
  EXPECT_EQ(requests_of("tip:y_plus=2,reynolds=6e6,length=0.5").front().law.first,
            flat_plate(2, 6e6, 0.5).first_height);
}

TEST(LayerRequests, have_the_heights_that_the_job_lists) {
  const LayerRequest request = requests_of("tip:heights=0.125/0.25/0.125,room=scale").front();
  EXPECT_EQ(request.law, law_of_heights(std::vector<double>{0.125, 0.25, 0.125}));
  EXPECT_EQ(request.count, 3);
  EXPECT_EQ(request.room, RoomRule::scale);
  EXPECT_THAT(refusal_of_layers(job_with({"tip:heights=25/30"}), cube_of(of_wing)),
              HasSubstr("the first layer would be 25 high, which is more than the median edge"));
}

TEST(LayerRequests, are_in_tets_where_the_job_says_so) {
  EXPECT_TRUE(requests_of("tip:first=0.1,elements=tets").front().in_tets);
  EXPECT_FALSE(requests_of("tip:first=0.1,elements=prisms").front().in_tets);
  EXPECT_FALSE(requests_of("tip:first=0.1").front().in_tets);
}

TEST(LayerRequests, of_other_elements_where_their_patches_meet_are_refused) {
  const JobFile job = job_with({"tip:first=0.1,elements=tets", "wing_*:first=0.1"});
  EXPECT_THAT(refusal_of_layers(job, cube_of(of_wing)),
              ::testing::MatchesRegex(
                  "--layers '.*': its layers are of (tets|prisms), and meet those of "
                  "(tets|prisms) of --layers '.*' at \\(.*\\); the sides of prisms have no place "
                  "beside tets: give both the same `elements`"));
  const JobFile alike = job_with({"tip:first=0.1,elements=tets", "wing_*:first=0.1,elements=tets"});
  EXPECT_EQ(refusal_of_layers(alike, cube_of(of_wing)), "");
  const SurfaceMesh apart =
      add_outer_boundary(cube_of(of_wing), {.kind = OuterBoundary::Kind::box, .factor = 3}, 0.3);
  JobFile separate = job_with({"*:first=0.1,elements=tets", "outer_*:first=0.1"});
  separate.outer_kind = "box";
  EXPECT_EQ(refusal_of_layers(separate, apart), "");
}

TEST(LayerRequests, have_as_many_layers_as_reach_the_height_of_all) {
  EXPECT_EQ(requests_of("tip:first=0.125,growth=2,total=0.875").front().count, 3);
  EXPECT_EQ(requests_of("tip:first=0.125,growth=2,total=0.876").front().count, 4);
  EXPECT_EQ(requests_of("tip:first=0.125,growth=2,total=0.125").front().count, 1);
  EXPECT_EQ(requests_of("tip:first=0.125,growth=1,total=1").front().count, 8);
}

TEST(LayerRequests, of_a_pattern_that_matches_nothing_are_refused_with_what_there_is) {
  const JobFile job = job_with({"wing_uper:first=1e-3"});
  EXPECT_EQ(refusal_of_layers(job, cube_of(of_wing)),
            "--layers 'wing_uper:first=1e-3': \"wing_uper\" matches none of the patches "
            "\"wing_upper\", \"wing_lower\", \"tip\", \"wall\"; did you mean \"wing_upper\"?");
  EXPECT_EQ(refusal_of_layers(untyped(job), cube_of(of_wing)),
            "[[layers]] patches: \"wing_uper\" matches none of the patches "
            "\"wing_upper\", \"wing_lower\", \"tip\", \"wall\"; did you mean \"wing_upper\"?");
  EXPECT_THAT(refusal_of_layers(job_with({"wing_*,flap_*:first=1e-3"}), cube_of(of_wing)),
              HasSubstr("\"flap_*\" matches none of"))
      << "though the other pattern does";
  std::vector<std::string> many;
  for (int i = 0; i < 14; ++i) many.push_back("p" + std::to_string(i));
  EXPECT_THAT(refusal_of_layers(job_with({"banana:first=1e-3"}), cube_of(many)),
              ::testing::EndsWith("\"p8\", \"p9\" and 4 more"));
}

TEST(LayerRequests, of_a_surface_without_patches_take_the_whole_of_it) {
  SurfaceMesh cube = shapes::unit_cube();
  cube.patch_of_triangle.clear();
  cube.patch_names.clear();
  EXPECT_THAT(layer_requests_of(job_with({"*:first=1e-3"}), cube).front().patches, ElementsAre(0));
  EXPECT_THAT(layer_requests_of(job_with({"surface:first=1e-3"}), cube).front().patches,
              ElementsAre(0));
  EXPECT_THAT(refusal_of_layers(job_with({"wing:first=1e-3"}), cube),
              HasSubstr("\"wing\" matches no patch: the surface has only \"surface\", and \"*\" is "
                        "all of it"));
}

TEST(LayerRequests, of_two_that_match_the_same_patch_are_refused_naming_both) {
  const JobFile job = job_with({"wing_*:first=1e-3", "tip,*_lower:first=2e-3"});
  EXPECT_EQ(
      refusal_of_layers(job, cube_of(of_wing)),
      "--layers 'tip,*_lower:first=2e-3': the patch \"wing_lower\" is matched by \"*_lower\", "
      "and by \"wing_*\" of --layers 'wing_*:first=1e-3'; a patch has the layers of one of "
      "them only");
  EXPECT_EQ(refusal_of_layers(untyped(job), cube_of(of_wing)),
            "[[layers]] of \"tip\", \"*_lower\": the patch \"wing_lower\" is matched by "
            "\"*_lower\", and by \"wing_*\" of [[layers]] of \"wing_*\"; a patch has the layers of "
            "one of them only");
  EXPECT_THAT(requests_of("wing_*,*_lower:first=1e-3").front().patches, ElementsAre(0, 1))
      << "twice by the same layers is nothing to decide";
}

TEST(LayerRequests, do_not_take_the_outer_boundary_unless_it_is_named) {
  OuterBoundary outer;
  outer.kind = OuterBoundary::Kind::box;
  outer.factor = 3;
  const SurfaceMesh surface = add_outer_boundary(cube_of(of_wing), outer, 0.3);
  const auto patches_of = [&surface](const std::string& typed) {
    JobFile job = job_with({typed});
    job.outer_kind = "box";
    return layer_requests_of(job, surface).front().patches;
  };
  EXPECT_THAT(patches_of("*:first=1e-3"), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(patches_of("outer_*:first=1e-3"), ElementsAre(4));
  EXPECT_THAT(patches_of("outer_box,tip:first=1e-3"), ElementsAre(2, 4));
}

TEST(LayerRequests, of_a_first_layer_higher_than_the_edges_are_refused) {
  EXPECT_THAT(requests_of("tip:first=1,count=3"), ::testing::SizeIs(1));
  EXPECT_EQ(refusal_of_layers(job_with({"tip:first=25,count=3"}), cube_of(of_wing)),
            "--layers 'tip:first=25,count=3': the first layer would be 25 high, which is more than "
            "the median edge of these patches, 1: give it in the unit of the surface, at most 0.8");
  EXPECT_THAT(
      refusal_of_layers(job_with({"tip:y_plus=10000,reynolds=1e3,length=25"}), cube_of(of_wing)),
      HasSubstr("give a smaller y_plus, or the length that reynolds is of"));
}

TEST(LayerRequests, of_heights_that_cannot_be_are_refused) {
  const auto refusal = [](const std::string& typed) {
    return refusal_of_layers(job_with({typed}), cube_of(of_wing));
  };
  EXPECT_THAT(refusal("tip:y_plus=1,reynolds=1e6,length=1,total=1e-9"),
              HasSubstr("is higher than all of them together are to be, 1e-09"));
  EXPECT_EQ(refusal("tip:first=0.125,growth=1,total=200"),
            "--layers 'tip:first=0.125,growth=1,total=200': 1000 layers, the most that there may "
            "be, are only 125 high together, and not 200; give a higher first layer, or more "
            "growth");
  EXPECT_THAT(
      refusal("tip:first=1e-9,growth=1.001"),
      HasSubstr("not even layer 1000, the last that there may be, is as high as the edges"));
  EXPECT_THAT(refusal("tip:y_plus=1,reynolds=1e9,length=5e-324"),
              HasSubstr("the first layer has no height that a number can tell"));
}

TEST(LayerRequests, of_layers_without_a_finite_height_are_refused) {
  SurfaceMesh large = cube_of(of_wing);
  for (Vec3& vertex : large.vertices) vertex = 1e20 * vertex;
  EXPECT_THAT(refusal_of_layers(job_with({"tip:first=1e10,growth=2,count=1000"}), large),
              HasSubstr("have no finite height"));
}

TEST(LayerRequests, of_a_surface_that_was_not_checked_pass_over_triangles_of_no_vertices) {
  SurfaceMesh damaged = cube_of(of_wing);
  damaged.triangles[4] = {0, 1, 99};
  EXPECT_EQ(layer_figures_of(job_with({"tip:first=0.1"}), damaged).front().triangles, 1);
}

TEST(LayerFigures, tell_what_the_layers_come_to_at_the_median_edge) {
  const auto figures = layer_figures_of(
      job_with({"wing_*:first=0.125,growth=2,count=3", "tip:first=0.125,growth=2"}),
      cube_of(of_wing));
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_THAT(figures[0].patches, ElementsAre("wing_upper", "wing_lower"));
  EXPECT_EQ(figures[0].triangles, 4);
  EXPECT_EQ(figures[0].median_edge, 1);
  EXPECT_EQ(figures[0].layers, 3);
  EXPECT_EQ(figures[0].first_height, 0.125);
  EXPECT_EQ(figures[0].last_height, 0.5);
  EXPECT_EQ(figures[0].total_height, 0.875);
  EXPECT_FALSE(figures[0].in_tets);
  EXPECT_EQ(figures[0].isotropic_layer, 4) << "1 is the first above 0.8";
  EXPECT_EQ(figures[1].layers, 4) << "until they are isotropic";
  EXPECT_EQ(figures[1].last_height, 1);
}

TEST(LayerFigures, of_listed_heights_are_those_of_the_list) {
  const auto figures = layer_figures_of(
      job_with({"tip:heights=0.25/0.5/0.75/0.5", "wall:heights=0.5/1"}), cube_of(of_wing));
  EXPECT_EQ(figures[0].layers, 4);
  EXPECT_EQ(figures[0].first_height, 0.25);
  EXPECT_EQ(figures[0].last_height, 0.5);
  EXPECT_EQ(figures[0].total_height, 2);
  EXPECT_EQ(figures[0].isotropic_layer, 0);
  EXPECT_EQ(figures[1].isotropic_layer, 2);
  EXPECT_TRUE(
      layer_figures_of(job_with({"tip:first=0.1,elements=tets"}), cube_of(of_wing))[0].in_tets);
}

TEST(LayerFigures, of_layers_that_stay_flat_have_no_isotropic_one) {
  const auto figures =
      layer_figures_of(job_with({"tip:first=1e-4,growth=1,count=5"}), cube_of(of_wing));
  EXPECT_EQ(figures.front().isotropic_layer, 0);
  EXPECT_EQ(figures.front().layers, 5);
}

TEST(LayerFigures, of_a_patch_without_triangles_are_those_of_the_job_alone) {
  std::vector<std::string> names = of_wing;
  SurfaceMesh cube = cube_of(names);
  cube.patch_names.push_back("nothing");
  const auto figures = layer_figures_of(job_with({"nothing:first=0.1,count=5"}), cube);
  EXPECT_EQ(figures.front().triangles, 0);
  EXPECT_EQ(figures.front().median_edge, 0);
  EXPECT_EQ(figures.front().first_height, 0.1);
}

}  // namespace
}  // namespace tetfarm
