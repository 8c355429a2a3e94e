/// What no job may name as its surface, wherever it is found: keys, the database, logs, artifacts
/// and files in the making.
///
/// What is taken as a surface becomes an artifact, which workers read. So a file counts as what it
/// is, by device and inode, and not by the path that led to it: a hard link to a key is the key.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <vector>

namespace tetfarm {

struct ClosedPlaces {
  std::filesystem::path store;               ///< "": none
  std::filesystem::path database;            ///< its folder, "": the store
  std::vector<std::filesystem::path> keys;   ///< folders of keys
  std::vector<std::filesystem::path> files;  ///< single ones besides: a token, say
};

/// Whether that open file is one of them. `real` is its path, without links.
/// Cost: looks at each file of the folders of keys, of the store's own folder, and of those in the
/// making; at the artifacts only where the file has several names.
bool is_closed(const ClosedPlaces& places, const struct stat& file,
               const std::filesystem::path& real);

/// Whether jobs can name nothing in that folder: the store itself, a folder of keys, or a place in
/// the store that is the coordinator's own. @pre `real` is without links.
bool is_closed_folder(const ClosedPlaces& places, const std::filesystem::path& real);

}  // namespace tetfarm
