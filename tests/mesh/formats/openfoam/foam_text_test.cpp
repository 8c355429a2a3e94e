#include "mesh/formats/openfoam/foam_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file_system.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string head = "FoamFile { version 2.0; format ascii; class labelList; object a; }\n";

/// What `read` says of the text, behind a header of one line.
template <class Read>
std::string refusal(const std::string& text, const Read& read) {
  const TempFolder folder;
  write_file_atomically(folder.path() / "a", text);
  try {
    FoamText file(folder.path() / "a");
    read(file);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> tokens_of(const std::string& text) {
  std::vector<std::string> tokens;
  EXPECT_EQ(refusal(head + text + " END",
                    [&](FoamText& file) {
                      for (std::string token; token = file.token(), token != "END";) {
                        tokens.push_back(token);
                      }
                    }),
            "");
  return tokens;
}

TEST(FoamText, marks_stand_for_themselves_with_blanks_or_without) {
  EXPECT_THAT(tokens_of("3(0 1\n2){ a b;}"),
              ElementsAre("3", "(", "0", "1", "2", ")", "{", "a", "b", ";", "}"));
  EXPECT_THAT(tokens_of("\"a b; {\" \"c\";"), ElementsAre("\"a b; {\"", "\"c\"", ";"));
}

TEST(FoamText, passes_over_comments_and_the_banner) {
  EXPECT_THAT(tokens_of("1 // 2 (\n3 /* 4\n5 */6;// 7\n//\n/**/8 a/b"),
              ElementsAre("1", "3", "6", ";", "8", "a/b"));
  EXPECT_EQ(refusal("/*------*- C++ -*------*\\\n|  =====  |  a; {\n\\*--------*/\n" + head +
                        "// * * * //\n1\n(\n7)\n// *** //\n",
                    [](FoamText& file) {
                      EXPECT_EQ(file.begin_list(1), 1);
                      EXPECT_EQ(file.label(8), 7);
                      file.end_list();
                    }),
            "");
}

TEST(FoamText, dictionaries_give_their_entries_and_pass_over_those_inside) {
  std::vector<std::string> entries;
  const auto read = [&](FoamText& file) {
    file.read_dictionary([&](std::string_view key, std::string_view value) {
      entries.push_back(std::string(key) + "=" + std::string(value));
      if (key != "list") return false;
      EXPECT_EQ(file.label(5), 4);
      file.expect(";");
      return true;
    });
    file.expect("END");
  };
  EXPECT_EQ(
      refusal(head + "{ a 1; b { c 2; d { e 3; } } f 1(wall); list of 4; g \"};\"; } END", read),
      "");
  EXPECT_THAT(entries, ElementsAre("a=1", "b={", "f=1", "list=of", "g=\"};\""));
  EXPECT_THAT(refusal(head + "{ a 1 } } ; } END", read), HasSubstr("expected ;, found }"));
}

TEST(FoamText, refuses_what_is_binary_or_has_no_header) {
  const auto nothing = [](FoamText&) {};
  EXPECT_THAT(refusal("FoamFile { format binary; }", nothing), HasSubstr("a:1: only text"));
  EXPECT_THAT(refusal("FoamFile { version 2.0; }", nothing), HasSubstr("has no format"));
  EXPECT_THAT(refusal("1 ( 2 )", nothing), HasSubstr("expected FoamFile"));
  EXPECT_THAT(refusal("", nothing), HasSubstr("ends too early"));
}

TEST(FoamText, names_the_line_of_what_is_wrong) {
  const auto list = [](FoamText& file) {
    for (std::int64_t left = file.begin_list(1); left > 0; --left) file.label(3);
    file.end_list();
  };
  EXPECT_EQ(refusal(head + "3(0 1 2)", list), "");
  EXPECT_EQ(refusal(head + "/*/ 9(7) */ 3(0 1 2)", list), "");
  EXPECT_THAT(refusal(head + "2\n(0\nx)", list), HasSubstr("a:4: "));
  EXPECT_THAT(refusal(head + "2\n(0\n3)", list), HasSubstr("a:4: the number 3 is not below 3"));
  EXPECT_THAT(refusal(head + "2\n(0\n-1)", list), HasSubstr("a:4: "));
  EXPECT_THAT(refusal(head + "2\n(0 1 2)", list), HasSubstr("expected ), found \"2\""));
  EXPECT_THAT(refusal(head + "2\n(0 1", list), HasSubstr("ends too early"));
  EXPECT_THAT(refusal(head + "99999999999\n(0 1", list), HasSubstr("a:2: a count of 99999999999"));
  EXPECT_THAT(refusal(head + "-1\n(0 1", list), HasSubstr("a count of -1"));
  EXPECT_THAT(refusal(head + "1(0) /* ",
                      [](FoamText& file) {
                        while (true) file.token();
                      }),
              HasSubstr("a comment has no end"));
}

}  // namespace
}  // namespace tetfarm
