#include "worker/job_forecast.h"
#include "tests/support/error_text.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

/// What a job of the unit cube comes to whose sizes are even.
double elements_of_cube(double size) { return 8.5 / (size * size * size); }

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
  EXPECT_EQ(error_text_of([&] { require_few_elements(job, 1.99e9, limits); }), "");
  const std::string said = error_text_of([&] { require_few_elements(job, 7e10, limits); });
  EXPECT_THAT(said, HasSubstr("about 70.0 G elements, more than the 2.0 G that it may have"));
  EXPECT_THAT(said, HasSubstr("`--size 0.0017` would give about 1.7 G"));
  EXPECT_THAT(said, HasSubstr("--force"));
  job.max_elements = 1000;
  EXPECT_THAT(error_text_of([&] { require_few_elements(job, 1001, limits); }),
              HasSubstr("more than the 1.0 k"));
}

TEST(JobForecast, lets_a_forced_job_have_any_number_but_not_more_than_there_can_be) {
  JobFile job;
  job.max_elements = 0;
  const JobLimits limits{1, elements_of_cube, 0};
  EXPECT_EQ(error_text_of([&] { require_few_elements(job, 9e11, limits); }), "");
  EXPECT_THAT(error_text_of([&] { require_few_elements(job, 1e18, limits); }),
              HasSubstr("more than the 1.0 T that any job may have"));
}

TEST(JobForecast, says_when_sizes_are_not_what_is_too_small) {
  JobFile job;
  const JobLimits limits{1, [](double) { return 3e9; }, 0};
  EXPECT_THAT(error_text_of([&] { require_few_elements(job, 3e9, limits); }),
              HasSubstr("no size is large enough"));
}

TEST(JobForecast, refuses_what_the_disk_cannot_hold) {
  JobFile job;
  const SubdomainSize root{1e8, 1e5, 1e6};
  const JobForecast forecast = forecast_of(job, 1e6, root, 50);
  EXPECT_GT(forecast.disk_bytes, 1e8 * 60);
  JobLimits limits{1, elements_of_cube, 1e9};
  const std::string said = error_text_of([&] { require_disk(job, forecast, limits); });
  EXPECT_THAT(said, HasSubstr("of which only 1.0 GB is free"));
  EXPECT_THAT(said, HasSubstr("`--size 0.0"));
  limits.free_bytes = 0;
  EXPECT_EQ(error_text_of([&] { require_disk(job, forecast, limits); }), "") << "not known";
  limits.free_bytes = 2 * forecast.disk_bytes;
  EXPECT_EQ(error_text_of([&] { require_disk(job, forecast, limits); }), "");
  limits.free_bytes = 1e9;
  job.max_elements = 0;
  EXPECT_EQ(error_text_of([&] { require_disk(job, forecast, limits); }), "") << "forced";
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

TEST(JobForecast, needs_less_disk_where_files_go_that_nobody_needs) {
  JobFile job;
  const SubdomainSize root{1e8, 1e5, 1e6};
  const double all = forecast_of(job, 1e6, root, 50).disk_bytes;
  job.keep = "needed";
  EXPECT_NEAR(all - forecast_of(job, 1e6, root, 50).disk_bytes, 1e8 * (67 - 46), 1);
}

TEST(JobForecast, is_the_sum_of_its_tasks_and_the_largest_of_them) {
  JobFile job;
  const SubdomainSize root{8e6, 1e5, 3e6, 80};
  const double triangles = triangles_of_leaves(root, 4);
  const SubdomainSize whole{8e6, triangles_of_leaves(root, 1), 3e6, 80};
  const SubdomainSize half{4e6, triangles_of_leaves(root, 2) / 2, 3e6, 40};
  const SubdomainSize leaf{2e6, triangles / 4, 3e6, 20};
  const double once = inspect_cost(5e6, root).seconds + decompose_cost(whole).seconds +
                      2 * decompose_cost(half).seconds + assemble_cost(1e5, 8e6, leaf).seconds +
                      4 * (mesh_cost(leaf).seconds + write_cost(2e6).seconds);
  job.across_cuts = false;
  const JobForecast plain = forecast_of(job, 5e6, root, 4);
  EXPECT_EQ(plain.elements, 8e6);
  EXPECT_EQ(plain.subdomains, 4);
  EXPECT_NEAR(plain.seconds, once, 1e-9 * once);
  EXPECT_EQ(plain.task_bytes, mesh_cost(leaf).bytes);
  EXPECT_NEAR(plain.disk_bytes, 5e6 + 2 * 3e6 + 250 * triangles + 67 * 8e6, 1e-3);
  job.across_cuts = true;
  const double turns = order_cost(triangles, leaf.triangles).seconds +
                       4 * (extract_cost(2e6, leaf.triangles).seconds +
                            cosmetic_cost(turn_elements(leaf), 3e6).seconds);
  EXPECT_NEAR(forecast_of(job, 5e6, root, 4).seconds, once + turns, 1e-9 * once);
  EXPECT_NEAR(forecast_of(job, 5e6, root, 1).seconds,
              inspect_cost(5e6, root).seconds +
                  assemble_cost(1e5, 8e6, {8e6, triangles_of_leaves(root, 1), 3e6, 80}).seconds +
                  mesh_cost({8e6, triangles_of_leaves(root, 1), 3e6, 80}).seconds +
                  write_cost(8e6).seconds,
              1e-6)
      << "one sub-domain has no turns and no cuts";
}

TEST(JobForecast, has_the_memory_of_whichever_task_is_the_largest) {
  JobFile job;
  const SubdomainSize flat{1e4, 1e6, 1e6};
  EXPECT_EQ(forecast_of(job, 1e9, flat, 1).task_bytes, inspect_cost(1e9, flat).bytes);
  EXPECT_EQ(forecast_of(job, 0, {1e4, 1e6, 9e6}, 1000).task_bytes,
            decompose_cost({1e4, 1e6, 9e6}).bytes);
  const SubdomainSize small{1e5, 1e3, 0};
  const SubdomainSize leaf{1e4, triangles_of_leaves(small, 10) / 10, 0};
  EXPECT_EQ(forecast_of(job, 0, small, 10).task_bytes,
            std::max(leaf_bytes(leaf), decompose_cost(small).bytes));
  const SubdomainSize large{1e10, 1e3, 0};
  const double triangles = triangles_of_leaves(large, 1e6);
  EXPECT_EQ(forecast_of(job, 0, large, 1e6).task_bytes,
            std::max(order_cost(triangles, triangles / 1e6).bytes, decompose_cost(large).bytes));
}

TEST(JobForecast, has_numbers_of_three_digits_at_most_and_fitting_units) {
  struct Case {
    double amount;
    const char* text;
  };
  for (const Case& one : std::initializer_list<Case>{{0, "0"},
                                                     {7.4, "7"},
                                                     {999, "999"},
                                                     {999.4, "999"},
                                                     {999.5, "1.0 k"},
                                                     {1049, "1.0 k"},
                                                     {1051, "1.1 k"},
                                                     {99'940, "99.9 k"},
                                                     {99'960, "100 k"},
                                                     {999'400, "999 k"},
                                                     {999'600, "1.0 M"},
                                                     {2.5e9, "2.5 G"},
                                                     {3e12, "3.0 T"},
                                                     {4e15, "4.0 P"},
                                                     {5e18, "5.0 E"},
                                                     {6e21, "6000 E"}}) {
    EXPECT_EQ(forecast_text({one.amount, 1, 0, 0, 0}),
              "about " + std::string(one.text) +
                  " elements, 0 B of memory per task, 0 B of disk, 0 s on one core");
  }
  for (const auto& [seconds, text] :
       std::initializer_list<std::pair<double, const char*>>{{0.1, "1 s"},
                                                             {5, "5 s"},
                                                             {5.01, "6 s"},
                                                             {119.5, "120 s"},
                                                             {120, "2 min"},
                                                             {7199, "120 min"},
                                                             {7200, "2 h"},
                                                             {172'799, "48 h"},
                                                             {172'800, "2 days"},
                                                             {864'000, "10 days"}}) {
    EXPECT_EQ(forecast_text({1, 1, 0, 0, seconds}),
              "about 1 elements, 0 B of memory per task, 0 B of disk, " + std::string(text) +
                  " on one core");
  }
}

TEST(JobForecast, refuses_in_whole_sentences) {
  JobFile job;
  job.max_elements = 1'000'000;
  const JobLimits limits{1, elements_of_cube, 1e9};
  EXPECT_EQ(error_text_of([&] { require_few_elements(job, 1'000'000, limits); }), "");
  EXPECT_EQ(error_text_of([&] { require_few_elements(job, 2e6, limits); }),
            "spacing: the job would have about 2.0 M elements, more than the 1.0 M that it may "
            "have (`--max-elements` sets the limit, `--force` lifts it); `--size 0.021` would give "
            "about 918 k");
  job.max_elements = 2'000'000'000'000;
  EXPECT_EQ(error_text_of([&] { require_few_elements(job, 1.5e12, limits); }),
            "spacing: the job would have about 1.5 T elements, more than the 1.0 T that any job "
            "may have; `--size 0.00021` would give about 918 G");
  const JobLimits stubborn{1, [](double) { return 3e9; }, 1e9};
  job.max_elements = 1'000'000;
  EXPECT_EQ(error_text_of([&] { require_few_elements(job, 3e9, stubborn); }),
            "spacing: the job would have about 3.0 G elements, more than the 1.0 M that it may "
            "have (`--max-elements` sets the limit, `--force` lifts it); no size is large enough, "
            "because the surface's own edges or the sources ask for more: make them coarser, or "
            "set `[spacing] surface = \"ignore\"` and a size");
  JobForecast forecast;
  forecast.elements = 2e7;
  forecast.disk_bytes = 2e9;
  EXPECT_EQ(error_text_of([&] { require_disk(job, forecast, limits); }),
            "the job would have about 20.0 M elements and need 2.0 GB of disk, of which only 1.0 "
            "GB is free; `--force` starts it anyway; `--size 0.0095` would give about 9.9 M")
      << "half of the elements on half of the disk";
  forecast.disk_bytes = 1e9;
  EXPECT_EQ(error_text_of([&] { require_disk(job, forecast, limits); }), "") << "it just fits";
}

TEST(JobForecast, tries_coarser_sizes_until_one_fits) {
  std::vector<double> tried;
  const auto elements_with = [&tried](double size) {
    tried.push_back(size);
    return size < 0.3 ? 8000.0 : 900.0;
  };
  const auto fitting = fitting_size(1, 1000, elements_with);
  ASSERT_TRUE(fitting);
  // (8.5 / 1000)^(1/3) = 0.204; eight times as many as allowed ask for twice the size.
  EXPECT_THAT(tried, testing::ElementsAre(testing::DoubleEq(0.21), testing::DoubleEq(0.42)));
  EXPECT_EQ(fitting->elements, 900);
  tried.clear();
  EXPECT_FALSE(fitting_size(1, 1000, [&tried](double size) {
    tried.push_back(size);
    return 1000.1;
  }));
  EXPECT_EQ(tried.size(), 8U);
  EXPECT_DOUBLE_EQ(tried[1], 0.22) << "two percent more, rounded up to two digits";
}

}  // namespace
}  // namespace tetfarm
