#include "mesh/formats/tetgen/tetgen_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/mesh/formats/refusal.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;

/// One tet whose numbers begin with `first`; `ele` instead of the right file of tets.
std::string refusal(int first, const std::string& ele) {
  const TempFolder folder;
  std::string nodes = "# nodes\n4 3 0 0\n";
  for (const auto* place : {" 0 0 0\n", " 1 0 0\n", " 0 1 0\n", " 0 0 1\n"}) {
    nodes += std::to_string(first++) + place;
  }
  write_file_atomically(folder.path() / "a.node", nodes);
  write_file_atomically(folder.path() / "a.face", "0 1\n");
  write_file_atomically(folder.path() / "a.ele", ele);
  try {
    const NumberedPart part = open_mesh(folder.path() / "a.node", folder.path())->part(0);
    EXPECT_EQ(part.tets, (std::vector<Tet>{{0, 1, 2, 3}}));
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(TetgenSource, numbers_begin_with_that_of_the_first_node) {
  EXPECT_EQ(refusal(0, "1 4 0\n0 0 1 2 3\n"), "");
  EXPECT_EQ(refusal(1, "1 4 0\n1 1 2 3 4\n"), "");
}

TEST(TetgenSource, names_the_file_and_line_of_what_is_wrong) {
  EXPECT_THAT(refusal(0, "1 4 0\n0 0 1 2\n"), HasSubstr("a.ele:2: "));
  EXPECT_THAT(refusal(0, "1 10 0\n"), HasSubstr("a.ele:1: "));
  EXPECT_THAT(refusal(0, "99999 4 0\n0 0 1 2 3\n"), HasSubstr("a count of 99999"));
  EXPECT_THAT(refusal(0, "1 4 0\n1 0 1 2 3\n"), HasSubstr("expected record 0"));
  EXPECT_THAT(refusal(1, "1 4 0\n1 0 1 2 3\n"), HasSubstr("has node -1"));
}

}  // namespace
}  // namespace tetfarm
