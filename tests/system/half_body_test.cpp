// Half a body through the whole program, with its plane of symmetry.
#include <gmock/gmock.h>

#include "base/file_system.h"
#include "tests/mesh/half_body/half_shapes.h"
#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;

class RunOfHalfABody : public ::testing::Test {
 protected:
  RunOfHalfABody() {
    test::write_contents(folder_.path() / "half.off",
                         test::off_of(open_box({-1, 0, -1}, {1, 1, 1}, 6)));
  }
  Ended run(const std::vector<std::string>& more) {
    std::vector<std::string> words = {"run", "half.off",   "--outer", "box:3", "--symmetry",
                                      "y=0", "--progress", "none",    "--json"};
    words.insert(words.end(), more.begin(), more.end());
    return run_program(words, folder_.path());
  }
  nlohmann::json result_of_run(const std::vector<std::string>& more) {
    const Ended ended = run(more);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.code == 0 ? test::result_of(ended) : nlohmann::json();
  }

  TemporaryFolder folder_;
};

TEST_F(RunOfHalfABody, meshes_one_side_closed_by_the_plane_alike_with_any_workers) {
  const nlohmann::json one =
      result_of_run({"-o", "one", "-j", "1", "--subdomains", "4", "--format", "vtkhdf,lb8.ugrid"});
  const nlohmann::json two = result_of_run({"-o", "two", "-j", "2", "--subdomains", "4"});
  EXPECT_EQ(one["digest"], two["digest"]);
  EXPECT_NEAR(one["volume"].get<double>(), 6 * 3 * 6 - 4, 1e-9);
  EXPECT_EQ(read_file(folder_.path() / "one/half.mapbc"),
            "3\n1 3000 surface\n2 3000 outer_box\n3 6662 symmetry\n");
  const Ended quality = run_program({"quality", "one", "--json"}, folder_.path());
  EXPECT_EQ(quality.code, 0) << quality.err;
}

TEST_F(RunOfHalfABody, grows_layers_along_the_plane) {
  const nlohmann::json result =
      result_of_run({"-o", "out", "--layers", "surface:first=0.01,count=5"});
  EXPECT_NEAR(result["volume"].get<double>(), 6 * 3 * 6 - 4, 1e-9);
  EXPECT_GT(result["prisms"].get<double>(), 0);
  EXPECT_EQ(run_program({"quality", "out", "--json"}, folder_.path()).code, 0);
}

TEST_F(RunOfHalfABody, is_refused_with_a_place_where_it_does_not_end_on_the_plane) {
  const Ended ended =
      run_program({"check", "half.off", "--outer", "box", "--symmetry", "z=0"}, folder_.path());
  EXPECT_EQ(ended.code, 3);
  EXPECT_THAT(ended.err, HasSubstr("symmetry z=0: 22 vertices of 24 on open edges lie elsewhere"));
  EXPECT_EQ(run({"--remesh", "-o", "out"}).code, 2);
}

}  // namespace
}  // namespace tetfarm
