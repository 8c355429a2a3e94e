#include "worker/job_forecast.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

/// What a job of the unit cube comes to whose sizes are even.
double elements_of_cube(double size) { return 8.5 / (size * size * size); }

template <class Refuse>
std::string refusal(const Refuse& refuse) {
  try {
    refuse();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(JobForecast, names_a_size_that_keeps_the_limit_and_is_not_far_from_it) {
  for (const double most : {1e3, 5e6, 2e9, 1e12}) {
    const auto fitting = fitting_size(1, most, elements_of_cube);
    ASSERT_TRUE(fitting);
    EXPECT_LE(elements_of_cube(fitting->size), most);
    EXPECT_GT(elements_of_cube(fitting->size), 0.6 * most) << "two digits are that far apart";
    EXPECT_EQ(fitting->elements, elements_of_cube(fitting->size));
  }
}

TEST(JobForecast, names_no_size_where_none_would_do) {
  EXPECT_FALSE(fitting_size(1, 1e6, [](double) { return 2e6; }));
}

TEST(JobForecast, refuses_more_elements_than_the_job_may_have) {
  JobFile job;
  const JobLimits limits{1, elements_of_cube, 0};
  EXPECT_EQ(refusal([&] { require_few_elements(job, 1.99e9, limits); }), "");
  const std::string said = refusal([&] { require_few_elements(job, 7e10, limits); });
  EXPECT_THAT(said, HasSubstr("about 70.0 G elements, more than the 2.0 G that it may have"));
  EXPECT_THAT(said, HasSubstr("`--size 0.0017` would give about 1.7 G"));
  EXPECT_THAT(said, HasSubstr("--force"));
  job.max_elements = 1000;
  EXPECT_THAT(refusal([&] { require_few_elements(job, 1001, limits); }),
              HasSubstr("more than the 1.0 k"));
}

TEST(JobForecast, lets_a_forced_job_have_any_number_but_not_more_than_there_can_be) {
  JobFile job;
  job.max_elements = 0;
  const JobLimits limits{1, elements_of_cube, 0};
  EXPECT_EQ(refusal([&] { require_few_elements(job, 9e11, limits); }), "");
  EXPECT_THAT(refusal([&] { require_few_elements(job, 1e18, limits); }),
              HasSubstr("more than the 1.0 T that any job may have"));
}

TEST(JobForecast, says_when_sizes_are_not_what_is_too_small) {
  JobFile job;
  const JobLimits limits{1, [](double) { return 3e9; }, 0};
  EXPECT_THAT(refusal([&] { require_few_elements(job, 3e9, limits); }),
              HasSubstr("no size is large enough"));
}

TEST(JobForecast, refuses_what_the_disk_cannot_hold) {
  JobFile job;
  const SubdomainSize root{1e8, 1e5, 1e6};
  const JobForecast forecast = forecast_of(job, 1e6, root, 50);
  EXPECT_GT(forecast.disk_bytes, 1e8 * 60);
  JobLimits limits{1, elements_of_cube, 1e9};
  const std::string said = refusal([&] { require_disk(job, forecast, limits); });
  EXPECT_THAT(said, HasSubstr("of which only 1.0 GB is free"));
  EXPECT_THAT(said, HasSubstr("`--size 0.0"));
  limits.free_bytes = 0;
  EXPECT_EQ(refusal([&] { require_disk(job, forecast, limits); }), "") << "not known";
  limits.free_bytes = 2 * forecast.disk_bytes;
  EXPECT_EQ(refusal([&] { require_disk(job, forecast, limits); }), "");
  limits.free_bytes = 1e9;
  job.max_elements = 0;
  EXPECT_EQ(refusal([&] { require_disk(job, forecast, limits); }), "") << "forced";
}

TEST(JobForecast, grows_with_the_job_and_shrinks_its_tasks_with_sub_domains) {
  const JobFile job;
  const JobForecast small = forecast_of(job, 1e6, {1e6, 1e4, 1e6}, 1);
  const JobForecast large = forecast_of(job, 1e6, {1e7, 1e4, 1e6}, 1);
  const JobForecast divided = forecast_of(job, 1e6, {1e7, 1e4, 1e6}, 8);
  EXPECT_GT(large.seconds, 5 * small.seconds);
  EXPECT_GT(large.disk_bytes, 5 * small.disk_bytes);
  EXPECT_LT(divided.task_bytes, 0.3 * large.task_bytes);
  EXPECT_GE(divided.seconds, large.seconds);
}

TEST(JobForecast, has_one_cut_fewer_than_sub_domains) {
  JobFile job;
  job.across_cuts = false;
  const SubdomainSize root{1e7, 1e5, 1e6};
  const auto part = [&](double parts) {
    return SubdomainSize{root.elements / parts, triangles_of_leaves(root, parts) / parts,
                         root.spacing_bytes, 0};
  };
  const SubdomainSize leaf = part(5);
  const double of_leaves = 5 * (mesh_cost(leaf).seconds + write_cost(leaf.elements).seconds);
  const double once =
      inspect_cost(1e6, root).seconds + assemble_cost(root.triangles, root.elements, leaf).seconds;
  const double of_cuts = decompose_cost(part(1)).seconds + 2 * decompose_cost(part(2)).seconds +
                         decompose_cost(part(4)).seconds;
  EXPECT_NEAR(forecast_of(job, 1e6, root, 5).seconds, once + of_leaves + of_cuts, 1e-6);
}

TEST(JobForecast, is_worded_for_people) {
  EXPECT_EQ(forecast_text({1.234e6, 8, 9e7, 1.3e8, 5.2}),
            "about 1.2 M elements in 8 sub-domains, 90.0 MB of memory per task, 130 MB of disk, "
            "6 s on one core");
  EXPECT_EQ(forecast_text({950, 1, 2.5e7, 1e5, 90'000}),
            "about 950 elements, 25.0 MB of memory per task, 100 kB of disk, 25 h on one core");
}

}  // namespace
}  // namespace tetfarm
