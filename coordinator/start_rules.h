/// What has to hold before a coordinator starts: where its database lies, which keys it uses, and
/// which addresses only this host can reach.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace tetfarm {

/// Only processes of this host can reach it, and its folder's permissions say which.
bool is_ipc(const std::string& endpoint);

/// Only processes of this host can reach it: ipc and loopback addresses.
bool is_local(const std::string& endpoint);

/// `wanted`, or the store when that is "".
std::filesystem::path database_folder(const std::filesystem::path& store,
                                      const std::filesystem::path& wanted);

/// The folder of keys to use: `wanted`, or "keys" beside the database when the coordinator's key is
/// there, else "". @throws UsageError when `wanted` has no key of a coordinator.
std::filesystem::path keys_in_use(const std::filesystem::path& wanted,
                                  const std::filesystem::path& database_folder);

/// The database's path. A folder of its own is made when it is missing, and bound to the store with
/// that probe. @throws UsageError when it is bound to another store, IoError.
std::filesystem::path prepared_database(const std::filesystem::path& store,
                                        const std::filesystem::path& wanted,
                                        const std::string& probe);

/// Raises this process's limit of open files to `wanted`, or as far as it may.
void allow_open_files(std::size_t wanted);

}  // namespace tetfarm
