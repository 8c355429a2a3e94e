#include "cli/pool_rules.h"

#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "base/hash.h"

namespace tetfarm {
namespace {

constexpr std::uint64_t mib = std::uint64_t{1} << 20U;

std::string user_name() {
  const passwd* user = ::getpwuid(::geteuid());
  return user == nullptr ? std::to_string(::geteuid()) : user->pw_name;
}

std::string absolute_unless_empty(const std::string& path) {
  return path.empty() ? path : std::filesystem::absolute(path).lexically_normal().string();
}

std::string name_of(const PoolCommand& command) {
  return command.name.empty() ? hash128(command.endpoint).hex().substr(0, 8) : command.name;
}

}  // namespace

PoolRules pool_rules(const PoolCommand& command) {
  PoolRules rules;
  rules.name = name_of(command);
  rules.min = command.min;
  rules.max = command.max;
  rules.least_bytes = command.memory_bytes / mib * mib;
  rules.most_bytes = std::max(rules.least_bytes, command.max_memory_bytes / mib * mib);
  rules.jobs_a_minute = command.rate;
  rules.idle_ms = static_cast<std::int64_t>(command.idle_s * 1000);
  rules.leave_ms = (command.grace_s + 60) * 1000;
  rules.stops = command.stop;
  if (command.min > command.max) throw UsageError("must not be more than --max", "--min");
  if (rules.least_bytes < 256 * mib) throw UsageError("must be at least 256MB", "--memory");
  return rules;
}

PoolSettings pool_settings(const PoolCommand& command, const PoolRules& rules) {
  PoolSettings settings;
  settings.name = rules.name;
  settings.user = user_name();
  settings.program = command.program.empty()
                         ? std::filesystem::read_symlink("/proc/self/exe").string()
                         : command.program;
  settings.coordinator = command.endpoint;
  settings.store = absolute_unless_empty(command.store);
  settings.cache = command.cache;
  settings.key = absolute_unless_empty(command.worker_key);
  settings.coordinator_key = absolute_unless_empty(command.keys.coordinator);
  settings.logs = absolute_unless_empty(command.logs);
  settings.walltime_s = command.walltime_s;
  settings.grace_s = command.grace_s;
  settings.most_bytes = rules.most_bytes;
  settings.options = command.options;
  settings.hosts = command.hosts;
  settings.runs_solvers = command.solvers;
  return settings;
}

}  // namespace tetfarm
