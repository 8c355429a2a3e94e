#include "worker/job_patch_types.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::vector<std::string> names_of_wing = {"wing_upper", "wing_lower", "tip", "outer_box"};

JobFile typed_job(const std::vector<std::string>& typed, const std::string& outer = "box") {
  JobFile job;
  job.outer_kind = outer;
  job.patches = patches_of_options(typed);
  return job;
}

std::vector<PatchType> types_by(const std::vector<std::string>& typed) {
  const JobFile job = typed_job(typed);
  require_patch_types(job, names_of_wing);
  return patch_types_of(job, names_of_wing);
}

std::string refusal_of_types(const std::vector<std::string>& typed) {
  return error_text_of<UsageError>([&] { types_by(typed); });
}

std::vector<std::string> texts_of(const std::vector<JobPatch>& patches) {
  std::vector<std::string> texts;
  for (const JobPatch& patch : patches) {
    texts.push_back(patch.glob + " " + patch.type + " " + std::to_string(patch.size).substr(0, 4));
  }
  return texts;
}

TEST(PatchesOfOptions, are_one_table_for_each_name) {
  EXPECT_THAT(texts_of(patches_of_options(std::vector<std::string>{"a,b=wall", "c=slip"},
                                          std::vector<std::string>{"b=0.25", "d=0.5"})),
              ElementsAre("a wall 0.00", "b wall 0.25", "c slip 0.00", "d  0.50"));
}

TEST(PatchesOfOptions, take_the_place_of_what_the_job_says_of_the_same) {
  const std::vector<std::string> of_job_types = {"a,b=wall"};
  const std::vector<std::string> of_job_sizes = {"b,c=0.25"};
  const std::vector<std::string> types = {"c=slip"};
  const std::vector<std::string> sizes = {"a=0.50"};
  const auto of_job = patches_of_options(of_job_types, of_job_sizes);
  EXPECT_THAT(texts_of(patches_of_options({}, {}, of_job)),
              ElementsAre("a wall 0.00", "b wall 0.25", "c  0.25"));
  EXPECT_THAT(texts_of(patches_of_options(types, {}, of_job)),
              ElementsAre("b  0.25", "c slip 0.25"));
  EXPECT_THAT(texts_of(patches_of_options({}, sizes, of_job)),
              ElementsAre("a wall 0.50", "b wall 0.00"));
  EXPECT_THAT(texts_of(patches_of_options(types, sizes, of_job)),
              ElementsAre("c slip 0.00", "a  0.50"));
}

TEST(PatchesOfOptions, are_refused_where_a_name_is_typed_twice) {
  EXPECT_EQ(refusal_of_types({"tip,wing_*=wall", "tip=slip"}),
            "--patch-type 'tip=slip': \"tip\" has been given before");
  const std::vector<std::string> sizes = {"tip=1", "tip=2"};
  EXPECT_EQ(error_text_of<UsageError>([&] { patches_of_options({}, sizes); }),
            "--patch-size 'tip=2': \"tip\" has been given before");
}

TEST(PatchTypesOfAJob, are_none_where_tables_have_sizes_alone) {
  JobFile job;
  job.patches = patches_of_options({}, std::vector<std::string>{"wing_*=0.1"});
  EXPECT_THAT(patch_types_of(job, names_of_wing), IsEmpty());
  require_patch_types(job, names_of_wing);
}

TEST(PatchTypesOfAJob, are_those_of_the_names_and_patterns) {
  EXPECT_THAT(
      types_by({"wing_*=wall", "outer_box=farfield"}),
      ElementsAre(PatchType::wall, PatchType::wall, PatchType::unspecified, PatchType::farfield));
  EXPECT_THAT(patch_types_of(typed_job({}), names_of_wing), IsEmpty());
}

TEST(PatchTypesOfAJob, are_of_the_very_name_before_patterns) {
  EXPECT_THAT(types_by({"*=wall", "tip=slip", "outer*=farfield"}),
              ElementsAre(PatchType::wall, PatchType::wall, PatchType::slip, PatchType::farfield));
}

TEST(PatchTypesOfAJob, reach_an_added_outer_boundary_only_by_patterns_for_it) {
  EXPECT_EQ(types_by({"*=wall"}).back(), PatchType::unspecified);
  const JobFile closed = typed_job({"*=wall"}, "none");
  EXPECT_EQ(patch_types_of(closed, names_of_wing).back(), PatchType::wall);
}

TEST(PatchTypesOfAJob, are_refused_where_nothing_matches_or_two_patterns_disagree) {
  EXPECT_EQ(refusal_of_types({"wing_uper=wall"}),
            "--patch-type 'wing_uper=wall': \"wing_uper\" matches none of the patches "
            "\"wing_upper\", \"wing_lower\", \"tip\"; did you mean \"wing_upper\"?");
  EXPECT_THAT(refusal_of_types({"wing_*=wall", "*_lower=slip"}),
              HasSubstr("the patch \"wing_lower\" is to be `slip`, and `wall` by --patch-type "
                        "'wing_*=wall'; name it by itself to say which, [patch.\"wing_lower\"]"));
  EXPECT_EQ(refusal_of_types({"wing_*=wall", "*_lower=slip", "wing_lower=slip"}), "");
  EXPECT_EQ(refusal_of_types({"wing_*=wall", "*_lower=wall"}), "");
  JobFile job = typed_job({"flap=wall"});
  job.patches[0].typed.clear();
  EXPECT_THAT(error_text_of<UsageError>([&] { require_patch_types(job, names_of_wing); }),
              HasSubstr("[patch.flap]: \"flap\" matches none"));
}

}  // namespace
}  // namespace tetfarm
