#include "mesh/formats/input_scanner.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "base/error.h"

namespace tetfarm {
namespace {

const std::string file_name = "a.txt";

/// What scanning the text throws.
std::string failure(const std::string& text, const std::function<void(InputScanner&)>& scan,
                    char comment = '\0') {
  InputScanner in(text, file_name, comment);
  try {
    scan(in);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(InputScanner, reads_words_over_lines_and_within_one) {
  const std::string text =
      "\xef\xbb\xbf  one\ttwo\r\nthree \\\n four\\five \\\r\nsix\nseven  eight \n\n";
  InputScanner in(text, file_name);
  EXPECT_EQ(in.word(), "one");
  EXPECT_EQ(in.word_in_line(), "two");
  EXPECT_EQ(in.word_in_line(), "") << "the line has ended";
  EXPECT_EQ(in.word_in_line(), "") << "and stays so";
  EXPECT_EQ(in.word(), "three");
  EXPECT_EQ(in.word_in_line(), "four\\five") << "a line that goes on";
  EXPECT_EQ(in.word_in_line(), "six");
  EXPECT_EQ(in.rest_of_line(), "");
  EXPECT_EQ(in.rest_of_line(), "seven  eight");
  EXPECT_EQ(in.bytes_left(), 1U);
  EXPECT_FALSE(InputScanner(" x", file_name).at_end());
  EXPECT_TRUE(in.at_end());
  EXPECT_EQ(in.word(), "");
}

TEST(InputScanner, passes_over_comments_where_there_are_any) {
  const std::string text = "# first\n1 # one\n #\n2";
  InputScanner in(text, file_name, '#');
  EXPECT_EQ(in.word(), "1");
  EXPECT_EQ(in.word_in_line(), "");
  EXPECT_EQ(in.word(), "2");
  InputScanner without(text, file_name);
  EXPECT_EQ(without.word(), "#");
  const std::string ends = "1 # end";
  InputScanner last(ends, file_name, '#');
  last.word();
  EXPECT_TRUE(last.at_end());
}

TEST(InputScanner, reads_numbers_with_and_without_a_plus) {
  const std::string text = "+1.5 -2e3 1e-400 +7 -8 9223372036854775807";
  InputScanner in(text, file_name);
  EXPECT_EQ(in.coordinate(), 1.5);
  EXPECT_EQ(in.coordinate_in_line(), -2000);
  EXPECT_EQ(in.coordinate(), 0) << "too small is as good as zero";
  EXPECT_EQ(in.integer("a number"), 7);
  EXPECT_EQ(in.integer("a number"), -8);
  EXPECT_EQ(in.integer("a number"), std::numeric_limits<std::int64_t>::max());
}

TEST(InputScanner, says_what_it_expected_instead_of_what_is_there) {
  const auto coordinate = [](InputScanner& in) { in.coordinate(); };
  const auto integer = [](InputScanner& in) { in.integer("a node number"); };
  EXPECT_EQ(failure("\n x", coordinate), "a.txt:2: expected a coordinate, found \"x\"");
  EXPECT_EQ(failure("1.5x", coordinate), "a.txt:1: expected a coordinate, found \"1.5x\"");
  EXPECT_EQ(failure("+-1", coordinate), "a.txt:1: expected a coordinate, found \"+-1\"");
  EXPECT_EQ(failure("+", coordinate), "a.txt:1: expected a coordinate, found \"+\"");
  EXPECT_EQ(failure("1e400", coordinate), "a.txt:1: the coordinate \"1e400\" is too large");
  EXPECT_EQ(failure("-inf", coordinate), "a.txt:1: a coordinate is -inf");
  EXPECT_EQ(failure("1\n1.5", [](InputScanner& in) { in.word(), in.integer("a node number"); }),
            "a.txt:2: expected a node number, found \"1.5\"");
  EXPECT_EQ(failure("9223372036854775808", integer),
            "a.txt:1: expected a node number, found \"9223372036854775808\"");
  EXPECT_EQ(failure("", integer), "a.txt:1: expected a node number, found nothing");
  EXPECT_EQ(failure("ofl", [](InputScanner& in) { in.expect("OFF"); }),
            "a.txt:1: expected OFF, found \"ofl\"");
  EXPECT_EQ(failure("OFF", [](InputScanner& in) { in.expect("OFF"); }), "");
}

TEST(InputScanner, believes_no_count_of_more_than_the_rest_of_the_file_can_hold) {
  const auto count = [](std::int64_t value) {
    return failure("x 2345678", [value](InputScanner& in) {
      in.word();
      EXPECT_EQ(in.to_count(value, 4), static_cast<std::size_t>(value));
    });
  };
  EXPECT_EQ(count(0), "");
  EXPECT_EQ(count(2), "");
  EXPECT_EQ(count(3), "a.txt:1: a count of 3, but only 8 bytes left in the file");
  EXPECT_EQ(count(-1), "a.txt:1: a count of -1, but only 8 bytes left in the file");
}

TEST(InputScanner, gives_bytes_for_what_is_binary_and_lines_again_for_text) {
  const std::string bytes("a\n\x01\x00\x00\x00\x00\x00\x00\x02 b", 12);
  InputScanner in(bytes, file_name);
  in.rest_of_line();
  EXPECT_EQ(in.raw<std::int32_t>(), 1);
  EXPECT_EQ(in.raw_turned<std::int32_t>(), 2);
  const auto raw = [](InputScanner& scanner) {
    scanner.skip_bytes(6);
    scanner.raw<double>();
  };
  EXPECT_EQ(failure(bytes, raw), "a.txt: byte 6: the file ends too early");
  EXPECT_EQ(failure(bytes, [](InputScanner& scanner) { scanner.skip_bytes(13); }),
            "a.txt:1: the file ends too early");
  EXPECT_EQ(failure(bytes,
                    [](InputScanner& scanner) {
                      scanner.rest_of_line();
                      scanner.raw<std::int64_t>();
                      scanner.text_again();
                      scanner.expect("c");
                    }),
            "a.txt:2: expected c, found \"b\"");
}

TEST(InputScanner, goes_behind_a_text_that_is_there) {
  const std::string text = "one $End two";
  InputScanner in(text, file_name);
  EXPECT_FALSE(in.skip_past("$Begin"));
  EXPECT_EQ(in.word(), "one") << "and stays where it is when there is none";
  EXPECT_TRUE(in.skip_past("$End"));
  EXPECT_EQ(in.word(), "two");
}

TEST(Quoted, is_short_and_printable) {
  EXPECT_EQ(tetfarm::quoted(""), "nothing");
  EXPECT_EQ(tetfarm::quoted("a b"), "\"a b\"");
  EXPECT_EQ(tetfarm::quoted(std::string("a\nb\x7f\x80~", 6)), "\"a?b??~\"");
  EXPECT_EQ(tetfarm::quoted(std::string(40, 'x')), "\"" + std::string(40, 'x') + "\"");
  EXPECT_EQ(tetfarm::quoted(std::string(41, 'x')), "\"" + std::string(40, 'x') + "…\"");
}

}  // namespace
}  // namespace tetfarm
