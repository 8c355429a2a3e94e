#include "cli/pool_rules.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20U;

PoolCommand told_pool() {
  PoolCommand command;
  command.name = "night";
  command.endpoint = "tcp://head:5555";
  command.min = 2;
  command.max = 5;
  command.memory_bytes = 1000 * mebibyte + 7;
  command.max_memory_bytes = 3000 * mebibyte + 7;
  command.grace_s = 30;
  command.idle_s = 1.5;
  command.rate = 11;
  return command;
}

TEST(PoolRules, are_those_of_the_command_line) {
  PoolCommand command = told_pool();
  const PoolRules rules = pool_rules(command);
  EXPECT_EQ(rules.name, "night");
  EXPECT_EQ(rules.min, 2U);
  EXPECT_EQ(rules.max, 5U);
  EXPECT_EQ(rules.least_bytes, 1000 * mebibyte);
  EXPECT_EQ(rules.most_bytes, 3000 * mebibyte);
  EXPECT_EQ(rules.jobs_a_minute, 11U);
  EXPECT_EQ(rules.idle_ms, 1'500);
  EXPECT_EQ(rules.leave_ms, 90'000) << "a minute more than the grace of a task";
  EXPECT_FALSE(rules.stops);
  command.stop = true;
  command.max_memory_bytes = 0;
  EXPECT_TRUE(pool_rules(command).stops);
  EXPECT_EQ(pool_rules(command).most_bytes, 1000 * mebibyte);
}

TEST(PoolRules, of_the_batch_system_are_what_workers_need) {
  PoolCommand command = told_pool();
  command.program = "/opt/tetfarm";
  command.store = "/farm";
  command.cache = "$TMPDIR/x";
  command.worker_key = "/w.key";
  command.keys.coordinator = "/c.pub";
  command.keys.own = "/p.key";
  command.logs = "/logs";
  command.walltime_s = 77;
  command.options = {"-q long"};
  command.hosts = {"a:2"};
  command.solvers = true;
  const PoolSettings settings = pool_settings(command, pool_rules(command));
  EXPECT_EQ(settings.name, "night");
  EXPECT_EQ(settings.program, "/opt/tetfarm");
  EXPECT_EQ(settings.coordinator, "tcp://head:5555");
  EXPECT_EQ(settings.store, "/farm");
  EXPECT_EQ(settings.cache, "$TMPDIR/x") << "as the workers' machines see it";
  EXPECT_EQ(settings.key, "/w.key");
  EXPECT_EQ(settings.coordinator_key, "/c.pub");
  EXPECT_EQ(settings.logs, "/logs");
  EXPECT_EQ(settings.walltime_s, 77);
  EXPECT_EQ(settings.grace_s, 30);
  EXPECT_EQ(settings.most_bytes, 3000 * mebibyte);
  EXPECT_EQ(settings.options, command.options);
  EXPECT_EQ(settings.hosts, command.hosts);
  EXPECT_TRUE(settings.runs_solvers);
  EXPECT_FALSE(settings.user.empty());
}

TEST(PoolRules, of_a_pool_without_key_store_and_cache_have_none) {
  PoolCommand command = told_pool();
  const PoolSettings settings = pool_settings(command, pool_rules(command));
  EXPECT_EQ(settings.store + settings.cache + settings.key + settings.coordinator_key, "");
}

}  // namespace
}  // namespace tetfarm
