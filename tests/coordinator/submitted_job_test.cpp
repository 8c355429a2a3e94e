#include "coordinator/submitted_job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace tetfarm {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* good_job = "name = \"wing\"\n[geometry]\nsurface = \"a.stl\"\n";

wire::Submit submission(const std::string& job_toml, const std::string& name) {
  wire::Submit submit;
  submit.set_job_toml(job_toml);
  submit.set_name(name);
  return submit;
}

/// Why the coordinator would not take it; "" when it would.
std::string refusal_of(const std::string& job_toml, const std::string& name) {
  try {
    checked_job_name(submission(job_toml, name));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(SubmittedJob, has_the_name_that_it_is_submitted_under_or_that_of_its_job_file) {
  EXPECT_EQ(checked_job_name(submission(good_job, "tail")), "tail");
  EXPECT_EQ(checked_job_name(submission(good_job, "")), "wing");
  EXPECT_EQ(checked_job_name(submission(good_job, std::string(255, 'n'))).size(), 255U);
}

TEST(SubmittedJob, has_no_name_that_leads_elsewhere_or_forges_lines) {
  for (const std::string& name :
       {std::string("../../x"), std::string("."), std::string(".."), std::string("a/b"),
        std::string("a\nb"), std::string("\x1b[2J"), std::string("\xff"), std::string(256, 'n')}) {
    EXPECT_THAT(refusal_of(good_job, name), HasSubstr("the job's name must")) << name;
  }
}

TEST(SubmittedJob, has_a_job_file_that_can_be_read) {
  EXPECT_THAT(refusal_of("spcing = 1", "wing"), StartsWith("job.toml:1:1: unknown key"));
  EXPECT_THAT(refusal_of("", "wing"), HasSubstr("`surface` is missing"));
  EXPECT_THAT(refusal_of("a = [", "wing"), StartsWith("job.toml:1:"));
  std::string key = "a";
  for (int i = 0; i < 120'000; ++i) key += ".a";
  EXPECT_THAT(refusal_of(key + " = 1", "wing"), HasSubstr("job.toml:1:32: a key of more than"));
  EXPECT_THAT(refusal_of(std::string(2'000'000, '\n'), "wing"), HasSubstr("1048576 bytes"));
  EXPECT_THAT(refusal_of(std::string(good_job) + "[spacing]\nsources = \"/etc/passwd\"\n", "wing"),
              HasSubstr("`sources` names a file"));
}

}  // namespace
}  // namespace tetfarm
