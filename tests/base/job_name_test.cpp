#include "base/job_name.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::HasSubstr;

TEST(JobName, may_be_what_a_file_may_be_called) {
  for (const std::string& name :
       {std::string("wing"), std::string("a b.c-d_e"), std::string("Flügel 2 €"),
        std::string("..."), std::string("-rf"), std::string(255, 'n')}) {
    EXPECT_EQ(problem_with_job_name(name), "") << name;
  }
}

TEST(JobName, leads_nowhere_and_steers_nothing) {
  EXPECT_THAT(problem_with_job_name(""), HasSubstr("empty"));
  EXPECT_THAT(problem_with_job_name("../../x"), HasSubstr("`/`"));
  EXPECT_THAT(problem_with_job_name("."), HasSubstr("folders"));
  EXPECT_THAT(problem_with_job_name(".."), HasSubstr("folders"));
  EXPECT_THAT(problem_with_job_name("a\nb"), HasSubstr("control"));
  EXPECT_THAT(problem_with_job_name("\x1b[2J"), HasSubstr("control"));
  EXPECT_THAT(problem_with_job_name(std::string("a\0b", 3)), HasSubstr("control"));
  EXPECT_THAT(problem_with_job_name("a\u202eb"), HasSubstr("control"));
  EXPECT_THAT(problem_with_job_name("\xff"), HasSubstr("UTF-8"));
  EXPECT_THAT(problem_with_job_name(std::string(256, 'n')), HasSubstr("255 bytes, not 256"));
}

TEST(JobName, gives_file_names_that_file_systems_take) {
  EXPECT_EQ(file_name_of_job("wing", ".vtkhdf"), "wing.vtkhdf");
  const std::string longest = file_name_of_job(std::string(255, 'n'), ".vtkhdf");
  EXPECT_EQ(longest.size(), 255U);
  EXPECT_TRUE(longest.ends_with("nnn.vtkhdf"));
  EXPECT_EQ(file_name_of_job(std::string(247, 'n') + "é", ".vtkhdf"),
            std::string(247, 'n') + ".vtkhdf");
}

TEST(JobName, is_refused_in_whole_words) {
  EXPECT_EQ(problem_with_job_name(""), "must not be empty");
  EXPECT_EQ(problem_with_job_name(std::string(256, 'n')), "must have at most 255 bytes, not 256");
  EXPECT_EQ(problem_with_job_name("\xff"), "must be valid UTF-8");
  EXPECT_EQ(problem_with_job_name("a\tb"), "must not contain control characters");
  EXPECT_EQ(problem_with_job_name("a/b"), "must be a plain name, without `/`");
  EXPECT_EQ(problem_with_job_name("."), "must not be `.` or `..`, which are folders");
  EXPECT_EQ(problem_with_job_name("wing\u2028"), "must not contain control characters")
      << "at the end too";
  EXPECT_EQ(problem_with_job_name("a.."), "");
}

}  // namespace
}  // namespace tetfarm
