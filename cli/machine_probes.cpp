#include "cli/machine_probes.h"

#include <sys/resource.h>
#include <sys/statvfs.h>

#include <cerrno>
#include <limits>
#include <string>

#include "base/error.h"
#include "cli/command_line.h"
#include "cli/transfer_display.h"

namespace tetfarm {
namespace {

constexpr std::uint64_t gib = std::uint64_t{1} << 30U;
constexpr std::uint64_t few_files = 10'000;
constexpr std::uint64_t fewest_open_files = 256;

/// A coordinator asks for twice as many as it takes connections.
std::uint64_t wanted_open_files() { return 2 * CoordinatorCommand{}.max_connections; }

}  // namespace

Finding finding_of_memory(const MemoryOfMachine& machine, std::uint64_t wanted_bytes) {
  Finding finding;
  finding.check = "memory";
  finding.found =
      bytes_text(machine.bytes) + ", " + bytes_text(machine.available_bytes) + " of it available";
  const std::string wanted = bytes_text(wanted_bytes);
  if (wanted_bytes > machine.bytes) {
    finding.verdict = Verdict::problem;
    finding.found += "; a worker is to take " + wanted;
    finding.remedy = "tell workers here to take less: --memory " + bytes_text(machine.bytes);
  } else if (wanted_bytes > machine.available_bytes) {
    finding.verdict = Verdict::warning;
    finding.found += "; a worker is to take " + wanted;
    finding.remedy = "end other programs, or tell workers here to take less with --memory";
  } else if (wanted_bytes == 0 && machine.available_bytes < gib) {
    finding.verdict = Verdict::warning;
    finding.remedy = "end other programs; `tetfarm plan --max-memory` says what small tasks need";
  }
  return finding;
}

Finding finding_of_open_files(std::uint64_t most) {
  Finding finding;
  finding.check = "open files";
  finding.found = "a process may have " + std::to_string(most) + " open";
  if (most >= wanted_open_files()) return finding;
  finding.verdict = most < fewest_open_files ? Verdict::problem : Verdict::warning;
  finding.found += ": a coordinator here has room for " + std::to_string(most / 2) +
                   " connections, not for " + std::to_string(CoordinatorCommand{}.max_connections);
  finding.remedy =
      "raise the hard limit (ulimit -Hn, LimitNOFILE= of systemd) if a farm has more workers and "
      "clients than that, and start `tetfarm coordinator` anew";
  return finding;
}

Finding look_at_open_files() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) {
    throw IoError("cannot tell", "the limit of open files", errno);
  }
  return finding_of_open_files(limit.rlim_max);
}

Finding finding_of_room(const std::filesystem::path& folder, const DiskRoom& room,
                        std::uint64_t free_files) {
  Finding finding;
  finding.check = "disk";
  finding.found = folder.string() + ": ";
  finding.remedy = "make room, or use a folder on another disk";
  if (free_files < few_files) {
    finding.verdict = free_files == 0 ? Verdict::problem : Verdict::warning;
    finding.found += "room for " + std::to_string(free_files) + " more files";
    return finding;
  }
  if (room.total_bytes == 0) {
    finding.found += "the file system does not say how much room it has";
    finding.remedy.clear();
    return finding;
  }
  finding.found += bytes_text(room.free_bytes) + " free of " + bytes_text(room.total_bytes);
  if (!room.has(0)) {
    finding.verdict = Verdict::problem;
    finding.found += ", and " + bytes_text(room.reserve()) + " are left alone";
  } else if (room.free_bytes < gib) {
    finding.verdict = Verdict::warning;
  } else {
    finding.remedy.clear();
  }
  return finding;
}

Finding look_at_room(const std::filesystem::path& folder) {
  struct statvfs about {};
  std::uint64_t free_files = std::numeric_limits<std::uint64_t>::max();
  // Some file systems make room for files as they need it, and say 0 of 0.
  if (::statvfs(folder.c_str(), &about) == 0 && about.f_files > 0) free_files = about.f_favail;
  return finding_of_room(folder, disk_room(folder), free_files);
}

}  // namespace tetfarm
