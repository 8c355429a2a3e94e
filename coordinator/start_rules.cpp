#include "coordinator/start_rules.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/file_system.h"
#include "proto/key_file.h"

namespace tetfarm {

namespace fs = std::filesystem;

bool is_ipc(const std::string& endpoint) {
  return endpoint.starts_with("ipc://") || endpoint.starts_with("inproc://");
}

bool is_local(const std::string& endpoint) {
  constexpr std::array<const char*, 3> loopback = {"tcp://127.",
                                                   "tcp://localhost:", "tcp://[::1]:"};
  return is_ipc(endpoint) || std::any_of(loopback.begin(), loopback.end(), [&](const char* prefix) {
           return endpoint.starts_with(prefix);
         });
}

fs::path database_folder(const fs::path& store, const fs::path& wanted) {
  return wanted.empty() ? store : wanted;
}

fs::path keys_in_use(const fs::path& wanted, const fs::path& database_folder) {
  const fs::path folder = wanted.empty() ? database_folder / "keys" : wanted;
  if (size_of_file(secret_key_path(folder, "coordinator"))) return folder;
  if (wanted.empty()) return {};
  throw UsageError(
      "has no key of a coordinator: tetfarm keys new coordinator --keys " + folder.string(),
      folder.string());
}

fs::path prepared_database(const fs::path& store, const fs::path& wanted,
                           const std::string& probe) {
  const fs::path folder = database_folder(store, wanted);
  if (wanted.empty()) return folder / "tetfarm.db";
  make_folders(folder);
  const fs::path mark = folder / "store_id";
  if (!size_of_file(mark)) write_file_atomically(mark, probe);
  if (read_file(mark) != probe) {
    throw UsageError("this folder has the database of another store", folder.string());
  }
  return folder / "tetfarm.db";
}

void allow_open_files(std::size_t wanted) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = std::max(limit.rlim_cur, std::min<rlim_t>(limit.rlim_max, wanted));
  ::setrlimit(RLIMIT_NOFILE, &limit);
}

}  // namespace tetfarm
