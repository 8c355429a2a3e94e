#include "mesh/formats/number_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace tetfarm {
namespace {

TEST(NumberText, records_of_text_have_the_length_that_is_told) {
  NumberText numbers = NumberText::text(1234);
  for (const double x : {0.0, -1.2345678901234567e-300, std::numeric_limits<double>::lowest()}) {
    numbers.integer(7);
    numbers.integer(1234);
    numbers.real(x);
    numbers.end_record();
  }
  EXPECT_EQ(numbers.size(), 3 * numbers.record_bytes(2, 1));
  EXPECT_EQ(std::stod(numbers.bytes().substr(10 + 36, 25)), -1.2345678901234567e-300);
}

TEST(NumberText, raw_records_have_eight_bytes_a_number) {
  NumberText numbers = NumberText::raw();
  numbers.integer(7);
  numbers.real(1);
  numbers.end_record();
  EXPECT_EQ(numbers.size(), numbers.record_bytes(1, 1));
}

}  // namespace
}  // namespace tetfarm
