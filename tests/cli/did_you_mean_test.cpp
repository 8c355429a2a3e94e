#include "cli/did_you_mean.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(DidYouMean, names_the_nearest_word_or_none) {
  EXPECT_EQ(did_you_mean("runn", {"check", "run"}), "; did you mean `run`?");
  EXPECT_EQ(did_you_mean("quality", {"check", "run"}), "");
  EXPECT_EQ(did_you_mean("run", {}), "");
}

}  // namespace
}  // namespace tetfarm
