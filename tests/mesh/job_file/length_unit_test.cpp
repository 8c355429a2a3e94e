#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/job_file/job_file.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

JobFile job_of_geometry(const std::string& lines) {
  return parse_job_file("[geometry]\nsurface = \"a.stl\"\n" + lines, "a.toml");
}

std::string refusal_of_geometry(const std::string& lines) {
  return error_text_of<UsageError>([&] { job_of_geometry(lines); });
}

TEST(LengthUnit, has_so_many_metres) {
  EXPECT_EQ(metres_of("m"), 1);
  EXPECT_EQ(metres_of("mm"), 0.001);
  EXPECT_EQ(metres_of("in"), 0.0254);
  for (const char* wrong : {"", "M", "mm ", "metres", "inch"}) EXPECT_FALSE(metres_of(wrong));
  for (const std::string_view unit : length_units()) EXPECT_GT(metres_of(unit).value_or(0), 0);
}

TEST(LengthUnit, of_a_surface_scales_it_to_metres) {
  const JobFile job = job_of_geometry("unit = \"cm\"\n");
  EXPECT_EQ(job.unit, "cm");
  EXPECT_EQ(job.scale, 0.01);
  const JobFile again = parse_job_file(to_toml(job), "b.toml");
  EXPECT_EQ(again.unit, "cm");
  EXPECT_EQ(again.scale, 0.01);
}

TEST(LengthUnit, need_not_be_told_with_a_scale) {
  const JobFile job = job_of_geometry("scale = 0.30000000000000004\n");
  EXPECT_EQ(job.unit, "");
  EXPECT_EQ(job.scale, 0.30000000000000004);
  EXPECT_EQ(parse_job_file(to_toml(job), "b.toml").scale, job.scale);
  EXPECT_EQ(to_toml(job_of_geometry("")).find("scale"), std::string::npos);
  EXPECT_EQ(to_toml(job_of_geometry("scale = 1\n")), to_toml(job_of_geometry("")));
}

TEST(LengthUnit, is_refused_where_it_is_wrong_or_told_twice) {
  EXPECT_THAT(refusal_of_geometry("unit = \"mn\"\n"),
              HasSubstr("a.toml:3:8: `unit` is \"mn\", not one of \"m\", \"km\", \"cm\", \"mm\", "
                        "\"um\", \"in\", \"ft\""));
  EXPECT_THAT(refusal_of_geometry("scale = -1\n"), HasSubstr("`scale` must be positive"));
  EXPECT_THAT(refusal_of_geometry("scale = 0.001\nunit = \"mm\"\n"),
              HasSubstr("a.toml:3:9: `scale` cannot be given together with `unit`"));
}

}  // namespace
}  // namespace tetfarm
