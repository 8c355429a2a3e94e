#include "mesh/job_file/wave_size.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(ParseFrequency, knows_hertz_and_its_multiples_as_si_writes_them) {
  EXPECT_EQ(parse_frequency("20000"), 20000);
  EXPECT_EQ(parse_frequency("50Hz"), 50);
  EXPECT_EQ(parse_frequency("20kHz"), 2e4);
  EXPECT_EQ(parse_frequency("300 MHz"), 3e8);
  EXPECT_EQ(parse_frequency("1.2GHz"), 1.2e9);
  EXPECT_EQ(parse_frequency("1e-3THz"), 1e9);
}

TEST(ParseFrequency, takes_nothing_else) {
  for (const char* text : {"", "GHz", "1ghz", "1mHz", "1KHz", "1 G", "1GHz ", "1  GHz", " 1GHz",
                           "0", "-1Hz", "nan", "inf", "1e300THz", "1e999", "1 ", "0x10"}) {
    EXPECT_EQ(parse_frequency(text), std::nullopt) << text;
  }
}

TEST(WaveSize, is_the_share_of_the_wavelength) {
  WaveSize wave;
  wave.frequency = 1e9;
  EXPECT_DOUBLE_EQ(wavelength_of(wave), 0.299792458);
  EXPECT_DOUBLE_EQ(size_of(wave), 0.0299792458);
  EXPECT_EQ(wave_size_text(wave), "0.0299792 (10 to a wavelength of 0.299792)");
  wave.per_wavelength = 20;
  EXPECT_DOUBLE_EQ(size_of(wave), 0.0149896229);
  wave.speed *= 1000;  // of a surface in millimetres
  EXPECT_DOUBLE_EQ(size_of(wave), 14.9896229);
  EXPECT_TRUE(has_size(wave));
}

TEST(WaveSize, may_be_none) {
  WaveSize wave;
  EXPECT_FALSE(has_size(wave)) << "no frequency";
  wave.frequency = 1e300;
  wave.per_wavelength = 1e300;
  EXPECT_FALSE(has_size(wave)) << "too small for a number";
}

}  // namespace
}  // namespace tetfarm
