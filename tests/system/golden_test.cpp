// Meshes known by their digests: the same bytes on every machine, build and day. A change that is
// meant to change meshes runs this test once with UPDATE_GOLDEN=1 and commits
// tests/golden/digests.txt.
#include <gmock/gmock.h>

#include <cstdlib>
#include <map>

#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using test::TemporaryFolder;

const std::filesystem::path source_folder = TETFARM_SOURCE_DIR;
const std::filesystem::path golden_file = source_folder / "tests" / "golden" / "digests.txt";

using Digests = std::map<std::string, std::string>;

Digests golden_digests() {
  std::istringstream text(test::contents(golden_file));
  Digests digests;
  std::string name;
  std::string digest;
  while (text >> name >> digest) digests[name] = digest;
  return digests;
}

void write_golden(const Digests& digests) {
  std::ostringstream text;
  for (const auto& [name, digest] : digests) text << name << " " << digest << "\n";
  test::write_contents(golden_file, text.str());
}

class GoldenMesh : public ::testing::Test {
 protected:
  void expect_golden(const std::string& name, const std::string& input, int subdomains) {
    const Ended ended =
        run_program(test::run_words(input, name, 2, subdomains), folder_.path(), 300);
    ASSERT_EQ(ended.code, 0) << ended.err;
    ASSERT_EQ(test::digest_of(ended).size(), 32U);
    Digests digests = golden_digests();
    if (std::getenv("UPDATE_GOLDEN") != nullptr) {
      digests[name] = test::digest_of(ended);
      write_golden(digests);
      GTEST_SKIP() << "UPDATE_GOLDEN is set: written, and not compared";
    }
    EXPECT_EQ(test::digest_of(ended), digests[name]);
  }

  TemporaryFolder folder_;
};

TEST_F(GoldenMesh, of_the_cube_with_a_sphere_cut_out_uncut) {
  expect_golden("cube_sphere_1", source_folder / "examples/cube_sphere/cube_sphere.msh", 1);
}

TEST_F(GoldenMesh, of_the_cube_with_a_sphere_cut_out_in_four_parts) {
  expect_golden("cube_sphere_4", source_folder / "examples/cube_sphere/cube_sphere.msh", 4);
}

TEST_F(GoldenMesh, of_the_space_between_a_sphere_and_a_box_in_three_parts) {
  expect_golden("sphere_in_box_3", test::sphere_in_box(folder_.path(), 6, 2), 3);
}

}  // namespace
}  // namespace tetfarm
