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

TEST(PatchTables, say_how_long_edges_are_at_patches) {
  const JobFile job =
      job_of("[patch.a]\nsize = 0.01\n[patch.b]\ntype = \"wall\"\nsize = 2\ngrowth = 0.125\n");
  ASSERT_EQ(job.patches.size(), 2U);
  EXPECT_EQ(job.patches[0].type, "");
  EXPECT_EQ(job.patches[0].size, 0.01);
  EXPECT_EQ(job.patches[0].growth, 0) << "that of the job";
  EXPECT_EQ(job.patches[1].type, "wall");
  EXPECT_EQ(job.patches[1].size, 2);
  EXPECT_EQ(job.patches[1].growth, 0.125);
  const std::string text = to_toml(job);
  EXPECT_EQ(to_toml(parse_job_file(text, "again.toml")), text);
  EXPECT_THAT(text, HasSubstr("\n[patch.\"a\"]\nsize = 0.01\n\n[patch.\"b\"]\ntype = \"wall\"\n"
                              "size = 2\ngrowth = 0.125\n"));
}

TEST(PatchTables, of_sizes_are_refused_where_they_are_wrong) {
  EXPECT_THAT(refusal_of_tables("[patch.a]\nsize = 0\n"), HasSubstr("`size` must be positive"));
  EXPECT_THAT(refusal_of_tables("[patch.a]\nsize = 1\ngrowth = -1\n"),
              HasSubstr("`growth` must be positive"));
  EXPECT_THAT(refusal_of_tables("[patch.a]\ntype = \"wall\"\ngrowth = 1\n"),
              HasSubstr("a.toml:5:10: `growth` needs `size`"));
}

TEST(PatchTables, say_which_layers_grow_on_a_patch_as_tables_of_layers_do) {
  const JobFile job = job_of(
      "[[layers]]\npatches = [\"a\"]\nfirst_height = 2\n[patch.b]\nlayers = { first_height = "
      "1e-4, count = 20 }\n[patch.c]\ntype = \"wall\"\nlayers.first_height = 3\n");
  ASSERT_EQ(job.layers.size(), 3U);
  EXPECT_EQ(job.layers[1].patches, std::vector<std::string>{"b"});
  EXPECT_EQ(job.layers[1].first_height, 1e-4);
  EXPECT_EQ(job.layers[1].count, 20);
  EXPECT_EQ(job.layers[2].first_height, 3);
  ASSERT_EQ(job.patches.size(), 1U) << "b has neither a type nor a size";
  EXPECT_EQ(job.patches[0].glob, "c");
  const JobFile long_form = job_of(
      "[[layers]]\npatches = [\"a\"]\nfirst_height = 2\n[[layers]]\npatches = "
      "[\"b\"]\nfirst_height "
      "= 1e-4\ncount = 20\n[[layers]]\npatches = [\"c\"]\nfirst_height = 3\n[patch.c]\ntype = "
      "\"wall\"\n");
  EXPECT_EQ(to_toml(job), to_toml(long_form));
}

TEST(PatchTables, of_layers_are_refused_where_they_are_wrong) {
  EXPECT_EQ(refusal_of_tables("[patch.a]\nlayers = { frist_height = 1 }\n"),
            "a.toml:4:12: unknown key `frist_height` in [patch.a.layers]; did you mean "
            "`first_height`?");
  EXPECT_THAT(refusal_of_tables("[patch.a]\nlayers = { count = 3 }\n"),
              HasSubstr("`first_height` is missing"));
  EXPECT_THAT(refusal_of_tables("[patch.a]\nlayers = { patches = [\"b\"], first_height = 1 }\n"),
              HasSubstr("unknown key `patches` in [patch.a.layers]"));
  EXPECT_THAT(refusal_of_tables("[patch.a]\nlayers = 20\n"), HasSubstr("a.toml:4:10: "));
  EXPECT_EQ(refusal_of_tables("[[layers]]\npatches = [\"x\", \"a\"]\nfirst_height = 1\n[patch.a]\n"
                              "layers = { first_height = 1 }\n"),
            "a.toml:7:10: `layers` cannot be given: a [[layers]] has the patch \"a\" already; say "
            "its layers in one of the two");
}

TEST(PatchSizeOption, names_patches_and_their_edges) {
  const std::vector<JobPatch> patches = parse_patch_size_option("wing_*,a=b=0.01");
  ASSERT_EQ(patches.size(), 2U);
  EXPECT_EQ(patches[0].glob, "wing_*");
  EXPECT_EQ(patches[1].glob, "a=b");
  EXPECT_EQ(patches[1].size, 0.01);
  EXPECT_EQ(patches[1].growth, 0);
  EXPECT_EQ(patches[1].type, "");
  EXPECT_EQ(patches[1].typed_size, "wing_*,a=b=0.01");
  EXPECT_EQ(parse_patch_size_option("tip=1e-3:0.25")[0].growth, 0.25);
}

TEST(PatchSizeOption, is_refused_with_what_was_typed) {
  const auto refusal = [](const std::string& typed) {
    return error_text_of<UsageError>([&] { parse_patch_size_option(typed); });
  };
  EXPECT_EQ(refusal("wing"), "--patch-size 'wing': must be PATCH,...=SIZE[:GROWTH]");
  for (const char* wrong : {"wing=", "wing=0", "wing=-1", "wing=1mm", "wing=inf", "wing=:0.3"}) {
    EXPECT_THAT(refusal(wrong), HasSubstr("is no size: a number above 0")) << wrong;
  }
  for (const char* wrong : {"wing=1:", "wing=1:0", "wing=1:0.3:2", "wing=1:nan"}) {
    EXPECT_THAT(refusal(wrong), HasSubstr("is no growth: a number above 0")) << wrong;
  }
  EXPECT_THAT(refusal("=1"), HasSubstr("an empty name"));
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
