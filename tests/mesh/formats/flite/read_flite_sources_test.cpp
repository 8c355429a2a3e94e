#include "mesh/formats/flite/read_flite_sources.h"

#include <gmock/gmock.h>

#include "base/error.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::ThrowsMessage;

constexpr const char* background =
    "a title\n1 0 1 1 1 and more\n1 0 0 0\n1 0 0 2.5\n0 1 0 2.5\n0 0 1 2.5d0\n";
constexpr const char* sources =
    "* points\n1 nose\n1 2 3 0.1 0.2 0.4 remark\n"
    "* lines\n1\n0 0 0 0.1D-1 0.2 0.4\n1 0 0 0.2 0.3 0.5\n"
    "* triangles\n1\n0 0 0 0.1 0.2 0.4\n1 0 0 0.1 0.2 0.4\n0 1 0 0.3 0.2 0.4\n";

auto reading(const std::string& text) {
  return [text] { read_flite_sources(text, "a.ba3"); };
}

TEST(ReadFliteSources, has_points_lines_triangles_and_the_background) {
  const FliteSources read = read_flite_sources(std::string(background) + sources, "a.ba3");
  EXPECT_EQ(read.background, 2.5);
  ASSERT_THAT(read.sources, SizeIs(3));
  ASSERT_THAT(read.sources[0].corners, SizeIs(1));
  EXPECT_EQ(read.sources[0].corners[0].at, (Vec3{1, 2, 3}));
  EXPECT_EQ(read.sources[0].corners[0].spacing, 0.1);
  EXPECT_EQ(read.sources[0].corners[0].inner, 0.2);
  EXPECT_EQ(read.sources[0].corners[0].outer, 0.4);
  ASSERT_THAT(read.sources[1].corners, SizeIs(2));
  EXPECT_EQ(read.sources[1].corners[0].spacing, 0.01) << "exponents may be Fortran's";
  EXPECT_EQ(read.sources[1].corners[1].outer, 0.5);
  ASSERT_THAT(read.sources[2].corners, SizeIs(3));
  EXPECT_EQ(read.sources[2].corners[2].spacing, 0.3);
}

TEST(ReadFliteSources, may_have_no_background_and_end_after_its_last_source) {
  const FliteSources read =
      read_flite_sources("t\n0 0 1 0 0\n* points\n1\n1 2 3 0.1 0.2 0.4\n", "a.ba3");
  EXPECT_EQ(read.background, 0);
  EXPECT_THAT(read.sources, SizeIs(1));
  EXPECT_THAT(read_flite_sources("t\n0 0 0 0 0\n", "a.ba3").sources, IsEmpty());
}

TEST(ReadFliteSources, names_the_line_of_what_it_refuses) {
  EXPECT_THAT(reading("t\n0 0 1 0\n"), ThrowsMessage<InvalidInput>(HasSubstr("a.ba3:")));
  EXPECT_THAT(reading("t\n0 0 -1 0 0\n"), ThrowsMessage<InvalidInput>(HasSubstr("a.ba3:2:")));
  EXPECT_THAT(reading("t\n0 0 1 0 0\n*\n1\n1 2 3 0.1 0.2\n4 5 6 7 8 9\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.ba3:5:")));
  EXPECT_THAT(reading("t\n0 0 1 0 0\n*\n1\n1 2 3 0 0.2 0.4\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.ba3:5: a spacing must be more than 0")));
  EXPECT_THAT(reading("t\n0 0 1 0 0\n*\n1\n1 2 3 0.1 0.5 0.4\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.ba3:5: the outer radius")));
  EXPECT_THAT(reading("t\n0 0 1 0 0\n*\n1\n1 2 nan 0.1 0.2 0.4\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.ba3:5:")));
  EXPECT_THAT(reading("t\n0 0 2 0 0\n*\n1\n1 2 3 0.1 0.2 0.4\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("too early")));
}

TEST(ReadFliteSources, refuses_a_background_that_varies) {
  EXPECT_THAT(reading("t\n1 0 0 0 0\n1 0 0 0\n1 0 0 1\n0 1 0 2\n0 0 1 1\n"),
              ThrowsMessage<InvalidInput>(HasSubstr("a.ba3:5: the background's spacing varies")));
}

}  // namespace
}  // namespace tetfarm
