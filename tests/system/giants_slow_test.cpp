// The thesis's three largest meshes (5.2), as examples/giants has them, with a thousandth of their
// elements and as many sub-domains as at full size.
#include <gmock/gmock.h>

#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using test::TemporaryFolder;

const std::filesystem::path examples = std::filesystem::path(TETFARM_SOURCE_DIR) / "examples";

class Giants : public ::testing::Test {
 protected:
  void make_surface(const std::vector<std::string>& words) {
    const Ended made = run_program(words, folder_.path());
    ASSERT_EQ(made.code, 0) << made.err;
  }

  nlohmann::json run(const std::string& job, const std::string& output, int workers,
                     const std::vector<std::string>& more) {
    std::filesystem::copy_file(examples / "giants" / job, folder_.path() / job,
                               std::filesystem::copy_options::overwrite_existing);
    std::vector<std::string> words = {
        "run", job, "-o", output, "-j", std::to_string(workers), "--json", "--progress", "none"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = run_program(words, folder_.path(), 600);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return test::result_of(ended);
  }

  /// What three workers made, once it is known to be sound, and to be what one makes.
  nlohmann::json meshed_twice(const std::string& job, const std::vector<std::string>& more) {
    nlohmann::json result = run(job, "three", 3, more);
    const Ended checked = run_program({"quality", "three", "--json"}, folder_.path(), 300);
    EXPECT_EQ(checked.code, 0) << checked.err;
    const nlohmann::json quality = test::result_of(checked);
    EXPECT_EQ(quality["valid"], true);
    EXPECT_EQ(quality["digest"], result["digest"]);
    EXPECT_EQ(run(job, "one", 1, more)["digest"], result["digest"]);
    return result;
  }

  TemporaryFolder folder_;
};

TEST_F(Giants, the_duct_is_meshed_in_128_subdomains) {
  make_surface({"shape", "s-duct", "--spacing", "0.033", "-o", "duct.stl"});
  const nlohmann::json result = meshed_twice("duct.toml", {"--size", "0.033"});
  EXPECT_EQ(result["subdomains"], 128);
  EXPECT_NEAR(result["elements"].get<double>(), 250e3, 50e3);
  EXPECT_GT(result["min_dihedral_deg"], 10);
}

TEST_F(Giants, the_trihedral_cavity_is_meshed_in_63_subdomains_and_its_absorbing_layers) {
  make_surface({"shape", "trihedral", "--spacing", "0.015", "-o", "trihedral.stl"});
  const nlohmann::json result =
      meshed_twice("trihedral.toml", {"--size", "0.015", "--pml", "outer:layers=1"});
  EXPECT_GE(result["subdomains"], 63 + 1) << "with the chunks of the layers";
  const double elements = result["elements"];
  EXPECT_NEAR(elements, 980e3, 150e3);
  EXPECT_NEAR(result["pml"]["cells"].get<double>() / elements, 100.0 / 980, 0.03);
  EXPECT_GT(result["min_dihedral_deg"], 10);
}

TEST_F(Giants, the_aircraft_is_meshed_in_128_subdomains_and_its_absorbing_layers) {
  make_surface({"convert", examples / "d150_aircraft/d150_aircraft.msh.gz", "falcon.stl", "--scale",
                "0.5295", "--max-edge", "0.5", "--box", "0.3", "--box-size", "0.355"});
  const nlohmann::json result =
      meshed_twice("falcon.toml", {"--size", "0.355", "--pml", "outer:layers=1"});
  EXPECT_GE(result["subdomains"], 128 + 1) << "with the chunks of the layers";
  EXPECT_EQ(result["pml"]["layers"], 1);
  EXPECT_EQ(result["pml"]["tets"], 3 * result["pml"]["outer_triangles"].get<std::int64_t>());
  // The aircraft's own triangles, which are finer than a thousandth asks for, have most of them.
  EXPECT_GT(result["elements"], 500'000);
  EXPECT_GT(result["unforced"]["min_dihedral_deg"], 5);
}

}  // namespace
}  // namespace tetfarm
