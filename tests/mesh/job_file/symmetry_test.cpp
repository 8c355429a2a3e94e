#include <gmock/gmock.h>

#include "base/error.h"
#include "mesh/job_file/job_file.h"
#include "tests/support/error_text.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

TEST(Symmetry, is_read_from_a_letter_and_a_number) {
  EXPECT_EQ(parse_symmetry("y=0"), (AxisPlane{1, 0}));
  EXPECT_EQ(parse_symmetry(" x = -1.5e-3 "), (AxisPlane{0, -1.5e-3}));
  EXPECT_EQ(parse_symmetry("z=10"), (AxisPlane{2, 10}));
  for (const char* wrong :
       {"", "y", "y=", "=0", "yy=0", "w=0", "y=0m", "y=inf", "y=nan", "y=1,2"}) {
    EXPECT_FALSE(parse_symmetry(wrong)) << wrong;
  }
}

TEST(Symmetry, of_a_job_is_the_same_after_canonical_text) {
  const std::string text =
      "[geometry]\nsurface = \"a.stl\"\n[domain]\nouter = \"box\"\nsymmetry = \"z=0.1\"\n";
  const JobFile job = parse_job_file(text, "a.toml");
  EXPECT_EQ(job.symmetry, (AxisPlane{2, 0.1}));
  EXPECT_EQ(parse_job_file(to_toml(job), "b.toml").symmetry, job.symmetry);
  EXPECT_EQ(to_toml(parse_job_file("[geometry]\nsurface = \"a.stl\"\n", "a.toml")).find("symmetry"),
            std::string::npos);
}

TEST(Symmetry, is_refused_with_what_it_cannot_be_together_with) {
  const auto refusal = [](const std::string& more) {
    return error_text_of<UsageError>([&] {
      parse_job_file("[geometry]\nsurface = \"a.stl\"\n[domain]\nsymmetry = " + more, "a.toml");
    });
  };
  EXPECT_EQ(refusal("\"y\"\n"), "a.toml:4:12: `symmetry` must be a plane such as \"y=0\"");
  EXPECT_THAT(refusal("\"y=0\"\n[surface]\nremesh = true\n"),
              HasSubstr("`symmetry` cannot be given together with remeshing"));
  EXPECT_THAT(refusal("\"y=0\"\n[[pml]]\npatches = [\"*\"]\n"),
              HasSubstr("cannot be given together with absorbing layers whose corners are mitres"));
}

TEST(Symmetry, goes_together_with_absorbing_layers_in_blocks) {
  const JobFile job = parse_job_file(
      "[geometry]\nsurface = \"a.stl\"\n[domain]\nsymmetry = \"y=0\"\n"
      "[[pml]]\npatches = [\"*\"]\ncorners = \"block\"\n",
      "a.toml");
  EXPECT_TRUE(job.symmetry && job.pml);
}

}  // namespace
}  // namespace tetfarm
