#include "mesh/formats/list/format_by_ending.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace tetfarm {
namespace {

Format format_of(std::string_view name, std::array<std::string_view, 2> endings) {
  Format format;
  format.name = name;
  format.endings = endings;
  return format;
}

TEST(FormatByEnding, is_the_wanted_one_with_the_longest_ending_at_the_end_of_the_name) {
  const std::array<Format, 3> formats = {format_of("one", {".a"}), format_of("two", {".b.a", ".c"}),
                                         format_of("three", {".b.a"})};
  const auto found = [&](std::string_view name, bool (*is_wanted)(const Format& format)) {
    const Format* format = format_by_ending(formats, name, is_wanted);
    return format == nullptr ? std::string("none") : std::string(format->name);
  };
  const auto any = [](const Format&) { return true; };
  EXPECT_EQ(found("wing.a", any), "one");
  EXPECT_EQ(found("wing.b.a", any), "two") << "the first of two that are as long";
  EXPECT_EQ(found("wing.c", any), "two");
  EXPECT_EQ(found("wing.a.c", any), "two");
  EXPECT_EQ(found("wing.a.old", any), "none");
  EXPECT_EQ(found("wing.A", any), "one") << "endings have no case";
  EXPECT_EQ(found("wing.B.a", any), "two");
  EXPECT_EQ(found("", any), "none");
  EXPECT_EQ(found("wing.b.a", [](const Format& format) { return format.name != "two"; }), "three");
  EXPECT_EQ(found("wing.c", [](const Format& format) { return format.name != "two"; }), "none");
}

}  // namespace
}  // namespace tetfarm
