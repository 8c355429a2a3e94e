#include "base/text_lines.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(TextLines, are_without_their_ends_and_may_be_empty) {
  EXPECT_THAT(lines_of_text("a\n\nb\n"), ElementsAre("a", "", "b"));
  EXPECT_THAT(lines_of_text("a\nb"), ElementsAre("a", "b"));
  EXPECT_THAT(lines_of_text(""), IsEmpty());
}

}  // namespace
}  // namespace tetfarm
