// Edge lengths at patches, through the whole program to the mesh.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/support/shapes.h"
#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::digest_of;
using test::Ended;
using test::run_program;
using test::TemporaryFolder;

class RunWithPatchSizes : public ::testing::Test {
 protected:
  RunWithPatchSizes() {
    test::write_contents(folder_.path() / "ball.off",
                         test::off_of(shapes::sphere({0, 0, 0}, 1, 2)));
    test::write_contents(folder_.path() / "job.toml",
                         "name = \"ball\"\n[geometry]\nsurface = \"ball.off\"\n[domain]\nouter = "
                         "\"box\"\n[patch.surface]\nsize = 0.15\ngrowth = 0.2\n");
  }
  Ended run(std::vector<std::string> words) {
    words.insert(words.begin(), "run");
    words.insert(words.end(), {"--json", "--progress", "none"});
    const Ended ended = run_program(words, folder_.path(), 120);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended;
  }
  static double elements_of(const Ended& ended) {
    return nlohmann::json::parse(ended.out).at("elements").get<double>();
  }

  TemporaryFolder folder_;
};

TEST_F(RunWithPatchSizes, makes_the_same_mesh_with_any_workers_and_words) {
  const Ended one = run({"job.toml", "-j", "1", "--subdomains", "3", "-o", "one"});
  const Ended three = run({"job.toml", "-j", "3", "--subdomains", "3", "-o", "three"});
  const Ended typed = run({"ball.off", "--outer", "box", "--patch-size", "surf*=0.15:0.2", "-j",
                           "2", "--subdomains", "3", "-o", "typed"});
  EXPECT_EQ(digest_of(one), digest_of(three));
  EXPECT_EQ(digest_of(one), digest_of(typed));
}

TEST_F(RunWithPatchSizes, makes_as_many_elements_as_was_planned) {
  const Ended plain = run({"ball.off", "--outer", "box", "-o", "plain"});
  const Ended fine = run({"job.toml", "-o", "fine"});
  EXPECT_GT(elements_of(fine), 1.5 * elements_of(plain));
  const Ended plan = run_program({"plan", "job.toml", "--json"}, folder_.path(), 60);
  ASSERT_EQ(plan.code, 0) << plan.err;
  const double planned = nlohmann::json::parse(plan.out).at("estimated_elements").get<double>();
  EXPECT_NEAR(elements_of(fine), planned, 0.15 * planned);
}

}  // namespace
}  // namespace tetfarm
