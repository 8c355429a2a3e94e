#include "coordinator/decisions/task_reuse.h"

#include <gtest/gtest.h>

#include "coordinator/decisions/task_rows.h"
#include "tasks/decompose_contract.h"
#include "tests/coordinator/fake_task.h"

namespace tetfarm {
namespace {

/// The cut of one sub-domain into so many parts, of whatever job.
DecomposeGiven cut(std::uint64_t left_parts, std::uint64_t right_parts) {
  DecomposeGiven given;
  given.job = without_name(fake_file("job", "settings"));
  given.subdomain = without_name(fake_file("subdomain", "root"));
  given.spacing = without_name(fake_file("spacing", "spacing"));
  given.left_parts = left_parts;
  given.right_parts = right_parts;
  return given;
}

std::string name_of_cut(const DecomposeGiven& given) {
  return work_name(new_task(JobId{1}, 1, given));
}

TEST(TaskReuse, cuts_by_the_same_share_are_the_same_work) {
  EXPECT_EQ(name_of_cut(cut(2, 2)), name_of_cut(cut(8, 8)));
  EXPECT_EQ(name_of_cut(cut(2, 3)), name_of_cut(cut(4, 6)));
  EXPECT_NE(name_of_cut(cut(2, 2)), name_of_cut(cut(2, 3)));
}

TEST(TaskReuse, where_memory_decides_the_parts_count_for_themselves) {
  DecomposeGiven few = cut(2, 2);
  DecomposeGiven many = cut(8, 8);
  few.most_bytes = many.most_bytes = 1'000'000;
  EXPECT_NE(name_of_cut(few), name_of_cut(many));
}

TEST(TaskReuse, a_cut_that_chose_its_parts_serves_for_the_same_number_alone) {
  TaskRow done = new_task(JobId{1}, 1, cut(2, 2));
  done.outputs = {fake_file("left", "l"), fake_file("right", "r")};
  const TaskRow wanted = new_task(JobId{2}, 1, cut(8, 8));
  EXPECT_TRUE(serves(done, wanted));
  done.numbers = {{"left_parts", 3}, {"right_parts", 1}};
  EXPECT_FALSE(serves(done, wanted));
  EXPECT_TRUE(serves(done, new_task(JobId{2}, 1, cut(2, 2))));
}

/// Finished work of older versions is found by it.
TEST(TaskReuse, names_of_work_are_as_they_always_were) {
  DecomposeGiven given = cut(4, 6);
  given.work = 1000;
  const std::string text = "decompose 1\njob " + given.job.hash + "\nsubdomain " +
                           given.subdomain.hash + "\nspacing " + given.spacing.hash +
                           "\nleft_parts=2\nright_parts=3\nwork=1000";
  EXPECT_EQ(name_of_cut(given), hash128(text).hex());
}

}  // namespace
}  // namespace tetfarm
