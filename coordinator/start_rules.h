/// What has to hold before a coordinator starts: where its database lies, and which keys it uses.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace tetfarm {

/// `wanted`, or the store when that is "".
std::filesystem::path database_folder(const std::filesystem::path& store,
                                      const std::filesystem::path& wanted);

/// Where keys are looked for.
struct KeyPlaces {
  std::filesystem::path wanted;    ///< "": not said
  std::filesystem::path standard;  ///< see default_keys_folder
  std::filesystem::path old;       ///< beside the database, where earlier versions had them
};

struct KeysInUse {
  std::filesystem::path folder;  ///< "": none, all is plain
  std::string remark;            ///< for the log: where they are, or were looked for
  std::string warning;           ///< that they should lie elsewhere, "": they need not
};

/// The folder with the coordinator's key: `wanted`, else the standard one, else the old one.
/// @throws UsageError when `wanted` has no key of a coordinator, or when both others have one.
KeysInUse find_keys(const KeyPlaces& places);

/// The database's path. A folder of its own is made when it is missing, and bound to the store with
/// that probe. @throws UsageError when it is bound to another store, IoError.
std::filesystem::path prepared_database(const std::filesystem::path& store,
                                        const std::filesystem::path& wanted,
                                        const std::string& probe);

/// Raises this process's limit of open files to `wanted`, or as far as it may.
void allow_open_files(std::size_t wanted);

}  // namespace tetfarm
