#include "report/html_text.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(HtmlText, turns_markup_into_text) {
  EXPECT_EQ(escaped("<script>a && 'b' > \"c\"</script>"),
            "&lt;script&gt;a &amp;&amp; &#39;b&#39; &gt; &quot;c&quot;&lt;/script&gt;");
}

TEST(HtmlText, keeps_characters_and_leaves_out_bytes_that_are_none) {
  EXPECT_EQ(escaped("Flügel – 翼"), "Flügel – 翼");
  EXPECT_EQ(escaped(std::string("a\0b\x1b[1mc\xff\xc3(", 11)), "ab[1mc(");
  EXPECT_EQ(escaped("end\xe2\x80"), "end");
  EXPECT_EQ(escaped("slash\xc0\xaf\xc1\x81"), "slash") << "characters of one byte, in two";
}

TEST(HtmlText, base64_is_that_of_the_rfc) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(HtmlText, keeps_characters_of_every_length_and_ends_of_lines) {
  EXPECT_EQ(escaped("a\u00fc\u20ac\U0001F600\n"), "a\u00fc\u20ac\U0001F600\n");
  EXPECT_EQ(escaped("a\x7f\tb"), "ab");
  EXPECT_EQ(escaped("\xf5\x80\x80\x80"), "") << "beyond the last character";
  EXPECT_EQ(escaped("\xf0\x9f\x98x"), "x") << "a character that is cut short";
}

TEST(HtmlText, an_address_holds_the_picture_itself) {
  EXPECT_EQ(png_address("foo"), "data:image/png;base64,Zm9v");
}

TEST(HtmlText, base64_of_every_byte_is_read_back) {
  EXPECT_EQ(base64(std::string("\0\x10\x83\x10\x51\x87\x20\x92\x8b", 9)), "ABCDEFGHIJKL");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
}

}  // namespace
}  // namespace tetfarm
