#include "mesh/job_file/plane_sources.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

constexpr const char* both = R"(size = 0.1
[[line]]
from = [0, 0]
to = [1, 2.5]
sizes = [0.2, 0.01]
radius = 0.3
[[point]]
at = [-1, 2]
sizes = [0.1, 0.02]
angle = 30
radius = 0.5
growth = 1.2
[[line]]
from = [1, 0]
to = [0, 1]
sizes = [1, 1]
angle = -45
radius = 2
growth = "off"
)";

std::string refusal(const std::string& text) {
  try {
    parse_plane_sources(text, "s.toml");
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

/// A point that lacks nothing, with a line in the place of one of its own.
std::string point_with(const std::string& line) {
  std::string text = "[[point]]\n";
  const std::string key = line.substr(0, line.find(' '));
  for (const char* own : {"at = [0, 0]", "sizes = [1, 2]", "radius = 1"}) {
    if (!std::string(own).starts_with(key + " ")) text += std::string(own) + "\n";
  }
  return text + line + "\n";
}

TEST(PlaneSourcesFile, has_what_is_written_in_the_order_of_the_file) {
  const PlaneSources all = parse_plane_sources(both, "s.toml");
  EXPECT_EQ(all.size, 0.1);
  ASSERT_EQ(all.sources.size(), 3U);
  const PlaneSource& line = all.sources[0];
  EXPECT_TRUE(line.is_line);
  EXPECT_EQ(line.to, (std::array{1.0, 2.5}));
  EXPECT_EQ(line.sizes, (std::array{0.2, 0.01}));
  EXPECT_EQ(line.angle_deg, 0);
  EXPECT_EQ(line.radius, 0.3);
  EXPECT_EQ(line.growth, 1.4);
  EXPECT_EQ(line.line, 2);
  const PlaneSource& point = all.sources[1];
  EXPECT_FALSE(point.is_line);
  EXPECT_EQ(point.from, (std::array{-1.0, 2.0}));
  EXPECT_EQ(point.to, point.from);
  EXPECT_EQ(point.angle_deg, 30);
  EXPECT_EQ(point.growth, 1.2);
  EXPECT_EQ(all.sources[2].growth, 0);
  EXPECT_EQ(all.sources[2].angle_deg, -45);
}

TEST(PlaneSourcesFile, is_the_same_after_it_was_written_and_read) {
  std::vector<PlaneSource> before = parse_plane_sources(both, "s.toml").sources;
  std::vector<PlaneSource> after = parse_plane_sources(to_toml(before), "s.toml").sources;
  for (std::vector<PlaneSource>* sources : {&before, &after}) {
    for (PlaneSource& source : *sources) source.line = 0;
  }
  EXPECT_EQ(after, before);
}

TEST(PlaneSourcesFile, says_what_is_wrong_and_where) {
  EXPECT_EQ(refusal(point_with("radius = 1")), "");
  EXPECT_EQ(refusal(""), "s.toml: has no source: a source is a table [[point]] or [[line]]");
  EXPECT_THAT(refusal("size = 1\npoint = []\n"), HasSubstr("has no source"));
  EXPECT_THAT(refusal("[point]\nat = [0, 0]\n"), HasSubstr("must be written [[point]]"));
  EXPECT_EQ(refusal(point_with("raduis = 1")),
            "s.toml:5:1: unknown key `raduis` in [point]; did you mean `radius`?");
  EXPECT_THAT(refusal("[[pont]]\n"), HasSubstr("did you mean `point`?"));
  EXPECT_THAT(refusal("[[point]]\nat = [0, 0]\nsizes = [1, 1]\n"),
              HasSubstr("s.toml:1:1: `radius` is missing in [point]"));
  EXPECT_THAT(refusal(point_with("at = [0, 0, 0]")), HasSubstr("must be two numbers, [x, y]"));
  EXPECT_THAT(refusal(point_with("at = [0, nan]")), HasSubstr("s.toml:4:10: `at` must be finite"));
  EXPECT_THAT(refusal(point_with("at = [0, 1e300]")), HasSubstr("within 1e40"));
  EXPECT_THAT(refusal("[[line]]\nfrom = [1, 0]\nto = [1, 0]\nsizes = [1, 1]\nradius = 1\n"),
              HasSubstr("s.toml:3:6: `to` is where `from` is"));
}

TEST(PlaneSourcesFile, refuses_numbers_that_make_no_metric) {
  EXPECT_THAT(refusal(point_with("sizes = [1]")), HasSubstr("must be two lengths"));
  EXPECT_THAT(refusal(point_with("sizes = 1")), HasSubstr("must be an array"));
  EXPECT_THAT(refusal(point_with("sizes = [1, 0]")), HasSubstr("s.toml:4:13: `sizes` must be p"));
  EXPECT_THAT(refusal(point_with("sizes = [-1, 1]")), HasSubstr("must be positive"));
  EXPECT_THAT(refusal(point_with("sizes = [1, nan]")), HasSubstr("must be finite"));
  EXPECT_THAT(refusal(point_with("sizes = [inf, 1]")), HasSubstr("must be finite"));
  EXPECT_THAT(refusal(point_with("sizes = [1, 1e-300]")), HasSubstr("from 1e-40 to 1e40"));
  EXPECT_THAT(refusal(point_with("sizes = [1, \"1\"]")), HasSubstr("must be a number"));
  EXPECT_THAT(refusal(point_with("sizes = [1, 1e-8]")), HasSubstr("a factor of 10000000"));
  EXPECT_THAT(refusal(point_with("radius = 0")), HasSubstr("`radius` must be positive"));
  EXPECT_THAT(refusal(point_with("growth = 1")), HasSubstr("`growth` must be more than 1"));
  EXPECT_THAT(refusal(point_with("growth = \"on\"")), HasSubstr("`growth`"));
  EXPECT_THAT(refusal(point_with("angle = 361")), HasSubstr("from -360 to 360"));
  EXPECT_THAT(refusal("size = 0\n" + point_with("radius = 1")), HasSubstr("`size`"));
}

TEST(PlaneSourcesFile, has_a_thousand_sources_at_most) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += point_with("radius = 1");
  EXPECT_EQ(refusal(text), "");
  EXPECT_THAT(refusal(text + point_with("radius = 1")),
              HasSubstr("s.toml:4001:1: more than 1000 sources"));
}

TEST(PlaneSourcesDocument, has_every_key) {
  std::ifstream file(std::filesystem::path(TETFARM_SOURCE_DIR) / "docs/adaptation.md");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  for (const std::string& key : plane_source_keys()) EXPECT_THAT(text, HasSubstr("`" + key + "`"));
}

}  // namespace
}  // namespace tetfarm
