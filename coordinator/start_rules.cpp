#include "coordinator/start_rules.h"

#include <sys/resource.h>

#include <algorithm>

#include "base/error.h"
#include "base/file_system.h"
#include "proto/key_file.h"
#include "proto/keys_folder.h"

namespace tetfarm {

namespace fs = std::filesystem;

namespace {

bool has_key(const fs::path& folder) {
  return size_of_file(secret_key_path(folder, "coordinator")).has_value();
}

fs::path folder_with_key(const KeyPlaces& places) {
  if (!places.wanted.empty()) {
    if (has_key(places.wanted)) return places.wanted;
    throw UsageError(
        "has no coordinator's key; make one with `tetfarm keys new coordinator --keys " +
            places.wanted.string() + "`",
        places.wanted.string());
  }
  const bool is_old = has_key(places.old);
  if (!has_key(places.standard)) return is_old ? places.old : "";
  if (is_old && !fs::equivalent(places.old, places.standard)) {
    throw UsageError("there are keys here and in " + places.old.string() +
                         ", where earlier versions kept them: say with --keys which to use",
                     places.standard.string());
  }
  return places.standard;
}

}  // namespace

fs::path database_folder(const fs::path& store, const fs::path& wanted) {
  return wanted.empty() ? store : wanted;
}

KeysInUse find_keys(const KeyPlaces& places) {
  KeysInUse found;
  found.folder = folder_with_key(places);
  if (found.folder.empty()) {
    found.remark = "no coordinator.key in " + places.standard.string() +
                   (places.old == places.standard ? "" : " or " + places.old.string());
    return found;
  }
  found.remark = "keys of " + found.folder.string();
  if (found.folder != places.wanted && found.folder != places.standard) {
    found.warning = "the keys are in " + found.folder.string() +
                    ", where earlier versions kept them: move that folder to " +
                    places.standard.string() + ", or give it with --keys";
  } else if (const fs::path store = store_round(found.folder); !store.empty()) {
    found.warning = "the keys are in the store " + store.string() +
                    ", which others can access: move that folder out of it";
  }
  return found;
}

fs::path prepared_database(const fs::path& store, const fs::path& wanted,
                           const std::string& probe) {
  const fs::path folder = database_folder(store, wanted);
  if (wanted.empty()) return folder / "tetfarm.db";
  make_folders(folder);
  const fs::path mark = folder / "store_id";
  if (!size_of_file(mark)) write_file_atomically(mark, probe);
  if (read_file(mark) != probe) {
    throw UsageError("this folder holds the database of another store", folder.string());
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
