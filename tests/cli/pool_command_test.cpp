// What a pool would do, and what it refuses to do, called as main calls it.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <pwd.h>
#include <spdlog/spdlog.h>
#include <sys/file.h>
#include <unistd.h>

#include "cli/commands.h"
#include "tests/cli/fake_coordinator.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

PoolCommand dry_pool() {
  PoolCommand command;
  command.system = "slurm";
  command.endpoint = "tcp://head:5555";
  command.name = "night";
  command.program = "/opt/tetfarm";
  command.store = "/shared/farm";
  command.logs = "/shared/logs";
  command.min = 1;
  command.max = 3;
  command.memory_bytes = std::uint64_t{4} << 30U;
  command.dry_run = true;
  return command;
}

Said pool(const PoolCommand& command) {
  spdlog::drop("tetfarm");  // a program has one pool, and its logger, only once
  return said_by([&] { return pool_command(command); });
}

TEST(PoolCommand, says_what_it_would_submit_and_how_it_would_look) {
  const Said said = pool(dry_pool());
  EXPECT_EQ(said.code, ExitCode::ok);
  EXPECT_THAT(said.out, StartsWith("$ sbatch --parsable <<'end_of_input'\n#!/bin/sh\n"));
  EXPECT_THAT(said.out, HasSubstr("#SBATCH --array=1-3\n"));
  EXPECT_THAT(said.out, HasSubstr("#SBATCH --mem=4096M\n"));
  EXPECT_THAT(said.out, HasSubstr("#SBATCH --time=08:00:00\n"));
  EXPECT_THAT(said.out, HasSubstr("#SBATCH --signal=B:TERM@90\n"));
  EXPECT_THAT(said.out,
              HasSubstr("exec /opt/tetfarm worker --connect tcp://head:5555 --store /shared/farm "
                        "--memory 3584MB --pool-memory 3584MB --walltime 28800 --grace 60 --tag "));
  const passwd* user = ::getpwuid(::geteuid());
  ASSERT_NE(user, nullptr);
  EXPECT_THAT(said.out, EndsWith("\nend_of_input\n$ squeue --noheader --array --user=" +
                                 std::string(user->pw_name) + " '--format=%i|%T|%r|%j'\n"));
}

TEST(PoolCommand, gives_its_workers_what_it_was_told) {
  PoolCommand command = dry_pool();
  command.max_memory_bytes = (std::uint64_t{16} << 30U) + 5;
  command.worker_key = "/keys/w.key";
  command.keys.coordinator = "/keys/c.pub";
  command.keys.own = "/keys/p.key";
  command.cache = "/scratch";
  command.store = "";
  command.walltime_s = 3600;
  command.grace_s = 30;
  command.options = {"--partition=mesh"};
  const std::string out = pool(command).out;
  EXPECT_THAT(out, HasSubstr("#SBATCH --partition=mesh\n"));
  EXPECT_THAT(out,
              HasSubstr("exec /opt/tetfarm worker --connect tcp://head:5555 --no-shared-store "
                        "--cache /scratch --key /keys/w.key --coordinator-key /keys/c.pub "
                        "--memory 3584MB --pool-memory 14336MB --walltime 3600 --grace 30 --tag "
                        "\"night/"));
}

TEST(PoolCommand, makes_paths_whole_and_a_name_from_the_address) {
  PoolCommand command = dry_pool();
  command.name = "";
  command.program = "";
  command.store = "farm/./x";
  command.logs = ".";
  const std::string out = pool(command).out;
  const std::string here = std::filesystem::current_path().string();
  EXPECT_THAT(out, HasSubstr(" --store " + here + "/farm/x "));
  EXPECT_THAT(out, HasSubstr("--output=" + here));
  EXPECT_THAT(out, HasSubstr("exec " + std::filesystem::read_symlink("/proc/self/exe").string()));
  const std::size_t at = out.find("--job-name=tetfarm-") + 19;
  EXPECT_EQ(out.substr(at + 8, 7), "-4096M\n") << "eight digits";
  command.endpoint = "tcp://other:5555";
  EXPECT_THAT(pool(command).out, Not(HasSubstr(out.substr(at, 8))));
}

TEST(PoolCommand, refuses_what_cannot_be) {
  PoolCommand more_than_most = dry_pool();
  more_than_most.min = 4;
  EXPECT_EQ(pool(more_than_most).code, ExitCode::usage);
  EXPECT_EQ(pool(more_than_most).error, "--min: must not be more than --max");
  more_than_most.min = 3;
  EXPECT_EQ(pool(more_than_most).error, "");
  PoolCommand small = dry_pool();
  small.memory_bytes = (std::uint64_t{256} << 20U) - 1;
  EXPECT_EQ(pool(small).error, "--memory: must be at least 256MB");
  small.memory_bytes = std::uint64_t{256} << 20U;
  EXPECT_EQ(pool(small).error, "");
}

TEST(PoolCommand, of_a_farm_with_keys_needs_one_for_its_workers) {
  PoolCommand command = dry_pool();
  command.keys.own = "p.key";
  const Said said = pool(command);
  EXPECT_EQ(said.code, ExitCode::usage);
  EXPECT_EQ(said.error,
            "--worker-key: is missing; the farm uses keys (--key), so its workers need one of "
            "their own");
  EXPECT_EQ(said.help,
            "make one: `tetfarm keys new worker`, `tetfarm keys authorize worker.pub --role worker "
            "--keys DIR`, then --worker-key worker.key");
  command.stop = true;
  EXPECT_EQ(pool(command).error, "") << "who stops starts none";
}

/// One on this machine that has no workers, and is to let all of them go.
PoolCommand pool_that_stops(const std::string& endpoint, const TempFolder& folder) {
  PoolCommand command;
  command.system = "local";
  command.endpoint = endpoint;
  command.name = "test" + std::to_string(::getpid()) + "stops";
  command.logs = (folder.path() / "logs").string();
  command.stop = true;
  return command;
}

TEST(PoolCommand, that_stops_ends_when_its_workers_are_gone) {
  FakeCoordinator coordinator(
      [](const wire::Envelope&) { return std::vector<wire::Envelope>{reply_with({})}; });
  const TempFolder folder;
  const PoolCommand command = pool_that_stops(coordinator.endpoint(), folder);
  EXPECT_EQ(pool(command).code, ExitCode::ok);
  EXPECT_TRUE(std::filesystem::is_directory(command.logs));
  EXPECT_TRUE(coordinator.heard().at(0).status_request().farm_only());
  std::filesystem::remove("/tmp/tetfarm-pool-" + std::to_string(::geteuid()) + "-" + command.name +
                          ".lock");
}

TEST(PoolCommand, is_the_only_one_of_its_name) {
  const TempFolder folder;
  const PoolCommand command = pool_that_stops("ipc:///nobody", folder);
  const std::string lock =
      "/tmp/tetfarm-pool-" + std::to_string(::geteuid()) + "-" + command.name + ".lock";
  const int other = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  ASSERT_GE(other, 0);
  ASSERT_EQ(::flock(other, LOCK_EX | LOCK_NB), 0);
  const Said said = pool(command);
  ::close(other);
  std::filesystem::remove(lock);
  EXPECT_EQ(said.code, ExitCode::failed);
  EXPECT_EQ(said.error, "a pool of that name is already running on this machine: " + command.name);
}

}  // namespace
}  // namespace tetfarm
