#include "mesh/job_file/job_patches.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

JobFile job_of(const std::string& tables) {
  return parse_job_file("[geometry]\nsurface = \"a.stl\"\n" + tables, "a.toml");
}

std::string refusal_of_tables(const std::string& tables) {
  return error_text_of<UsageError>([&] { job_of(tables); });
}

std::string refusal_of_option(const std::string& typed) {
  return error_text_of<UsageError>([&] { parse_patch_type_option(typed); });
}

TEST(PatchTables, say_by_name_what_patches_are) {
  const JobFile job = job_of(
      "[patch.tip]\ntype = \"slip\"\n[patch.\"wing *\"]\ntype = \"wall\"\n[patch.outer]\ntype = "
      "\"farfield\"\n");
  ASSERT_EQ(job.patches.size(), 3U);
  EXPECT_EQ(job.patches[0].glob, "outer");
  EXPECT_EQ(job.patches[0].type, "farfield");
  EXPECT_EQ(job.patches[1].glob, "tip");
  EXPECT_EQ(job.patches[2].glob, "wing *");
  EXPECT_EQ(job.patches[2].type, "wall");
}

TEST(PatchTables, are_the_same_after_canonical_text) {
  const JobFile job =
      job_of("[patch.'a \"b\".c']\ntype = \"pec\"\n[patch.z]\ntype = \"interface\"\n");
  const std::string text = to_toml(job);
  const JobFile again = parse_job_file(text, "again.toml");
  ASSERT_EQ(again.patches.size(), 2U);
  EXPECT_EQ(again.patches[0].glob, "a \"b\".c");
  EXPECT_EQ(again.patches[0].type, "pec");
  EXPECT_EQ(to_toml(again), text);
}

TEST(PatchTables, are_refused_where_they_are_wrong) {
  EXPECT_EQ(refusal_of_tables("[patch.tip]\ntype = \"wal\"\n"),
            "a.toml:4:8: `type` is \"wal\", not one of \"wall\", \"slip\", \"symmetry\", "
            "\"farfield\", \"inflow\", \"outflow\", \"pec\", \"pmc\", \"absorbing\", "
            "\"interface\"; did you mean `wall`?");
  EXPECT_THAT(refusal_of_tables("[patch.tip]\n"), HasSubstr("`type` is missing"));
  EXPECT_THAT(refusal_of_tables("[patch.tip]\ntype = \"wall\"\nkind = 1\n"),
              HasSubstr("unknown key `kind` in [patch.tip]"));
  EXPECT_THAT(refusal_of_tables("[patch]\ntype = \"wall\"\n"),
              HasSubstr("a.toml:4:8: `type` must be a table of its own: [patch.NAME]"));
  EXPECT_THAT(refusal_of_tables("[[patch]]\ntype = \"wall\"\n"),
              HasSubstr("must be written [patch.NAME]"));
  EXPECT_THAT(refusal_of_tables("[patch.\"\"]\ntype = \"wall\"\n"), HasSubstr("an empty name"));
}

TEST(PatchTypeOption, names_patches_and_what_they_are) {
  const std::vector<JobPatch> patches = parse_patch_type_option("wing_*,a=b=symmetry");
  ASSERT_EQ(patches.size(), 2U);
  EXPECT_EQ(patches[0].glob, "wing_*");
  EXPECT_EQ(patches[1].glob, "a=b");
  EXPECT_EQ(patches[1].type, "symmetry");
  EXPECT_EQ(patches[1].typed, "wing_*,a=b=symmetry");
}

TEST(PatchTypeOption, is_refused_with_what_was_typed) {
  EXPECT_EQ(refusal_of_option("wing"), "--patch-type 'wing': must be PATCH,...=TYPE");
  EXPECT_THAT(
      refusal_of_option("wing=wal"),
      HasSubstr("--patch-type 'wing=wal': \"wal\" is no type of patch; they are wall, slip"));
  EXPECT_THAT(refusal_of_option("wing="), HasSubstr("\"\" is no type"));
  EXPECT_THAT(refusal_of_option("=wall"), HasSubstr("an empty name"));
  EXPECT_THAT(refusal_of_option("a,b,a=wall"), HasSubstr("has \"a\" twice"));
}

}  // namespace
}  // namespace tetfarm
