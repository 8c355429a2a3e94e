#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/job_file/job_file.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

JobFile job_with_source(const std::string& source) {
  return parse_job_file("[geometry]\nsurface = \"a.stl\"\n[[source]]\n" + source, "a.toml");
}

std::string refusal_of_source(const std::string& source) {
  return error_text_of<UsageError>([&] { job_with_source(source); });
}

TEST(SolidSourcesOfAJob, are_boxes_cylinders_and_spheres) {
  const JobSource box =
      job_with_source(
          "kind = \"box\"\nlow = [0, 1, 2]\nhigh = [3, 4, 5]\nspacing = 0.1\nouter = 2\n")
          .sources[0];
  EXPECT_EQ(box.shape, JobSource::Shape::box);
  EXPECT_EQ(box.corners[1].at, (Vec3{3, 4, 5}));
  EXPECT_EQ(box.corners[1].inner, 0);
  EXPECT_EQ(box.corners[1].outer, 2);
  EXPECT_EQ(box.line, 3);
  const JobSource cone = job_with_source(
                             "kind = \"cylinder\"\nfrom = [0, 0, 0]\nto = [1, 0, 0]\nradius = "
                             "[0.5, 0]\nspacing = 1\nouter = 1\n")
                             .sources[0];
  EXPECT_EQ(cone.shape, JobSource::Shape::cylinder);
  EXPECT_EQ(cone.radii, (std::array<double, 2>{0.5, 0}));
  const JobSource sphere =
      job_with_source("kind = \"sphere\"\nat = [0, 0, 1]\nradius = 2\nspacing = 0.1\nouter = 3\n")
          .sources[0];
  ASSERT_EQ(sphere.corners.size(), 1U);
  EXPECT_EQ(sphere.corners[0].inner, 2);
  EXPECT_EQ(sphere.corners[0].outer, 5) << "counted from the sphere";
}

TEST(SolidSourcesOfAJob, are_the_same_after_canonical_text) {
  const JobFile job = job_with_source(
      "kind = \"box\"\nlow = [0, 1, 2]\nhigh = [3, 4, 5]\nspacing = 0.1\nouter = 2\n"
      "[[source]]\nkind = \"cylinder\"\nfrom = [0, 0, 0]\nto = [1, 0, 0]\nradius = 0.3\nspacing = "
      "1\nouter = 1\n");
  const std::string text = to_toml(job);
  EXPECT_EQ(to_toml(parse_job_file(text, "b.toml")), text);
  EXPECT_THAT(text, HasSubstr("radius = [0.3, 0.3]"));
}

TEST(SolidSourcesOfAJob, are_refused_where_they_make_no_sense) {
  EXPECT_THAT(refusal_of_source(
                  "kind = \"box\"\nlow = [0, 1, 2]\nhigh = [3, 0, 5]\nspacing = 0.1\nouter = 2\n"),
              HasSubstr("`high` must not be below `low` along any axis"));
  EXPECT_THAT(refusal_of_source(
                  "kind = \"box\"\nlow = [0, 1]\nhigh = [3, 4, 5]\nspacing = 0.1\nouter = 2\n"),
              HasSubstr("`low` must have three coordinates"));
  EXPECT_THAT(refusal_of_source("kind = \"box\"\nlow = [0, 1, 2]\nhigh = [3, 4, 5]\nspacing = "
                                "0.1\ninner = 1\nouter = 2\n"),
              HasSubstr("unknown key `inner`"));
  EXPECT_THAT(refusal_of_source("kind = \"cylinder\"\nfrom = [0, 0, 0]\nto = [0, 0, 0]\nradius = "
                                "1\nspacing = 1\nouter = 1\n"),
              HasSubstr("`to` must not be the same point as `from`"));
  EXPECT_THAT(refusal_of_source("kind = \"cylinder\"\nfrom = [0, 0, 0]\nto = [1, 0, 0]\nradius = "
                                "[0, 0]\nspacing = 1\nouter = 1\n"),
              HasSubstr("must not be negative, nor 0 at both ends"));
  EXPECT_THAT(refusal_of_source("kind = \"sphere\"\nat = [0, 0, 0]\nspacing = 1\nouter = 1\n"),
              HasSubstr("`radius` is missing"));
}

}  // namespace
}  // namespace tetfarm
