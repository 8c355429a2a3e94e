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

}  // namespace
}  // namespace tetfarm
