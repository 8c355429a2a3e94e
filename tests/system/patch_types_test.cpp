// What a job says of its patches, from the job file to the files of solvers.
#include <gmock/gmock.h>

#include "base/file_system.h"
#include "tests/support/shapes.h"
#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;

class RunWithPatchTypes : public ::testing::Test {
 protected:
  RunWithPatchTypes() {
    test::write_contents(folder_.path() / "ball.off",
                         test::off_of(shapes::sphere({0, 0, 0}, 1, 2)));
  }
  Ended run(std::vector<std::string> words) {
    words.insert(words.begin(), "run");
    words.insert(words.end(), {"--progress", "none"});
    return run_program(words, folder_.path());
  }
  std::string text(const std::string& file) { return read_file(folder_.path() / file); }

  TemporaryFolder folder_;
};

TEST_F(RunWithPatchTypes, writes_them_into_all_formats_of_the_job) {
  test::write_contents(
      folder_.path() / "job.toml",
      "name = \"ball\"\n[geometry]\nsurface = \"ball.off\"\n[domain]\nouter = \"box\"\n"
      "[patch.surface]\ntype = \"wall\"\n[patch.\"outer*\"]\ntype = \"farfield\"\n"
      "[decompose]\nsubdomains = 2\n"
      "[output]\nformats = [\"vtkhdf\", \"lb8.ugrid\", \"openfoam\", \"su2\"]\n");
  const Ended ended = run({"job.toml", "-o", "out"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(text("out/ball.mapbc"), "2\n1 4000 surface\n2 5000 outer_box\n");
  EXPECT_THAT(text("out/ball.openfoam/constant/polyMesh/boundary"),
              HasSubstr("surface\n    {\n        type            wall;"));
  EXPECT_THAT(text("out/ball.cfg"), HasSubstr("MARKER_FAR= ( outer_box )"));
  const Ended exported = run_program({"export", "out", "-o", "again.b8.ugrid"}, folder_.path());
  ASSERT_EQ(exported.code, 0) << exported.err;
  EXPECT_EQ(text("again.mapbc"), text("out/ball.mapbc"));
}

TEST_F(RunWithPatchTypes, refuses_a_patch_that_there_is_not_before_anything_runs) {
  const Ended ended = run({"ball.off", "--patch-type", "bal=wall", "-o", "out"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err,
              HasSubstr("--patch-type 'bal=wall': \"bal\" matches no patch: the surface has "
                        "only \"surface\""));
}

}  // namespace
}  // namespace tetfarm
