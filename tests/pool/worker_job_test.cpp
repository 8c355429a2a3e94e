#include "pool/worker_job.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::Optional;

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20U;

PoolSettings night() {
  PoolSettings settings;
  settings.name = "night";
  settings.program = "/opt/tetfarm";
  settings.coordinator = "tcp://head:5555";
  settings.most_bytes = 16384 * mebibyte;
  settings.walltime_s = 3600;
  settings.grace_s = 30;
  return settings;
}

TEST(WorkerJob, has_a_name_that_tells_pool_and_size) {
  EXPECT_EQ(job_name_of(night(), 4096 * mebibyte + 5), "tetfarm-night-4096M");
  EXPECT_THAT(bytes_of_job_name(night(), "tetfarm-night-4096M"), Optional(4096 * mebibyte));
  EXPECT_THAT(bytes_of_job_name(night(), "tetfarm-night-4096M[17]"), Optional(4096 * mebibyte));
  for (const char* other :
       {"", "wing", "tetfarm-day-4096M", "tetfarm-night-4096", "tetfarm-night-M",
        "tetfarm-night-4096G", "tetfarm-night-40x96M", "tetfarm-night-2-4096M",
        "xtetfarm-night-4096M", "tetfarm-night-17592186044416M", "tetfarm-night--1M"}) {
    EXPECT_EQ(bytes_of_job_name(night(), other), std::nullopt) << other;
  }
}

TEST(WorkerJob, tells_its_worker_all_that_it_needs) {
  PoolSettings settings = night();
  EXPECT_THAT(worker_words(settings, 8192 * mebibyte),
              ElementsAre("/opt/tetfarm", "worker", "--connect", "tcp://head:5555",
                          "--no-shared-store", "--memory", "7168MB", "--pool-memory", "14336MB",
                          "--walltime", "3600", "--grace", "30"));
  settings.store = "/farm";
  settings.cache = "/cache";
  settings.key = "w.key";
  settings.coordinator_key = "c.pub";
  EXPECT_THAT(
      worker_words(settings, 8192 * mebibyte),
      ElementsAre("/opt/tetfarm", "worker", "--connect", "tcp://head:5555", "--store", "/farm",
                  "--cache", "/cache", "--key", "w.key", "--coordinator-key", "c.pub", "--memory",
                  "7168MB", "--pool-memory", "14336MB", "--walltime", "3600", "--grace", "30"));
}

TEST(WorkerJob, of_a_pool_for_loops_runs_solvers) {
  PoolSettings settings = night();
  EXPECT_THAT(worker_words(settings, mebibyte), Not(Contains("--solvers")));
  settings.runs_solvers = true;
  EXPECT_THAT(worker_words(settings, mebibyte), Contains("--solvers"));
}

TEST(WorkerJob, has_words_that_a_shell_reads_back) {
  EXPECT_EQ(quoted("/opt/a-b_c+d=e.f:g,h@i%j9"), "/opt/a-b_c+d=e.f:g,h@i%j9");
  EXPECT_EQ(quoted(""), "''");
  EXPECT_EQ(quoted("a b"), "'a b'");
  EXPECT_EQ(quoted("it's"), "'it'\\''s'");
  EXPECT_EQ(quoted("$HOME"), "'$HOME'");
  EXPECT_EQ(shell_line({"run", "a b"}, night(), "${ID}"), "run 'a b' --tag \"night/${ID}\"");
  EXPECT_EQ(script_end(night(), 8192 * mebibyte, "${ID}"),
            "# exec: signals have to reach the worker, not a shell that waits for it.\n"
            "exec /opt/tetfarm worker --connect tcp://head:5555 --no-shared-store --memory 7168MB "
            "--pool-memory 14336MB --walltime 3600 --grace 30 --tag \"night/${ID}\"\n");
}

TEST(WorkerJob, of_an_array_is_counted_from_1) {
  EXPECT_THAT(array_ids("12[", 3, "]"), ElementsAre("12[1]", "12[2]", "12[3]"));
  EXPECT_THAT(array_ids("12_", 0, ""), IsEmpty());
}

TEST(WorkerJob, is_read_from_lines_and_their_parts) {
  EXPECT_THAT(lines_of("a\nb\n\nc"), ElementsAre("a", "b", "", "c"));
  EXPECT_THAT(split("a|b||c", '|'), ElementsAre("a", "b", "", "c"));
  EXPECT_TRUE(is_number("0123456789"));
  for (const char* text : {"", "-1", "1.5", "1x", " 1"}) EXPECT_FALSE(is_number(text)) << text;
  EXPECT_EQ(whole_mebibytes(2 * mebibyte - 1), 1U);
}

}  // namespace
}  // namespace tetfarm
