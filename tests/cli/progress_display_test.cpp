#include "cli/progress_display.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(ProgressText, says_stage_subdomains_rate_and_time_left) {
  wire::JobStatus status;
  status.set_stage("mesh");
  status.set_leaves_made(63);
  status.set_leaves_meshed(41);
  status.set_elements(2'000'000);
  status.set_estimated_elements(5e6);
  const std::string text = progress_text(status, 1e5);
  EXPECT_THAT(text, HasSubstr("mesh"));
  EXPECT_THAT(text, HasSubstr("41/63 sub-domains"));
  EXPECT_THAT(text, HasSubstr("2.0M tets"));
  EXPECT_THAT(text, HasSubstr("100.0k tets/s"));
  EXPECT_THAT(text, HasSubstr("eta 00:30"));
}

TEST(ProgressText, leaves_out_what_is_not_known) {
  wire::JobStatus status;
  status.set_stage("inspect");
  const std::string text = progress_text(status, 0);
  EXPECT_THAT(text, Not(HasSubstr("sub-domains")));
  EXPECT_THAT(text, Not(HasSubstr("eta")));
}

TEST(ShortCount, keeps_a_number_short) {
  EXPECT_EQ(short_count(9999), "9999");
  EXPECT_EQ(short_count(12'345), "12.3k");
  EXPECT_EQ(short_count(312.7e6), "312.7M");
  EXPECT_EQ(short_count(1.5e9), "1.50G");
}

TEST(ClockText, shows_hours_only_when_there_are_any) {
  EXPECT_EQ(clock_text(72), "01:12");
  EXPECT_EQ(clock_text(3723), "1:02:03");
}

}  // namespace
}  // namespace tetfarm
