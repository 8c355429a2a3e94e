#include "cli/folder_probes.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <system_error>

#include "base/clock.h"
#include "base/error.h"
#include "base/error_with_help.h"
#include "base/file_system.h"
#include "base/ids.h"
#include "store/folder_lock.h"
#include "store/network_file_system.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t slow_ms = 1'000;
constexpr std::int64_t most_apart_ms = 2'000;

/// A name in the folder that nobody else uses; what is there is removed with it.
class TriedFile {
 public:
  explicit TriedFile(const fs::path& folder) : path_(folder / unique_temp_name("doctor")) {}
  ~TriedFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TriedFile(const TriedFile&) = delete;
  TriedFile& operator=(const TriedFile&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void require_folder(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (status.type() == fs::file_type::not_found) {
    throw ErrorWithHelp(ExitCode::not_found, folder.string() + ": is not there",
                        "make the folder, or mount the file system that it lies on");
  }
  if (!fs::is_directory(status)) {
    throw ErrorWithHelp(ExitCode::failed, folder.string() + ": is not a folder",
                        "name a folder that a coordinator or a run may use");
  }
}

/// What is wrong with locks on the file; "": nothing.
std::string trouble_with_locks(const fs::path& path) {
  const std::optional<FolderLock> first = FolderLock::take_unsigned(path);
  if (!first) return "a new file was locked already";
  const std::optional<FolderLock> second = FolderLock::take_unsigned(path);
  return second ? "a file could be locked twice" : "";
}

std::int64_t modified_ms(const fs::path& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) throw IoError("cannot stat", path.string(), errno);
  return std::int64_t{about.st_mtim.tv_sec} * 1'000 + about.st_mtim.tv_nsec / 1'000'000;
}

}  // namespace

Finding look_at_files(const fs::path& folder) {
  require_folder(folder);
  const std::int64_t begun_ms = steady_ms();
  const TriedFile file(folder);
  const std::string text = random_hex(16);
  write_file_atomically(file.path(), text);
  Finding finding;
  finding.check = "files";
  finding.found = folder.string() + ": ";
  const std::string locks = trouble_with_locks(file.path());
  if (read_file(file.path()) != text) {
    finding.verdict = Verdict::problem;
    finding.found += "what was written is not what is read";
    finding.remedy = "use a folder on another file system";
    return finding;
  }
  if (!locks.empty()) {
    finding.verdict = Verdict::problem;
    finding.found += locks;
    finding.remedy = "mount the file system with locks (not with nolock), or use another folder";
    return finding;
  }
  const std::int64_t passed_ms = steady_ms() - begun_ms;
  finding.found += "written, synced, renamed, locked in " + std::to_string(passed_ms) + " ms";
  if (passed_ms < slow_ms) return finding;
  finding.verdict = Verdict::warning;
  finding.remedy = "every result is written so: a faster file system makes a faster farm";
  return finding;
}

Finding finding_of_database(const fs::path& folder, const std::string& kind) {
  Finding finding;
  finding.check = "database";
  if (kind.empty()) {
    finding.found = folder.string() + ": not on a network file system that is known as such";
    return finding;
  }
  finding.verdict = Verdict::problem;
  finding.found = folder.string() + ": on " + kind +
                  ", a network file system, where SQLite cannot keep a database";
  finding.remedy = "keep the database on a disk of this machine: --database DIR";
  return finding;
}

Finding look_at_database(const fs::path& folder) {
  require_folder(folder);
  return finding_of_database(folder, network_file_system_of(folder));
}

Finding finding_of_clock(const std::string& whose, std::int64_t ahead_ms) {
  Finding finding;
  finding.check = "clock";
  const std::int64_t apart_ms = std::abs(ahead_ms);
  if (apart_ms <= most_apart_ms) {
    finding.found = whose + ": as that of this machine";
    return finding;
  }
  finding.verdict = Verdict::warning;
  finding.found = whose + ": " + std::to_string(apart_ms / 1'000) + " s " +
                  (ahead_ms > 0 ? "ahead of" : "behind") + " that of this machine";
  finding.remedy =
      "set both by NTP: times in logs and tables do not agree, and a batch system's "
      "end of a worker is missed by as much";
  return finding;
}

Finding look_at_times_of_files(const fs::path& folder) {
  require_folder(folder);
  const TriedFile file(folder);
  const std::int64_t before_ms = wall_ms();
  write_file_atomically(file.path(), "x");
  const std::int64_t after_ms = wall_ms();
  const std::int64_t time_ms = modified_ms(file.path());
  const std::int64_t nearest_ms =
      std::clamp(time_ms, std::min(before_ms, after_ms), std::max(before_ms, after_ms));
  return finding_of_clock("the clock of files in " + folder.string(), time_ms - nearest_ms);
}

}  // namespace tetfarm
