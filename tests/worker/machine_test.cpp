#include "worker/machine.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <map>

namespace tetfarm {
namespace {

std::int64_t left_ms(const std::map<std::string, std::string>& variables, std::int64_t wall_ms) {
  return walltime_left_ms(
      [&variables](const char* name) {
        const auto found = variables.find(name);
        return found == variables.end() ? "" : found->second;
      },
      wall_ms);
}

TEST(WalltimeLeft, is_what_the_batch_system_says) {
  EXPECT_EQ(left_ms({}, 5000), 0);
  EXPECT_EQ(left_ms({{"TETFARM_WALLTIME", "90"}}, 5000), 90'000);
  EXPECT_EQ(left_ms({{"PBS_WALLTIME", "3600"}}, 5000), 3'600'000);
  EXPECT_EQ(left_ms({{"SLURM_JOB_END_TIME", "90"}}, 5000), 85'000) << "a time of the day";
  EXPECT_EQ(left_ms({{"SLURM_JOB_END_TIME", "4"}}, 5000), 1) << "it is over, not unknown";
  EXPECT_EQ(left_ms({{"SLURM_JOB_END_TIME", "5"}}, 5000), 1);
  EXPECT_EQ(left_ms({{"PBS_WALLTIME", "7"}, {"TETFARM_WALLTIME", "8"}}, 0), 8'000);
  EXPECT_EQ(left_ms({{"PBS_WALLTIME", "7"}, {"SLURM_JOB_END_TIME", "9"}}, 0), 7'000);
}

TEST(WalltimeLeft, is_not_known_where_no_number_is_said) {
  for (const char* text : {"", "0", "-5", "x", "5x", " 5", "5 ", "1e3", "1.5", "1000000000000",
                           "99999999999999999999"}) {
    EXPECT_EQ(left_ms({{"TETFARM_WALLTIME", text}}, 0), 0) << text;
    EXPECT_EQ(left_ms({{"SLURM_JOB_END_TIME", text}}, 0), 0) << text;
    EXPECT_EQ(left_ms({{"TETFARM_WALLTIME", text}, {"PBS_WALLTIME", "6"}}, 0), 6000)
        << "the next is asked";
  }
  EXPECT_EQ(left_ms({{"TETFARM_WALLTIME", "999999999999"}}, 0), 999'999'999'999'000);
}

TEST(Machine, has_a_name_and_no_more_memory_than_there_is) {
  char name[256] = {};
  ASSERT_EQ(::gethostname(name, sizeof name - 1), 0);
  EXPECT_EQ(host_name(), name);
  const auto all = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                   static_cast<std::uint64_t>(::sysconf(_SC_PAGE_SIZE));
  EXPECT_LE(machine_memory(), all);
  EXPECT_GT(machine_memory(), 1U << 20U);
}

TEST(Machine, keeps_files_in_a_folder_of_the_user_alone) {
  EXPECT_EQ(default_cache_folder(), std::filesystem::temp_directory_path() /
                                        ("tetfarm-cache-" + std::to_string(::geteuid())));
}

TEST(Machine, has_no_more_memory_available_than_it_has) {
  EXPECT_GT(available_memory(), 0U);
  EXPECT_LE(available_memory(), machine_memory());
}

}  // namespace
}  // namespace tetfarm
