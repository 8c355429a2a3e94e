// Sizes by a frequency, through the whole program to the mesh.
#include <gmock/gmock.h>

#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::digest_of;
using test::Ended;
using test::run_program;
using test::TemporaryFolder;
using ::testing::HasSubstr;

void write_ball(const std::filesystem::path& file) {
  test::write_contents(file, test::off_of(shapes::sphere({0, 0, 0}, 1, 2)));
}

TEST(RunForAFrequency, makes_the_mesh_of_the_equal_size) {
  const TemporaryFolder folder;
  write_ball(folder.path() / "ball.off");
  const auto run = [&](const std::string& output, std::vector<std::string> more) {
    std::vector<std::string> words = {"run", "ball.off", "-o", output, "--json"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = run_program(words, folder.path(), 60);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended;
  };
  const Ended by_size = run("by_size", {"--size", "0.1"});
  const Ended by_wave = run("by_wave", {"--frequency", "2kHz", "--wave-speed", "2000"});
  EXPECT_EQ(digest_of(by_wave), digest_of(by_size));
  EXPECT_NE(digest_of(by_wave), digest_of(run("plain", {})));
  EXPECT_THAT(by_wave.err, HasSubstr("size       0.1 (10 to a wavelength of 1)\n"));
}

}  // namespace
}  // namespace tetfarm
