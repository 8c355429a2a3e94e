#include "worker/machine.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <optional>

namespace tetfarm {
namespace {

std::optional<std::int64_t> whole_number(const std::string& text) {
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, value);
  // Times after the year 33658 are no times.
  const bool is_good =
      error == std::errc{} && stopped == end && value > 0 && value < 1'000'000'000'000;
  return is_good ? std::optional(value) : std::nullopt;
}

/// The limit of this process's control group (version 2), where it has one.
std::optional<std::int64_t> group_limit() {
  std::ifstream groups("/proc/self/cgroup");
  std::string line;
  while (std::getline(groups, line)) {
    if (!line.starts_with("0::")) continue;
    std::ifstream limit("/sys/fs/cgroup" + line.substr(3) + "/memory.max");
    std::string text;
    if (limit >> text) return whole_number(text);
  }
  return std::nullopt;
}

}  // namespace

std::uint64_t machine_memory() {
  const auto machine = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                       static_cast<std::uint64_t>(::sysconf(_SC_PAGE_SIZE));
  const std::optional<std::int64_t> group = group_limit();
  return group ? std::min(machine, static_cast<std::uint64_t>(*group)) : machine;
}

std::string host_name() {
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  return name.data();
}

std::filesystem::path default_cache_folder() {
  return std::filesystem::temp_directory_path() / ("tetfarm-cache-" + std::to_string(::geteuid()));
}

std::int64_t walltime_left_ms(const Environment& environment, std::int64_t wall_ms) {
  for (const char* name : {"TETFARM_WALLTIME", "PBS_WALLTIME"}) {
    if (const auto seconds = whole_number(environment(name))) return *seconds * 1000;
  }
  if (const auto end = whole_number(environment("SLURM_JOB_END_TIME"))) {
    return std::max<std::int64_t>(1, *end * 1000 - wall_ms);
  }
  return 0;
}

}  // namespace tetfarm
