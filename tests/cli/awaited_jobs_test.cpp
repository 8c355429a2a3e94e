#include "cli/awaited_jobs.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

const std::vector<NamedJob> three_known = {{"job-3", "wing"}, {"job-4", "box"}, {"job-12", "wing"}};

TEST(AwaitedJobs, are_those_that_are_there) {
  EXPECT_EQ(problem_with_awaited("job-3", three_known), "");
  EXPECT_EQ(problem_with_awaited("job-12", three_known), "");
}

TEST(AwaitedJobs, that_are_not_there_are_taken_for_the_newest_of_that_name_or_the_nearest_number) {
  EXPECT_EQ(problem_with_awaited("wing", three_known),
            "no job wing to wait for; did you mean `job-12`?");
  EXPECT_EQ(problem_with_awaited("jbo-4", three_known),
            "no job jbo-4 to wait for; did you mean `job-4`?");
}

TEST(AwaitedJobs, of_a_mistyped_name_are_taken_for_the_newest_of_the_nearest_name) {
  EXPECT_EQ(problem_with_awaited("wnig", three_known),
            "no job wnig to wait for; did you mean `job-12` (wing)?");
  EXPECT_EQ(problem_with_awaited("job-13", {{"job-4", "job-14"}, {"job-12", "wing"}}),
            "no job job-13 to wait for; did you mean `job-12`?")
      << "numbers come before names";
}

TEST(AwaitedJobs, that_are_like_none_are_only_named) {
  EXPECT_EQ(problem_with_awaited("flange", three_known), "no job flange to wait for");
  EXPECT_EQ(problem_with_awaited("job-1", {}), "no job job-1 to wait for");
  EXPECT_EQ(problem_with_awaited("", three_known), "no job  to wait for");
}

}  // namespace
}  // namespace tetfarm
