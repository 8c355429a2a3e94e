#include "worker/machine.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <optional>

#include "base/file_system.h"

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

/// A number of this process's control group (version 2), where it has one.
std::optional<std::int64_t> number_of_group(const std::string& file) {
  std::ifstream groups("/proc/self/cgroup");
  std::string line;
  while (std::getline(groups, line)) {
    if (!line.starts_with("0::")) continue;
    std::ifstream numbers("/sys/fs/cgroup" + line.substr(3) + "/" + file);
    std::string text;
    if (numbers >> text) return whole_number(text);
  }
  return std::nullopt;
}

/// "MemAvailable:    1234 kB"
std::optional<std::uint64_t> kernel_says_available() {
  std::ifstream numbers("/proc/meminfo");
  std::string name;
  std::uint64_t kibibytes = 0;
  std::string unit;
  while (numbers >> name >> kibibytes) {
    std::getline(numbers, unit);
    if (name == "MemAvailable:") return kibibytes << 10U;
  }
  return std::nullopt;
}

}  // namespace

std::uint64_t machine_memory() {
  const auto machine = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                       static_cast<std::uint64_t>(::sysconf(_SC_PAGE_SIZE));
  const std::optional<std::int64_t> group = number_of_group("memory.max");
  return group ? std::min(machine, static_cast<std::uint64_t>(*group)) : machine;
}

std::uint64_t available_memory() {
  const std::uint64_t all = machine_memory();
  const std::uint64_t available = std::min(all, kernel_says_available().value_or(all));
  const std::optional<std::int64_t> limit = number_of_group("memory.max");
  const std::optional<std::int64_t> used = number_of_group("memory.current");
  if (!limit || !used) return available;
  return std::min(available, static_cast<std::uint64_t>(std::max<std::int64_t>(0, *limit - *used)));
}

std::string host_name() {
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  return name.data();
}

std::filesystem::path default_cache_folder() {
  return temporary_folder() / ("tetfarm-cache-" + std::to_string(::geteuid()));
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
