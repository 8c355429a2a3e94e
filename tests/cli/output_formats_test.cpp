#include "cli/output_formats.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace tetfarm {
namespace {

using ::testing::StartsWith;

std::string refusal_of(const std::vector<std::string>& formats) {
  try {
    require_known_formats(formats);
    return "";
  } catch (const UsageError& error) {
    return error.what();
  }
}

TEST(OutputFormats, are_known_and_named_once) {
  EXPECT_EQ(refusal_of({}), "");
  EXPECT_EQ(refusal_of({"vtkhdf", "lb8.ugrid", "su2", "openfoam"}), "");
  EXPECT_EQ(refusal_of({"su2", "vtkhdf", "su2"}), "--format su2: is given twice");
  EXPECT_EQ(refusal_of({"vtkhdf", "su3"}), "--format su3: unknown format; did you mean `su2`?");
  EXPECT_THAT(refusal_of({"something"}),
              StartsWith("--format something: unknown format; known are vtkhdf, lb8.ugrid, "));
}

}  // namespace
}  // namespace tetfarm
