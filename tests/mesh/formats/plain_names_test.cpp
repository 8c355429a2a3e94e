#include "mesh/formats/plain_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;

TEST(PlainNames, replaces_what_is_not_plain) {
  EXPECT_THAT(plain_names({"wing upper", "a/b", ""}, 32), ElementsAre("wing_upper", "a_b", "_"));
}

TEST(PlainNames, are_short_and_differ) {
  EXPECT_THAT(plain_names({"abcdef", "abcdeg", "abc de"}, 5),
              ElementsAre("abcde", "abc_2", "abc_d"));
  EXPECT_THAT(plain_names({"Zone", "a b", "a_b"}, 32, {"Zone"}),
              ElementsAre("Zone_2", "a_b", "a_b_2"));
}

}  // namespace
}  // namespace tetfarm
