#include "worker/task_environment.h"

#include <gmock/gmock.h>

#include "base/child_process.h"

namespace tetfarm {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> environment_from(const std::vector<std::string>& words) {
  return task_environment(exec_arguments(words).data());
}

TEST(TaskEnvironment, is_the_workers_with_large_pages_asked_for) {
  EXPECT_THAT(environment_from({"HOME=/home/a", "PATH=/bin"}),
              ElementsAre("HOME=/home/a", "PATH=/bin", "GLIBC_TUNABLES=glibc.malloc.hugetlb=1"));
}

TEST(TaskEnvironment, keeps_what_was_tuned_already) {
  EXPECT_THAT(environment_from({"GLIBC_TUNABLES=glibc.malloc.arena_max=1"}),
              ElementsAre("GLIBC_TUNABLES=glibc.malloc.arena_max=1:glibc.malloc.hugetlb=1"));
  EXPECT_THAT(environment_from({"GLIBC_TUNABLES=glibc.malloc.hugetlb=0"}),
              ElementsAre("GLIBC_TUNABLES=glibc.malloc.hugetlb=0"));
}

}  // namespace
}  // namespace tetfarm
