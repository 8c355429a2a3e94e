// Surfaces of several regions through the whole program.
#include <gmock/gmock.h>

#include <cstdlib>
#include <map>

#include "tests/support/voxel_surface.h"
#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(RunWithRegions, names_meshes_and_draws_them) {
  const TemporaryFolder folder;
  const auto cubes =
      shapes::voxel_surface({{4, 2, 2}, [](int x, int, int) { return x < 2 ? 1 : 2; }});
  test::write_contents(folder.path() / "cubes.off", test::off_of(cubes.surface));
  test::write_contents(folder.path() / "job.toml",
                       "[geometry]\nsurface = \"cubes.off\"\n[[region]]\nat = [0.5, 0.5, 0.6]\n"
                       "name = \"steel\"\n[spacing]\ndefault = 0.5\n[output]\n"
                       "formats = [\"vtkhdf\", \"lb8.ugrid\"]\n");
  const Ended ended = run_program(test::run_words("job.toml", "out", 2, 1), folder.path());
  ASSERT_EQ(ended.code, 0) << ended.err;
  const nlohmann::json result = test::result_of(ended);
  ASSERT_EQ(result["regions"].size(), 2U);
  EXPECT_EQ(result["regions"][0]["name"], "steel");
  EXPECT_EQ(result["regions"][1]["name"], "region 2");
  EXPECT_NEAR(result["regions"][0]["volume"].get<double>(), 8, 1e-9);
  const std::int64_t first = result["regions"][0]["elements"];
  const std::int64_t second = result["regions"][1]["elements"];
  EXPECT_EQ(first + second, result["elements"]);
  EXPECT_TRUE(result["near_cuts"].is_null()) << "an interface is no cut";
  EXPECT_EQ(test::contents(folder.path() / "out" / "job.regions"),
            "1 1 " + std::to_string(first) + " steel\n2 " + std::to_string(first + 1) + " " +
                std::to_string(first + second) + " region 2\n");

  const Ended quality = run_program({"quality", "out", "--json"}, folder.path());
  ASSERT_EQ(quality.code, 0) << quality.err;
  const nlohmann::json report = test::result_of(quality);
  EXPECT_EQ(report["digest"], result["digest"]);
  EXPECT_EQ(report["regions"][1]["shapes"]["elements"], second);
  EXPECT_EQ(report["regions"][0]["name"], "steel");

  const Ended drawn = run_program(
      {"render", "out", "-o", "p.png", "--view", "cut", "--colour", "region", "--size", "80x60"},
      folder.path());
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  EXPECT_THAT(test::contents(folder.path() / "p.png"), StartsWith("\x89PNG"));
  const Ended refused =
      run_program({"render", "out", "-o", "p.png", "--size", "80"}, folder.path());
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--size: \"80\" is not WIDTHxHEIGHT"));
}

TEST(RunWithRegions, says_which_point_names_none) {
  const TemporaryFolder folder;
  test::write_contents(folder.path() / "cube.off", test::off_of(shapes::unit_cube()));
  test::write_contents(folder.path() / "job.toml",
                       "[geometry]\nsurface = \"cube.off\"\n[[region]]\nat = [5, 0.5, 0.5]\n");
  const Ended checked = run_program({"check", "job.toml"}, folder.path());
  EXPECT_EQ(checked.code, 2);
  EXPECT_THAT(checked.err, HasSubstr("region.at: the point (5, 0.5, 0.5) is outside"));
  const Ended run = run_program(test::run_words("job.toml", "out", 1), folder.path());
  EXPECT_EQ(run.code, 2) << run.err;
}

TEST(RunWithRegions, of_a_real_part_gives_the_same_mesh_with_any_number_of_workers) {
  const char* data = std::getenv("TETFARM_DATA");
  if (data == nullptr) GTEST_SKIP() << "TETFARM_DATA is not set";
  const std::string input = std::string(data) + "/gmsh_piece_4vol/gmsh_piece_4vol.msh";
  const std::map<int, int> wanted2got = {{1, 4}, {4, 4}, {16, 16}};
  for (const auto& [wanted, got] : wanted2got) {
    std::string digest;
    for (const int workers : {1, 3}) {
      const TemporaryFolder folder;
      const Ended ended =
          run_program(test::run_words(input, "out", workers, wanted), folder.path(), 300);
      ASSERT_EQ(ended.code, 0) << ended.err;
      const nlohmann::json result = test::result_of(ended);
      EXPECT_EQ(result["subdomains"], got);
      EXPECT_EQ(result["regions"].size(), 4U);
      EXPECT_GT(result["min_dihedral_deg"], 20);
      EXPECT_EQ(run_program({"quality", "out"}, folder.path()).code, 0);
      if (digest.empty()) digest = test::digest_of(ended);
      EXPECT_EQ(test::digest_of(ended), digest);
    }
  }
}

TEST(RunWithRegions, leaves_of_different_regions_are_never_joined) {
  const char* data = std::getenv("TETFARM_DATA");
  if (data == nullptr) GTEST_SKIP() << "TETFARM_DATA is not set";
  const std::string input = std::string(data) + "/gmsh_piece_4vol/gmsh_piece_4vol.msh";
  const std::map<int, int> wanted2got = {{1, 4}, {6, 6}};
  for (const auto& [wanted, got] : wanted2got) {
    const TemporaryFolder folder;
    std::vector<std::string> words = test::run_words(input, "out", 2, 24);
    words.insert(words.end(), {"--groups", std::to_string(wanted)});
    const Ended ended = run_program(words, folder.path(), 300);
    ASSERT_EQ(ended.code, 0) << ended.err;
    const nlohmann::json result = test::result_of(ended);
    EXPECT_EQ(result["balance"]["leaves"], 24);
    EXPECT_EQ(result["subdomains"], got);
    EXPECT_EQ(result["regions"].size(), 4U);
    EXPECT_EQ(run_program({"quality", "out"}, folder.path()).code, 0);
  }
}

}  // namespace
}  // namespace tetfarm
