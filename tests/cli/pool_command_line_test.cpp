#include "cli/pool_command_line.h"

#include <gmock/gmock.h>

#include "tests/cli/parsed.h"

namespace tetfarm {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class PoolCommandLine : public PlainEnvironment {
 protected:
  static std::vector<std::string> words_with(const std::vector<std::string>& more) {
    std::vector<std::string> words = {"pool", "slurm", "--connect", "tcp://h:1", "--max", "3"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  static PoolCommand with(const std::vector<std::string>& more) {
    return parsed_as<PoolCommand>(words_with(more));
  }
};

TEST_F(PoolCommandLine, a_pool_has_defaults_for_what_is_not_said) {
  const PoolCommand pool = with({});
  EXPECT_EQ(pool.system, "slurm");
  EXPECT_EQ(pool.endpoint, "tcp://h:1");
  EXPECT_EQ(pool.keys.own + pool.keys.coordinator + pool.worker_key, "");
  EXPECT_EQ(pool.store + pool.cache + pool.name + pool.program, "");
  EXPECT_EQ(pool.logs, ".");
  EXPECT_EQ(pool.min, 0U);
  EXPECT_EQ(pool.max, 3U);
  EXPECT_EQ(pool.memory_bytes, std::uint64_t{4} << 30U);
  EXPECT_EQ(pool.max_memory_bytes, 0U);
  EXPECT_EQ(pool.walltime_s, 8 * 3600);
  EXPECT_EQ(pool.grace_s, 60);
  EXPECT_EQ(pool.idle_s, 120);
  EXPECT_EQ(pool.interval_s, 5);
  EXPECT_EQ(pool.rate, 60U);
  EXPECT_TRUE(pool.options.empty());
  EXPECT_TRUE(pool.hosts.empty());
  EXPECT_FALSE(pool.solvers || pool.dry_run || pool.stop || pool.json);
}

TEST_F(PoolCommandLine, a_pool_takes_each_of_its_options) {
  const PoolCommand pool = with({"--key",        "p.key",     "--coordinator-key",
                                 "c.pub",        "--name",    "night",
                                 "--store",      "/farm",     "--program",
                                 "/bin/tetfarm", "--logs",    "/logs",
                                 "--grace",      "0",         "--hosts",
                                 "a:2,b",        "--min",     "1",
                                 "--idle",       "0.5",       "--interval",
                                 "0.1",          "--rate",    "7",
                                 "--stop",       "--solvers", "--json"});
  EXPECT_EQ(pool.keys.own, "p.key");
  EXPECT_EQ(pool.keys.coordinator, "c.pub");
  EXPECT_EQ(pool.name, "night");
  EXPECT_EQ(pool.store, "/farm");
  EXPECT_EQ(pool.program, "/bin/tetfarm");
  EXPECT_EQ(pool.logs, "/logs");
  EXPECT_EQ(pool.grace_s, 0);
  EXPECT_THAT(pool.hosts, ElementsAre("a:2", "b"));
  EXPECT_EQ(pool.min, 1U);
  EXPECT_EQ(pool.idle_s, 0.5);
  EXPECT_EQ(pool.interval_s, 0.1);
  EXPECT_EQ(pool.rate, 7U);
  EXPECT_TRUE(pool.solvers);
  EXPECT_TRUE(pool.stop);
  EXPECT_TRUE(pool.json);
  EXPECT_FALSE(pool.dry_run);
}

TEST_F(PoolCommandLine, a_time_limit_may_be_hours_minutes_and_seconds_or_less) {
  EXPECT_EQ(with({"--walltime", "8:00:00"}).walltime_s, 8 * 3600);
  EXPECT_EQ(with({"--walltime", "1:02:03"}).walltime_s, 3723);
  EXPECT_EQ(with({"--walltime", "90:00"}).walltime_s, 5400);
  EXPECT_EQ(with({"--walltime", "28800"}).walltime_s, 28'800);
}

TEST_F(PoolCommandLine, every_batch_system_can_be_named) {
  for (const char* system : {"slurm", "condor", "lsf", "ge", "ssh", "local"}) {
    EXPECT_EQ(
        parsed_as<PoolCommand>({"pool", system, "--coordinator", "tcp://h:1", "--max", "1"}).system,
        system);
  }
}

TEST_F(PoolCommandLine, what_cannot_be_is_refused) {
  const std::string whole = ": must be a whole number from ";
  expect_refused({
      {{"pool", "slurm", "--connect", "tcp://h:1"}, "--max is required"},
      {{"pool", "slurm", "--max", "3"}, "--coordinator is required"},
      {{"pool", "--connect", "tcp://h:1", "--max", "3"}, "SYSTEM is required"},
      {words_with({"--walltime", "soon"}), "--walltime: must be a time such as 8:00:00, not soon"},
      {words_with({"--walltime", "1:-2:3"}),
       "--walltime: must be a time such as 8:00:00, not 1:-2:3"},
      {words_with({"--walltime", "99999999999"}),
       "--walltime: must be a time such as 8:00:00, not 99999999999"},
      {words_with({"--walltime", "0:00"}), "--walltime: must be a whole number above 0, not 0"},
      {words_with({"--grace", "-1"}), "--grace" + whole + "0 to 86400, not -1"},
      {words_with({"--grace", "86401"}), "--grace" + whole + "0 to 86400, not 86401"},
      {words_with({"--min", "100001"}), "--min" + whole + "0 to 100000, not 100001"},
      {words_with({"--rate", "0"}), "--rate" + whole + "1 to 100000, not 0"},
      {words_with({"--idle", "-1"}), "--idle: must be a number, 0 or above, not -1"},
      {words_with({"--interval", "0"}), "--interval: must be a number from 0.1 to 3600, not 0"},
      {words_with({"--stop", "--dry-run"}), "--dry-run excludes --stop"},
      {{"pool", "slurm", "--connect", "tcp://h:1", "--max", "0"},
       "--max" + whole + "1 to 100000, not 0"},
  });
}

TEST_F(PoolCommandLine, help_tells_the_defaults) {
  EXPECT_THAT(
      help_words({"pool"}),
      AllOf(HasSubstr("worker's job (default 4GB)"), HasSubstr("worker's job (default 8:00:00)"),
            HasSubstr("a worker is ended (default 60)"), HasSubstr("this long (default 120)"),
            HasSubstr("the batch system (default 5)"), HasSubstr("per minute (default 60)"),
            HasSubstr("even without work (default 0)")));
}

}  // namespace
}  // namespace tetfarm
