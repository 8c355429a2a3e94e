// Job files that `init` wrote, through the whole program to the mesh.
#include <gmock/gmock.h>

#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::contents;
using test::digest_of;
using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::StartsWith;

void write_ball(const std::filesystem::path& file) {
  test::write_contents(file, test::off_of(shapes::sphere({0, 0, 0}, 1, 2)));
}

TEST(RunProposedJob, makes_the_mesh_of_the_surface_alone) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "in");
  std::filesystem::create_directories(folder.path() / "jobs/ball");
  write_ball(folder.path() / "in/ball.off");
  const Ended plain =
      run_program({"run", "in/ball.off", "-o", "plain", "--json"}, folder.path(), 60);
  ASSERT_EQ(plain.code, 0) << plain.err;
  for (const std::string file : {"ball.toml", "jobs/ball/job.toml"}) {
    const Ended made = run_program({"init", "in/ball.off", "-o", file}, folder.path());
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(made.out, file + "\n");
    const std::string output = "out_" + std::to_string(file.size());
    const Ended ended = run_program({"run", file, "-o", output, "--json"}, folder.path(), 60);
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(digest_of(ended), digest_of(plain)) << file;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / output / "ball.vtkhdf"));
  }
}

TEST(RunProposedJob, can_be_printed_and_never_replaces_a_file_unasked) {
  const TemporaryFolder folder;
  write_ball(folder.path() / "ball.off");
  const Ended printed = run_program({"init", "ball.off", "-o", "-"}, folder.path());
  EXPECT_THAT(printed.out, HasSubstr("\nsurface = \"ball.off\"\n"));
  EXPECT_EQ(printed.err, "");
  test::write_contents(folder.path() / "ball.toml", "mine");
  const Ended refused = run_program({"init", "ball.off"}, folder.path());
  EXPECT_EQ(refused.code, 2);
  EXPECT_EQ(refused.err,
            "error: ball.toml exists already\n"
            "help: give another file with -o, or --force to replace it\n");
  EXPECT_EQ(contents(folder.path() / "ball.toml"), "mine");
  EXPECT_EQ(run_program({"init", "ball.off", "--force"}, folder.path()).code, 0);
  EXPECT_THAT(contents(folder.path() / "ball.toml"), StartsWith("# "));
}

}  // namespace
}  // namespace tetfarm
