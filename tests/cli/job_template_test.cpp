#include "cli/job_template.h"

#include <gmock/gmock.h>

#include <set>

#include "base/error.h"
#include "mesh/job_file/job_file.h"
#include "tests/cli/settings_of_template.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Of a box of patches with such names, the first the finest.
ProposedJob proposed_with(const std::vector<std::string>& names) {
  ProposedJob proposed;
  proposed.name = "box";
  proposed.surface = "in/box.stl";
  proposed.triangles = 1200;
  proposed.box.add(Vec3{-1, 0, 0.25});
  proposed.box.add(Vec3{3, 2, 1.25});
  proposed.report.shortest_edge = 0.01;
  proposed.report.median_edge = 0.2;
  proposed.report.longest_edge = 0.4;
  proposed.report.smallest_angle_deg = 30;
  proposed.report.shells.resize(1);
  double edge = 0.1;
  for (const std::string& name : names) {
    proposed.patches.push_back({name, 200, edge});
    edge *= 1.5;
  }
  proposed.elements = 12345;
  proposed.subdomains = 4;
  proposed.elements_in_box = 54321;
  proposed.edge_of_box = 1.5;
  proposed.remeshing.size = 0.25;
  proposed.remeshing.min_size = 0.015625;
  proposed.remeshing.tolerance = 0.005;
  return proposed;
}

std::string template_of(const ProposedJob& proposed) { return job_template(proposed, "box.toml"); }

TEST(JobTemplate, says_nothing_but_the_defaults) {
  JobFile expected;
  expected.name = "box";
  expected.surface = "/jobs/in/box.stl";
  EXPECT_EQ(to_toml(parse_job_file(template_of(proposed_with({"a"})), "/jobs/job.toml")),
            to_toml(expected));
}

TEST(JobTemplate, is_valid_with_any_of_its_settings_in_force) {
  const std::string text = template_of(proposed_with({"a", "b"}));
  const std::vector<SettingInForce> all = settings_in_force(text);
  EXPECT_GE(all.size(), 20U);
  const std::string plain = to_toml(parse_job_file(text, "job.toml"));
  std::set<std::string> changing;
  for (const SettingInForce& in_force : all) {
    JobFile job;
    ASSERT_NO_THROW(job = parse_job_file(in_force.text, "job.toml")) << in_force.setting;
    if (to_toml(job) != plain) changing.insert(in_force.setting);
  }
  for (const char* setting :
       {"remesh = true", "outer = \"box\"", "spacing = 1.5", "default = 0.4", "[[source]]",
        "[[layers]]", "subdomains = 4", "max_memory = \"2GiB\"", "min_dihedral = 1"}) {
    EXPECT_TRUE(changing.contains(setting)) << setting;
  }
}

TEST(JobTemplate, shows_what_counts_without_a_setting) {
  const std::string text = template_of(proposed_with({"a", "b"}));
  const std::string plain = to_toml(parse_job_file(text, "job.toml"));
  int same = 0;
  for (const SettingInForce& in_force : settings_in_force(text)) {
    for (const char* word : {"surface = ", "max_elements = ", "min_unforced_dihedral = "}) {
      if (!in_force.setting.starts_with(word)) continue;
      EXPECT_EQ(to_toml(parse_job_file(in_force.text, "job.toml")), plain) << in_force.setting;
      ++same;
    }
  }
  EXPECT_EQ(same, 3);
}

TEST(JobTemplate, tells_the_surface_and_what_it_comes_to) {
  const std::string text = template_of(proposed_with({"wall"}));
  EXPECT_THAT(text, HasSubstr("# The surface has 1200 triangles in 1 shell.\n#   box 4 x 2 x 1, "
                              "from -1, 0, 0.25 to 3, 2, 1.25\n"));
  EXPECT_THAT(text, HasSubstr("#          200          0.1  \"wall\"\n"));
  EXPECT_THAT(text, HasSubstr("about 12.3k elements"));
  EXPECT_THAT(text, HasSubstr("54.3k"));
  EXPECT_THAT(text, HasSubstr("tetfarm run box.toml -o out"));
}

TEST(JobTemplate, names_the_finest_patches_for_layers) {
  const std::string text = template_of(proposed_with({"wing", "tip", "far field", "outlet"}));
  EXPECT_THAT(text, HasSubstr("#patches = [\"wing\", \"tip\"]\n#first_height = 0.01\n"));
}

TEST(JobTemplate, has_no_layers_where_there_are_several_regions) {
  ProposedJob proposed = proposed_with({"a"});
  proposed.report.regions = {{1, "core", 2.5}, {2, "shell", 1}};
  EXPECT_THAT(template_of(proposed), Not(HasSubstr("[[layers]]")));
  EXPECT_THAT(template_of(proposed), HasSubstr("#   region 1: \"core\", volume 2.5\n"));
}

TEST(JobTemplate, is_a_job_file_whatever_the_patches_are_called) {
  const std::vector<std::string> names = {
      "a\nversion = 2", "quote \" and \\", "\xff\xfe", "b\x01", "w*", "", "é"};
  const std::string text = template_of(proposed_with(names));
  EXPECT_NO_THROW(parse_job_file(text, "job.toml"));
  for (const SettingInForce& in_force : settings_in_force(text)) {
    EXPECT_NO_THROW(parse_job_file(in_force.text, "job.toml")) << in_force.setting;
  }
  EXPECT_THAT(template_of(proposed_with({"\xff"})), HasSubstr("#patches = [\"*\"]"));
}

TEST(JobTemplate, names_only_so_many_patches) {
  std::vector<std::string> names;
  for (int i = 0; i < 70; ++i) names.push_back("p" + std::to_string(i));
  EXPECT_THAT(template_of(proposed_with(names)), HasSubstr("\"p59\"\n#   and 10 more\n"));
}

TEST(JobTemplate, leaves_out_a_name_that_no_job_may_have) {
  ProposedJob proposed = proposed_with({"a"});
  proposed.name = "..";
  EXPECT_EQ(parse_job_file(template_of(proposed), "job.toml").name, "job");
}

TEST(JobTemplate, cannot_name_a_surface_whose_path_is_no_utf8) {
  ProposedJob proposed = proposed_with({"a"});
  proposed.surface = "b\xffx.stl";
  EXPECT_THROW(template_of(proposed), UsageError);
}

TEST(JobTemplate, has_lines_that_fit_a_terminal) {
  for (const std::string& line : lines_of(template_of(proposed_with({"a"})))) {
    EXPECT_LE(line.size(), 88U) << line;
  }
}

}  // namespace
}  // namespace tetfarm
