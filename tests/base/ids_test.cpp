#include "base/ids.h"

#include <gtest/gtest.h>

#include "base/clock.h"

namespace tetfarm {
namespace {

TEST(Ids, job_names_are_read_back) {
  EXPECT_EQ(job_name(JobId{42}), "job-42");
  EXPECT_EQ(parse_job_name("job-42"), JobId{42});
}

TEST(Ids, anything_else_is_no_job) {
  for (const char* text :
       {"", "job-", "job-x", "job-4x", "job-04", "job--4", "42", "job-99999999999999999999999"}) {
    EXPECT_FALSE(parse_job_name(text)) << text;
  }
}

TEST(Ids, random_names_differ) {
  EXPECT_EQ(random_hex(8).size(), 16U);
  EXPECT_NE(random_hex(8), random_hex(8));
}

TEST(Clock, steady_time_does_not_go_back) {
  const std::int64_t before = steady_ms();
  EXPECT_LE(before, steady_ms());
  EXPECT_GT(wall_ms(), 1'600'000'000'000);
}

}  // namespace
}  // namespace tetfarm
