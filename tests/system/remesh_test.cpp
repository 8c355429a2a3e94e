// Surfaces that are remeshed on the way, through the whole program.
#include <gmock/gmock.h>

#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::vector<std::string> with(std::vector<std::string> words,
                              const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(RunRemeshed, is_as_if_the_command_surface_had_come_first_with_any_number_of_workers) {
  const TemporaryFolder folder;
  test::write_contents(folder.path() / "bar.off",
                       test::off_of(shapes::box({0, 0, 0}, {1, 2, 3}, 1)));
  const Ended made =
      run_program({"surface", "bar.off", "-o", "even.off", "--size", "0.25"}, folder.path());
  ASSERT_EQ(made.code, 0) << made.err;
  const Ended apart = run_program(test::run_words("even.off", "apart", 2), folder.path());
  ASSERT_EQ(apart.code, 0) << apart.err;
  for (const int workers : {1, 3}) {
    const std::string output = "out" + std::to_string(workers);
    const Ended ended = run_program(
        with(test::run_words("bar.off", output, workers), {"--remesh", "--size-on-body", "0.25"}),
        folder.path());
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(test::digest_of(ended), test::digest_of(apart));
    EXPECT_GT(test::result_of(ended)["boundary_triangles"], 500) << "12 were given";
  }
  const Ended checked = run_program(
      {"check", "bar.off", "--remesh", "--size-on-body", "0.25", "--json"}, folder.path());
  ASSERT_EQ(checked.code, 0) << checked.err;
  const double estimated = test::result_of(checked)["estimated_elements"];
  const double got = test::result_of(apart)["elements"];
  EXPECT_GT(estimated, got / 2) << "of the remeshed surface";
  EXPECT_LT(estimated, 2 * got);
}

TEST(RunRemeshed, is_refused_in_the_words_of_who_typed_it) {
  const TemporaryFolder folder;
  SurfaceMesh open = shapes::box({0, 0, 0}, {1, 2, 3}, 1);
  open.triangles.pop_back();
  open.patch_of_triangle.pop_back();
  test::write_contents(folder.path() / "open.off", test::off_of(open));
  const Ended ended =
      run_program(with(test::run_words("open.off", "out", 1), {"--remesh"}), folder.path());
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("open.off: "));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "open.defects.vtp")) << ended.err;
  const Ended alone = run_program(
      with(test::run_words("open.off", "out", 1), {"--size-on-body", "1"}), folder.path());
  EXPECT_EQ(alone.code, 2);
  EXPECT_THAT(alone.err, StartsWith("error: --size-on-body: "));
}

}  // namespace
}  // namespace tetfarm
