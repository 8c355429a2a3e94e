#include "worker/patch_globs.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(PatchGlobs, match_all_of_a_text) {
  for (const char* glob :
       {"wing", "*", "w*", "*g", "w*g", "w**g", "????", "w?ng", "*in*", "wing*"}) {
    EXPECT_TRUE(matches_glob(glob, "wing")) << glob;
  }
  for (const char* glob : {"", "win", "wingx", "ing", "?", "?????", "w*x", "*win", "W*"}) {
    EXPECT_FALSE(matches_glob(glob, "wing")) << glob;
  }
  EXPECT_TRUE(matches_glob("*ab*ab", "aabab_abab")) << "the last star may take more";
  EXPECT_TRUE(matches_glob("", ""));
  EXPECT_TRUE(matches_glob("**", ""));
  EXPECT_FALSE(matches_glob("?", ""));
}

TEST(PatchGlobs, take_a_letter_of_several_bytes_for_one) {
  EXPECT_TRUE(matches_glob("?", "ü"));
  EXPECT_FALSE(matches_glob("??", "ü"));
  EXPECT_FALSE(matches_glob("*??", "ü"));
  EXPECT_TRUE(matches_glob("fl?gel_*", "flügel_links"));
}

TEST(PatchGlobs, of_many_stars_do_not_take_long) {
  std::string glob;
  for (int i = 0; i < 120; ++i) glob += "*a";
  EXPECT_FALSE(matches_glob(glob + "b", std::string(10'000, 'a')));
}

}  // namespace
}  // namespace tetfarm
