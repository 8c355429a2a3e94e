#include "tasks/task_kind.h"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <string>

#include "tasks/failure_cause.h"

namespace tetfarm {
namespace {

TEST(TaskKinds, have_names_and_numbers_of_their_own_by_which_they_are_found) {
  std::set<std::string> names;
  std::set<std::uint32_t> numbers;
  for (const TaskKind kind : all_task_kinds) {
    const TaskKindTraits& traits = traits_of(kind);
    EXPECT_TRUE(names.insert(traits.name).second) << traits.name;
    EXPECT_TRUE(numbers.insert(traits.on_wire).second) << traits.name;
    EXPECT_EQ(task_kind_named(traits.name), kind);
    EXPECT_EQ(task_kind_on_wire(traits.on_wire), kind);
    EXPECT_STREQ(name_of(kind), traits.name);
  }
  EXPECT_FALSE(task_kind_named("polish"));
  EXPECT_FALSE(task_kind_named(""));
  EXPECT_FALSE(task_kind_on_wire(0)) << "what is not set";
  EXPECT_FALSE(task_kind_on_wire(4'000'000'000U));
}

/// Both are kept in databases and said between programs of one protocol version.
TEST(TaskKinds, keep_the_names_and_numbers_that_they_were_given) {
  const std::map<std::string, std::uint32_t> given = {
      {"inspect", 1},    {"decompose", 2}, {"mesh", 3},    {"number", 4},   {"assemble", 5},
      {"assimilate", 6}, {"order", 7},     {"extract", 8}, {"cosmetic", 9}, {"write", 10}};
  for (const auto& [name, number] : given) {
    const std::optional<TaskKind> kind = task_kind_named(name);
    ASSERT_TRUE(kind) << name;
    EXPECT_EQ(traits_of(*kind).on_wire, number) << name;
  }
}

TEST(TaskKinds, can_be_drawn_and_are_expected_to_take_time) {
  for (const TaskKind kind : all_task_kinds) {
    const TaskKindTraits& traits = traits_of(kind);
    EXPECT_THAT(traits.colour, testing::MatchesRegex("#[0-9a-f]{6}")) << traits.name;
    EXPECT_STRNE(traits.trace_colour, "") << traits.name;
    EXPECT_GT(traits.seconds.of[0], 0) << traits.name;
    for (const double spread : traits.seconds.spreads) EXPECT_GT(spread, 0) << traits.name;
  }
}

TEST(FailureCauses, are_found_by_their_numbers_and_by_no_others) {
  std::set<std::uint32_t> numbers;
  for (const FailureCause cause : all_failure_causes) {
    EXPECT_TRUE(numbers.insert(on_wire(cause)).second);
    EXPECT_EQ(failure_cause_on_wire(on_wire(cause)), cause);
  }
  EXPECT_FALSE(failure_cause_on_wire(0)) << "what is not set";
  EXPECT_FALSE(failure_cause_on_wire(7));
}

}  // namespace
}  // namespace tetfarm
