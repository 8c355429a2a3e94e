#include "cli/command_line.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace tetfarm {
namespace {

Command parse(std::vector<const char*> words) {
  words.insert(words.begin(), "tetfarm");
  return parse_command_line(static_cast<int>(words.size()), words.data());
}

/// The exit code of a command line that leaves nothing to do.
int code_of(const std::vector<const char*>& words) {
  try {
    EXPECT_TRUE(std::holds_alternative<NothingToDo>(parse(words)));
    return 0;
  } catch (const Error& error) {
    return static_cast<int>(error.code());
  }
}

TEST(CommandLine, run_takes_a_surface_and_options) {
  const Command command = parse({"run", "wing.stl", "-o", "d", "-j", "4", "--subdomains", "8",
                                 "--size", "0.5", "--growth", "0.2", "--outer", "box:3", "--format",
                                 "vtkhdf,lb8.ugrid", "--json", "--progress", "none"});
  const auto& run = std::get<RunOptions>(command);
  EXPECT_EQ(run.input, "wing.stl");
  EXPECT_EQ(run.output, "d");
  EXPECT_EQ(run.workers, 4);
  EXPECT_EQ(run.subdomains, 8);
  EXPECT_EQ(run.size, 0.5);
  EXPECT_EQ(run.growth, 0.2);
  EXPECT_EQ(run.outer, "box:3");
  EXPECT_EQ(run.formats, (std::vector<std::string>{"vtkhdf", "lb8.ugrid"}));
  EXPECT_TRUE(run.json);
  EXPECT_EQ(run.progress, ProgressStyle::none);
}

TEST(CommandLine, run_takes_limits_and_a_size_for_the_outer_boundary) {
  const Command command = parse(
      {"run", "a.stl", "--outer", "box", "--outer-size", "0.25", "--max-elements", "5000000"});
  const auto& run = std::get<RunOptions>(command);
  EXPECT_EQ(run.outer_size, 0.25);
  EXPECT_EQ(run.max_elements, 5'000'000);
  EXPECT_FALSE(run.force);
  EXPECT_TRUE(std::get<RunOptions>(parse({"run", "a.stl", "--force"})).force);
  EXPECT_EQ(code_of({"run", "a.stl", "--force", "--max-elements", "5"}), 2);
  EXPECT_EQ(code_of({"run", "a.stl", "--max-elements", "0"}), 2);
  EXPECT_EQ(code_of({"run", "a.stl", "--outer-size", "0"}), 2);
}

TEST(CommandLine, what_is_not_given_is_left_to_the_job_file) {
  const Command command = parse({"run", "job.toml"});
  const auto& run = std::get<RunOptions>(command);
  EXPECT_FALSE(run.subdomains.has_value());
  EXPECT_FALSE(run.size.has_value());
  EXPECT_FALSE(run.outer.has_value());
  EXPECT_TRUE(run.formats.empty());
}

TEST(CommandLine, mistakes_are_usage_errors) {
  EXPECT_EQ(code_of({}), 2);
  EXPECT_EQ(code_of({"runn"}), 2);
  EXPECT_EQ(code_of({"run"}), 2);
  EXPECT_EQ(code_of({"run", "a.stl", "-j", "0"}), 2);
  EXPECT_EQ(code_of({"run", "a.stl", "-j", "many"}), 2);
  EXPECT_EQ(code_of({"run", "a.stl", "--size", "-1"}), 2);
  EXPECT_EQ(code_of({"run", "a.stl", "--subdomains", "0"}), 2);
  EXPECT_EQ(code_of({"run", "a.stl", "--progress", "loud"}), 2);
  EXPECT_EQ(code_of({"run", "a.stl", "b.stl"}), 2);
  EXPECT_EQ(code_of({"run", "a.stl", "--max-memory", "2GiB", "--subdomains", "3"}), 2);
  EXPECT_EQ(code_of({"run", "a.stl", "--max-memory", "2GiB", "--groups", "3"}), 2);
  EXPECT_EQ(code_of({"coordinator", "--store", "s"}), 2);
}

TEST(CommandLine, every_command_has_help) {
  for (const char* name : {"run", "check", "quality", "export", "convert", "shape", "submit",
                           "status", "wait", "cancel", "coordinator", "worker", "pool"}) {
    EXPECT_EQ(code_of({name, "--help"}), 0) << name;
  }
  EXPECT_EQ(code_of({"--help"}), 0);
  EXPECT_EQ(code_of({"--version"}), 0);
}

TEST(CommandLine, a_coordinator_is_insecure_only_when_that_is_asked_for) {
  const auto of = [](std::vector<const char*> words) {
    words.insert(words.begin(), {"coordinator", "--store", "s", "--listen", "tcp://10.0.0.1:1"});
    return std::get<CoordinatorCommand>(parse(words)).insecure;
  };
  EXPECT_FALSE(of({}));
  EXPECT_TRUE(of({"--insecure"}));
}

TEST(CommandLine, the_coordinator_may_be_named_by_the_environment) {
  ::setenv("TETFARM_COORDINATOR", "tcp://head:5555", 1);
  const Command command = parse({"status", "job-7"});
  ::unsetenv("TETFARM_COORDINATOR");
  EXPECT_EQ(std::get<StatusCommand>(command).view.client.endpoint, "tcp://head:5555");
  EXPECT_EQ(std::get<StatusCommand>(command).view.client.job, "job-7");
  EXPECT_EQ(code_of({"wait", "job-7"}), 2);
}

TEST(CommandLine, pool_takes_a_batch_system_and_limits) {
  const Command command =
      parse({"pool",         "slurm",   "--coordinator", "tcp://h:1",     "--max",        "20",
             "--min",        "2",       "--memory",      "8GB",           "--max-memory", "32GB",
             "--walltime",   "1:30:00", "--option",      "--partition=a", "--option",     "-q b",
             "--worker-key", "w.key",   "--cache",       "/scratch",      "--dry-run"});
  const auto& pool = std::get<PoolCommand>(command);
  EXPECT_EQ(pool.system, "slurm");
  EXPECT_EQ(pool.endpoint, "tcp://h:1");
  EXPECT_EQ(pool.store, "") << "files come over the connection";
  EXPECT_EQ(pool.cache, "/scratch");
  EXPECT_EQ(pool.max, 20U);
  EXPECT_EQ(pool.min, 2U);
  EXPECT_EQ(pool.memory_bytes, std::uint64_t{8} << 30U);
  EXPECT_EQ(pool.max_memory_bytes, std::uint64_t{32} << 30U);
  EXPECT_EQ(pool.walltime_s, 5400);
  EXPECT_EQ(pool.options, (std::vector<std::string>{"--partition=a", "-q b"}));
  EXPECT_EQ(pool.worker_key, "w.key");
  EXPECT_TRUE(pool.dry_run);
}

TEST(CommandLine, mistakes_with_pools_are_usage_errors) {
  const auto code = [](std::vector<const char*> words) {
    words.insert(words.begin(), {"pool"});
    return code_of(words);
  };
  EXPECT_EQ(code({"slurm", "--max", "3"}), 2) << "of which coordinator?";
  EXPECT_EQ(code({"slurm", "--connect", "tcp://h:1"}), 2) << "how many?";
  EXPECT_EQ(code({"pbs2", "--connect", "tcp://h:1", "--max", "3"}), 2);
  EXPECT_EQ(code({"slurm", "--connect", "tcp://h:1", "--max", "0"}), 2);
  EXPECT_EQ(code({"slurm", "--connect", "tcp://h:1", "--max", "3", "--walltime", "soon"}), 2);
  EXPECT_EQ(code({"slurm", "--connect", "tcp://h:1", "--max", "3", "--stop", "--dry-run"}), 2);
}

TEST(CommandLine, sizes_may_have_units) {
  const Command command =
      parse({"worker", "--connect", "tcp://h:1", "--store", "s", "--memory-limit", "2GB"});
  EXPECT_EQ(std::get<WorkerCommand>(command).memory_bytes, std::uint64_t{2} << 30);
}

TEST(CommandLine, run_and_check_take_what_remeshes_the_surface) {
  const Command run = parse({"run", "a.stl", "--remesh", "--size-on-body", "0.01"});
  EXPECT_TRUE(std::get<RunOptions>(run).remesh);
  EXPECT_EQ(std::get<RunOptions>(run).size_on_body, 0.01);
  const Command check = parse({"check", "a.stl", "--remesh", "--size-on-body", "2"});
  EXPECT_TRUE(std::get<CheckOptions>(check).remesh);
  EXPECT_EQ(std::get<CheckOptions>(check).size_on_body, 2);
  EXPECT_EQ(code_of({"run", "a.stl", "--remesh", "--size-on-body", "-1"}), 2);
  EXPECT_EQ(code_of({"check", "--store", "s", "--remesh"}), 2) << "a store has no surface";
}

}  // namespace
}  // namespace tetfarm
