#include "tasks/task_kind.h"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <string>
#include <vector>

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
      {"assimilate", 6}, {"order", 7},     {"extract", 8}, {"cosmetic", 9}, {"write", 10},
      {"grow", 11},      {"solve", 12},    {"adapt", 13},  {"collect", 14}, {"remesh", 15}};
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

std::vector<std::string> kinds_that(bool (*is)(const TaskKindTraits& traits)) {
  std::vector<std::string> names;
  for (const TaskKind kind : all_task_kinds) {
    if (is(traits_of(kind))) names.emplace_back(name_of(kind));
  }
  return names;
}

TEST(TaskKinds, are_treated_as_what_they_do_asks_for) {
  using testing::ElementsAre;
  EXPECT_THAT(kinds_that([](const TaskKindTraits& traits) { return traits.rank == 0; }),
              ElementsAre("decompose", "order", "extract", "cosmetic"))
      << "what others wait for is handed out first";
  EXPECT_THAT(kinds_that([](const TaskKindTraits& traits) { return traits.rank == 1; }),
              ElementsAre("solve", "adapt", "collect", "remesh", "inspect", "assimilate", "mesh",
                          "number", "write", "grow", "assemble"));
  EXPECT_THAT(kinds_that([](const TaskKindTraits& traits) { return traits.shrinks_with_leaf; }),
              ElementsAre("mesh", "extract", "cosmetic"));
  EXPECT_THAT(kinds_that([](const TaskKindTraits& traits) { return traits.needs_whole_tree; }),
              ElementsAre("order", "extract", "cosmetic"));
  EXPECT_THAT(kinds_that([](const TaskKindTraits& traits) { return traits.reads_file_by_file; }),
              ElementsAre("order", "assemble"));
  EXPECT_THAT(kinds_that([](const TaskKindTraits& traits) { return traits.may_make_nothing; }),
              ElementsAre("decompose"));
  EXPECT_THAT(kinds_that([](const TaskKindTraits& traits) { return traits.is_of_others; }),
              ElementsAre("solve"));
  EXPECT_THAT(kinds_that([](const TaskKindTraits& traits) { return traits.is_of_cycle; }),
              ElementsAre("solve", "adapt"));
  EXPECT_THAT(kinds_that([](const TaskKindTraits& traits) { return traits.begins_job; }),
              ElementsAre("solve", "remesh", "inspect"));
  EXPECT_THAT(kinds_that([](const TaskKindTraits& traits) { return traits.ends_job; }),
              ElementsAre("collect", "assemble"));
}

TEST(TaskKinds, have_the_outputs_that_every_result_has) {
  const auto outputs = [](TaskKind kind) {
    std::string names;
    for (const std::string_view name : traits_of(kind).outputs) {
      if (!name.empty()) names += (names.empty() ? "" : " ") + std::string(name);
    }
    return names;
  };
  EXPECT_EQ(outputs(TaskKind::remesh), "surface");
  EXPECT_EQ(outputs(TaskKind::inspect), "surface spacing root settings");
  EXPECT_EQ(outputs(TaskKind::decompose), "left right");
  EXPECT_EQ(outputs(TaskKind::assimilate), "dropped");
  EXPECT_EQ(outputs(TaskKind::mesh), "mesh");
  EXPECT_EQ(outputs(TaskKind::order), "shared:");
  EXPECT_EQ(outputs(TaskKind::extract), "elements");
  EXPECT_EQ(outputs(TaskKind::cosmetic), "elements");
  EXPECT_EQ(outputs(TaskKind::number), "numbering");
  EXPECT_EQ(outputs(TaskKind::write), "portion tets");
  EXPECT_EQ(outputs(TaskKind::grow), "portion cells");
  EXPECT_EQ(outputs(TaskKind::assemble), "");
  EXPECT_EQ(outputs(TaskKind::solve), "solution log");
  EXPECT_EQ(outputs(TaskKind::adapt), "mesh start figures");
  EXPECT_EQ(outputs(TaskKind::collect), "");
}

/// As they were measured: docs/decisions/0012 and 0024. A bound of memory that is too low ends
/// tasks, a time that is wrong misleads people.
TEST(TaskKinds, cost_what_was_measured) {
  struct Costs {
    TaskKind kind;
    std::array<double, 4> seconds;  // fixed, of an element, a triangle, a needle
    std::array<double, 6> bytes;    // fixed, of an input byte, a spacing byte, an element, a
                                    // triangle, one of the largest group
  };
  for (const Costs& costs : std::initializer_list<Costs>{
           {TaskKind::remesh, {0.006, 0, 150e-6, 0}, {8e6, 1.2, 0, 0, 600, 0}},
           {TaskKind::inspect, {0.006, 0.15e-6, 7e-6, 0}, {8e6, 1.2, 2.5, 0, 220, 0}},
           {TaskKind::decompose, {0.02, 0.1e-6, 1e-6, 0.15e-3}, {13e6, 0, 1, 1, 260, 0}},
           {TaskKind::assimilate, {0.01, 0, 1.5e-6, 0}, {0, 0, 0, 0, 8, 500}},
           {TaskKind::mesh, {0.006, 1.8e-6, 8e-6, 0.45e-3}, {2e6, 0, 1, 330, 700, 0}},
           {TaskKind::order, {0.006, 0, 0.3e-6, 0}, {0, 0, 0, 0, 32, 200}},
           {TaskKind::extract, {0.006, 0.1e-6, 0, 0}, {0, 0, 0, 190, 200, 0}},
           {TaskKind::cosmetic, {0.006, 3e-6, 0, 0}, {4e6, 0, 1, 360, 0, 0}},
           {TaskKind::number, {0.003, 0, 0.45e-6, 0}, {0, 0, 0, 0, 110, 0}},
           {TaskKind::write, {0.006, 0.3e-6, 0, 0}, {4e6, 0, 0, 150, 0, 0}},
           {TaskKind::grow, {0.006, 0.8e-6, 0, 0}, {4e6, 0, 0, 200, 0, 0}},
           {TaskKind::assemble, {0.006, 0.02e-6, 0.4e-6, 0}, {4e6, 0, 0, 130, 250, 0}},
           {TaskKind::solve, {60, 0, 0, 0}, {256e6, 0, 0, 0, 0, 0}},
           {TaskKind::adapt, {0.5, 0, 0, 0}, {32e6, 20, 0, 0, 0, 0}},
           {TaskKind::collect, {0.05, 0, 0, 0}, {16e6, 2, 0, 0, 0, 0}}}) {
    const TaskKindTraits& traits = traits_of(costs.kind);
    const TaskMemory& memory = traits.memory;
    EXPECT_EQ(traits.seconds.of, costs.seconds) << traits.name;
    EXPECT_EQ((std::array{memory.fixed, memory.of_input_byte, memory.of_spacing_byte,
                          memory.of_element, memory.of_triangle, memory.of_triangle_of_largest}),
              costs.bytes)
        << traits.name;
    const std::array<double, 4> usual = {0.4, 0.4, 0.4, 0.55};
    const std::array<double, 4> expected =
        costs.kind == TaskKind::decompose  ? std::array{0.5, 0.5, 0.5, 0.8}
        : costs.kind == TaskKind::cosmetic ? std::array{0.4, 0.9, 0.4, 0.55}
                                           : usual;
    EXPECT_EQ(traits.seconds.spreads, expected) << traits.name;
  }
}

TEST(TaskKinds, are_drawn_in_colours_of_their_own) {
  std::set<std::string> colours;
  for (const TaskKind kind : all_task_kinds) colours.insert(traits_of(kind).colour);
  EXPECT_EQ(colours.size(), all_task_kinds.size());
}

TEST(FailureCauses, keep_the_numbers_that_they_were_given) {
  EXPECT_EQ(on_wire(FailureCause::for_good), 1U);
  EXPECT_EQ(on_wire(FailureCause::error), 2U);
  EXPECT_EQ(on_wire(FailureCause::killed), 3U);
  EXPECT_EQ(on_wire(FailureCause::out_of_memory), 4U);
  EXPECT_EQ(on_wire(FailureCause::disk_full), 5U);
  EXPECT_EQ(on_wire(FailureCause::damaged_input), 6U);
}

}  // namespace
}  // namespace tetfarm
